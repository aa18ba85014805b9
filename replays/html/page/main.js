// Part 12: buttons, keys, links and start-up.

const kKeys = [
  ['Space K', 'toggle', 'play or pause'], ['← →', '', '1 s back or forward (Shift: 10 s)'],
  [', .', '', 'one frame back or forward'], ['Home End', '', 'to the start or end'], ['− +', '', 'slower or faster'],
  ['P N', '', 'previous or next event'], ['T', 'trails', 'trails'], ['V', 'vectors', 'velocities'], ['I', 'ids', 'marks and numbers'],
  ['H', 'heat', 'heat map of the ball, a team or the chosen robot'], ['O', 'overlays', 'drawings of the teams, if recorded'],
  ['G', 'ghost', 'the second replay, if there is one'], ['M', 'split', 'races side by side or overlaid'],
  ['[ ]', '', 'previous or next layout'], ['F', 'flip', 'flip sides'], ['D', 'theme', 'dark or light theme'], ['X', 'screen', 'full screen'],
  ['C', 'link', 'copy a link to this moment'], ['S', 'save', 'save a picture'], ['? Esc', 'help', 'this help'],
];

const kKeyActions = {
  ' ': 'toggle', k: 'toggle', ',': 'frameBack', '.': 'frameForward', ArrowLeft: 'back', ArrowRight: 'forward', Home: 'start', End: 'end',
  '-': 'slower', '−': 'slower', '+': 'faster', '=': 'faster', n: 'nextEvent', p: 'previousEvent', t: 'trails', v: 'vectors', i: 'ids',
  h: 'heat', o: 'overlays', g: 'ghost', f: 'flip', d: 'theme', x: 'screen', '?': 'help', c: 'link', s: 'save', m: 'split',
  '[': 'previousScene', ']': 'nextScene', Escape: 'escape', PageUp: 'farForward', PageDown: 'farBack',
};

function toast(text) {
  setText($('#toast'), '');
  setText($('#toast'), text);
  clearTimeout(toast.timer);
  toast.timer = setTimeout(() => setText($('#toast'), ''), 4000);
}

function toggleOption(viewer, name) {
  viewer.options[name] = !viewer.options[name];
  $(`[data-do="${name}"]`).setAttribute('aria-pressed', String(viewer.options[name]));
  viewer.shape();
  viewer.seek(viewer.time);
}

function setTheme(viewer, dark) {
  document.documentElement.dataset.theme = viewer.theme = dark ? 'dark' : 'light';
  $('[data-do="theme"]').setAttribute('aria-pressed', String(dark));
  readColours();
  viewer.stale = true;
  viewer.invalidate();
}

function nextHeat(viewer) {
  const usable = (kind) => kind === 0 || heatBodies(viewer.scene, kHeatKinds[kind], viewer.selected).length > 0;
  do viewer.heatKind = (viewer.heatKind + 1) % kHeatKinds.length;
  while (!usable(viewer.heatKind));
  setText($('#heatkind'), viewer.heatKind ? kHeatKinds[viewer.heatKind] : 'map');
  $('[data-do="heat"]').setAttribute('aria-pressed', String(viewer.heatKind > 0));
  viewer.invalidate();
}

function linkOf(viewer) {
  const scene = viewer.meta.kind === 'races' ? `&scene=${viewer.index}` : '';
  return `#t=${+viewer.time.toFixed(2)}${scene}`;
}

function copyText(text) {
  const old = () => {
    const area = element('textarea', text, { 'aria-hidden': 'true', class: 'unseen' });
    document.body.append(area);
    area.select();
    const copied = document.execCommand('copy');
    area.remove();
    return copied ? Promise.resolve() : Promise.reject(new Error('refused'));
  };
  return navigator.clipboard ? navigator.clipboard.writeText(text).catch(old) : old();
}

function copyLink(viewer) {
  const hash = linkOf(viewer);
  history.replaceState(null, '', hash);
  copyText(location.href).then(() => toast('Link copied'), () => toast(`Add ${hash} to the address`));
}

