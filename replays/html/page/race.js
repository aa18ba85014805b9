// Part 10: races of navigators on the same layout, overlaid or side by side; and where two replays diverge.

class RaceTable {
  constructor(viewer) {
    this.viewer = viewer;
  }
  fill(scene) {
    $('#runs').hidden = !scene.race;
    this.order = scene.runs.map((_, i) => i).sort((a, b) => {
      const [x, y] = [scene.runs[a], scene.runs[b]];
      return y.success - x.success || x.seconds - y.seconds || a - b;
    });
    this.rows = this.order.map((i) => {
      const run = scene.runs[i];
      const name = element('button', null, { type: 'button', 'aria-pressed': 'false', title: run.label }, element('span', run.label));
      name.addEventListener('click', () => this.viewer.select(i));
      const now = element('td');
      const ratios = [run.timeRatio, run.lengthRatio].map((ratio) => element('td', run.success ? ratio.toFixed(2) : '–'));
      const row = element('tr', null, { class: run.success ? 'good' : 'bad' }, element('td', null, {}, swatch(scene, i)),
        element('td', null, {}, name), now, ...ratios);
      return { row, now, name, i };
    });
    $('#runs tbody').replaceChildren(...this.rows.map(({ row }) => row));
  }
  update(scene, moment, selected) {
    for (const { row, now, name, i } of scene.race ? this.rows : []) {
      const run = scene.runs[i], seconds = moment.tick / scene.rate;
      const over = seconds >= run.seconds;
      row.classList.toggle('over', over);
      name.setAttribute('aria-pressed', String(i === selected));
      setText(now, over ? (run.success ? `${run.seconds.toFixed(2)} s` : words(run.outcome)) : 'driving');
    }
  }
}

/** Columns and lines of a grid that makes panels of this shape large and leaves few cells empty. */
function gridOf(count, width, height, wide, high) {
  const grids = [];
  for (let columns = 1; columns <= count; ++columns) {
    const lines = Math.ceil(count / columns), panel = width / columns;
    const label = Math.min(22, Math.max(11, panel * 0.075));
    const scale = Math.min(panel / wide, (height / lines - label * 1.5) / high);
    grids.push({ scale, columns, label, panel, height: height / lines, empty: columns * lines - count });
  }
  const largest = Math.max(...grids.map((grid) => grid.scale));
  return grids.filter((grid) => grid.scale >= 0.85 * largest).sort((a, b) => a.empty - b.empty || b.scale - a.scale)[0];
}

function paintPanels(ctx, viewer, width, height, layer) {
  const { scene, moment, options } = viewer;
  const obstacles = (i) => scene.bodies[i].kind === 'obstacle';
  const field = new View(scene.field, 0, 0, 1, 1, false);
  const grid = gridOf(scene.runs.length, width, height, field.wide, field.high);
  if (!grid || grid.scale <= 0) return;
  scene.runs.forEach((run, i) => {
    const x = (i % grid.columns) * grid.panel, y = Math.floor(i / grid.columns) * grid.height;
    const top = y + grid.label * 1.5, high = grid.height - grid.label * 1.5;
    const view = new View(scene.field, x, top, grid.panel, high, options.flip);
    layer.paint(ctx, scene, view, x, top, grid.panel, high, viewer.theme);
    paintTask(ctx, view, scene.task);
    const wanted = (k) => k === i || obstacles(k);
    if (options.trails) paintTrails(ctx, view, scene, moment, wanted);
    if (options.vectors) paintVectors(ctx, view, scene, moment, wanted);
    paintBodies(ctx, view, scene, moment, { ...options, selected: -1 }, wanted);
    paintPanelLabel(ctx, viewer, run, i, x, y, grid);
  });
}

function paintPanelLabel(ctx, viewer, run, i, x, y, grid) {
  const over = viewer.time >= run.seconds;
  const size = grid.label, middle = y + size * 0.85;
  ctx.fillStyle = kSeries[i % kSeries.length];
  // The swatch of a dashed trail consists of two bars.
  for (const [from, share] of isDashed(i) ? [[0, 0.4], [0.6, 0.4]] : [[0, 1]]) {
    roundRect(ctx, x + size * (0.4 + 0.8 * from), middle - size * 0.4, size * 0.8 * share, size * 0.8, size * 0.2 * share);
    ctx.fill();
  }
  ctx.textBaseline = 'middle';
  ctx.font = `600 ${size * 0.86}px system-ui, sans-serif`;
  ctx.textAlign = 'right';
  const state = over ? (run.success ? `${run.seconds.toFixed(2)} s` : words(run.outcome)) : '';
  ctx.fillStyle = over && !run.success ? colours.bad : colours.dim;
  ctx.fillText(state, x + grid.panel - size * 0.5, middle);
  const room = grid.panel - size * 2.4 - ctx.measureText(state).width;
  ctx.textAlign = 'left';
  ctx.fillStyle = i === viewer.selected ? colours.goal : colours.text;
  let label = run.label;
  while (label.length > 1 && ctx.measureText(label).width > room) label = `${label.slice(0, -2)}…`;
  ctx.fillText(label, x + size * 1.5, middle);
}

/** Time [s] at which the ghost first differs by more than the rounding; -1: never. */
function partingOf(scene, ghost) {
  const rows = Math.min(scene.rows, ghost.rows);
  for (let r = 0; r < rows; ++r) {
    if (scene.tickOf[r] !== ghost.tickOf[r]) return scene.tickOf[r] / scene.rate;
    for (let i = 0; i < scene.bodies.length; ++i) {
      const a = scene.bodies[i], b = ghost.bodies[i];
      if (Math.abs(a.x[r] - b.x[r]) > 1e-3 || Math.abs(a.y[r] - b.y[r]) > 1e-3) return scene.tickOf[r] / scene.rate;
    }
  }
  return scene.rows === ghost.rows ? -1 : Math.min(scene.seconds, ghost.seconds);
}

function fillDifference(scene, ghost, parting) {
  $('#difference').hidden = !ghost;
  if (!ghost) return;
  setText($('#difference p'), parting < 0 ? 'Both replays are identical, to the millimetre.'
    : `Dashed outlines are the other replay. First difference at ${clockText(parting)}.`);
  $('#difference button').hidden = parting < 0;
}