function followLink(viewer) {
  const wanted = new URLSearchParams(location.hash.slice(1));
  const scene = Number(wanted.get('scene')), time = parseFloat(wanted.get('t'));
  if (viewer.meta.kind === 'races' && Number.isInteger(scene) && scene >= 0 && scene < viewer.meta.scenes.length &&
    scene !== viewer.index) chooseScene(viewer, scene);
  if (!Number.isFinite(time)) return false;
  viewer.setPlaying(false);
  viewer.seek(time);
  return true;
}

/** Saves a picture of the moment, with the score above the field. */
function savePicture(viewer) {
  const { scene, moment } = viewer;
  const width = 1600, strip = 96;
  const { wide, high } = new View(scene.field, 0, 0, 1, 1, false);
  const canvas = element('canvas');
  canvas.width = width;
  canvas.height = Math.round((width * high) / wide) + strip;
  const ctx = canvas.getContext('2d');
  ctx.fillStyle = colours.page;
  ctx.fillRect(0, 0, width, canvas.height);
  ctx.translate(0, strip);
  viewer.paintStage(ctx, 0, 0, width, canvas.height - strip, new FieldLayer());
  ctx.translate(0, -strip);
  ctx.fillStyle = colours.text;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.font = '700 40px system-ui, sans-serif';
  const names = scene.match ? scene.teams.map(shortName) : [];
  const title = scene.match ? `${names[0]}  ${scene.score(moment.tick).join(' – ')}  ${names[1]}` : scene.title;
  ctx.fillText(title, width / 2, strip / 2, width - 400);
  ctx.textAlign = 'right';
  ctx.font = '32px system-ui, sans-serif';
  ctx.fillText(clockText(viewer.time), width - 40, strip / 2);
  canvas.toBlob((blob) => {
    const url = URL.createObjectURL(blob);
    const name = `fulbito-${(scene.match ? names.join('-') : scene.title).replace(/[^\w.-]+/g, '_').slice(0, 60)}`;
    const link = element('a', null, { href: url, download: `${name}-${viewer.time.toFixed(1)}s.png` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
    toast('Picture saved');
  });
}

function toggleScreen() {
  const done = document.fullscreenElement ? document.exitFullscreen() : $('#watch').requestFullscreen && $('#watch').requestFullscreen();
  if (done) done.catch(() => toast('The browser refuses full screen'));
  else toast('This browser does not support full screen');
}

function toggleHelp(open) {
  const help = $('#help');
  const back = document.activeElement;
  help.hidden = open === undefined ? !help.hidden : !open;
  $('#tools [data-do="help"]').setAttribute('aria-expanded', String(!help.hidden));
  if (!help.hidden) {
    help.dataset.back = back && back.dataset.do ? back.dataset.do : '';
    help.focus();
  } else if (help.contains(back)) {
    $('#tools [data-do="help"]').focus();
  }
}

function chooseScene(viewer, index) {
  const count = viewer.meta.scenes.length;
  const to = ((index % count) + count) % count;
  viewer.show(to);
  $('#scene').value = to;
}

function actionsOf(viewer) {
  const jump = (seconds) => () => viewer.seek(viewer.time + seconds);
  const option = (name) => () => toggleOption(viewer, name);
  const scene = (step) => () => viewer.meta.kind === 'races' && chooseScene(viewer, viewer.index + step);
  return {
    toggle: () => viewer.setPlaying(!viewer.playing),
    back: jump(-1), forward: jump(1), farBack: jump(-10), farForward: jump(10),
    frameBack: () => viewer.stepFrame(-1), frameForward: () => viewer.stepFrame(1),
    start: () => viewer.seek(0), end: () => viewer.seek(viewer.scene.seconds),
    slower: () => viewer.setSpeed(-1), faster: () => viewer.setSpeed(1),
    nextEvent: () => viewer.stepEvent(1), previousEvent: () => viewer.stepEvent(-1),
    trails: option('trails'), vectors: option('vectors'), ids: option('ids'), flip: option('flip'),
    overlays: option('overlays'), ghost: option('ghost'), split: option('split'),
    heat: () => nextHeat(viewer), theme: () => setTheme(viewer, viewer.theme !== 'dark'),
    screen: toggleScreen, help: () => toggleHelp(), link: () => copyLink(viewer), save: () => savePicture(viewer),
    previousScene: scene(-1), nextScene: scene(1), part: () => viewer.seek(viewer.parting),
    goalsOnly: () => $('[data-do="goalsOnly"]').setAttribute('aria-pressed', String(viewer.events.goalsOnly())),
    escape: () => ($('#help').hidden ? viewer.selected >= 0 && viewer.select(viewer.selected) : toggleHelp(false)),
  };
}

function listenToKeys(actions) {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const target = event.target;
    if (target.matches('select, textarea, input:not([type="range"])')) return;
    // Space on a button or link triggers that element.
    if (event.key === ' ' && target.matches('button, a')) return;
    // These keys scroll a focused list; elsewhere they move in time.
    if (/^(Page|Home|End)/.test(event.key) && target.matches('.scroll')) return;
    let name = kKeyActions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (event.shiftKey && (name === 'back' || name === 'forward')) name = name === 'back' ? 'farBack' : 'farForward';
    if (!name) return;
    event.preventDefault();
    actions[name]();
  });
}

function listen(viewer) {
  const actions = actionsOf(viewer);
  document.addEventListener('click', (event) => {
    const button = event.target.closest('[data-do]');
    if (button) actions[button.dataset.do]();
  });
  listenToKeys(actions);
  $('#seek').addEventListener('input', (event) => viewer.seek(Number(event.target.value)));
  $('#scene').addEventListener('change', (event) => chooseScene(viewer, Number(event.target.value)));
  viewer.canvas.addEventListener('click', (event) => {
    if (viewer.scene.race && viewer.options.split) return;
    const box = viewer.canvas.getBoundingClientRect(), ratio = viewer.canvas.width / box.width;
    const [x, y] = viewer.view.metres((event.clientX - box.left) * ratio, (event.clientY - box.top) * ratio);
    const near = viewer.scene.robots.map((i) => [Math.hypot(viewer.moment.x[i] - x, viewer.moment.y[i] - y), i])
      .filter(([far, i]) => far < 0.08 && viewer.moment.present[i]).sort((a, b) => a[0] - b[0])[0];
    if (near) viewer.select(near[1]);
  });
  const fit = () => {
    viewer.fit();
    viewer.seek(viewer.time);
  };
  new ResizeObserver(fit).observe(viewer.canvas);
  window.addEventListener('resize', fit);
  window.addEventListener('hashchange', () => followLink(viewer));
  document.addEventListener('fullscreenchange', () => $('[data-do="screen"]').setAttribute('aria-pressed', String(!!document.fullscreenElement)));
  let dark;
  window.addEventListener('beforeprint', () => {
    dark = viewer.theme === 'dark';
    viewer.setPlaying(false);
    setTheme(viewer, false);
    viewer.paint();
  });
  window.addEventListener('afterprint', () => setTheme(viewer, dark));
}

function fillScenes(meta) {
  $('#scenebar').hidden = meta.kind !== 'races';
  $('[data-do="ghost"]').hidden = meta.kind !== 'ghost';
  $('#scene').replaceChildren(...meta.scenes.map((scene, i) => element('option', scene.title, { value: i })));
  const keys = kKeys.flatMap(([keys, , text]) => [element('dt', null, {}, ...keys.split(' ').map((key) => element('kbd', key))),
    element('dd', text)]);
  $('#help dl').replaceChildren(...keys);
}

async function begin() {
  const message = $('#message');
  try {
    const meta = readMeta();
    document.title = `${meta.title} – Fulbito replay`;
    setText(message, 'Unpacking …');
    const viewer = new Viewer(meta, await readPayload(meta.payload));
    fillScenes(meta);
    $('#main').hidden = false;
    setTheme(viewer, matchMedia('(prefers-color-scheme: dark)').matches);
    viewer.show(0);
    listen(viewer);
    message.hidden = true;
    viewer.fit();
    if (!followLink(viewer) && !matchMedia('(prefers-reduced-motion: reduce)').matches) viewer.setPlaying(true);
    window.fulbitoViewer = viewer;
    document.body.dataset.ready = Math.round(performance.now());
  } catch (error) {
    message.hidden = false;
    setText(message, error instanceof BadReplay ? error.message : `The replay cannot be shown: ${error.message}`);
    document.body.dataset.failed = 'true';
    if (!(error instanceof BadReplay)) console.error(error);
  }
}

begin();
