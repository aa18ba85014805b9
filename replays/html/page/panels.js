// Part 9: all texts beside the field. Names come from foreign files: they are inserted as text, never as
// markup.

const $ = (selector, from = document) => from.querySelector(selector);

function element(tag, text, attributes = {}, ...children) {
  const made = document.createElement(tag);
  if (text !== undefined && text !== null) made.textContent = text;
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

function setText(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

function clockText(seconds, digits = 1) {
  const tenths = Math.floor(seconds * 10 ** digits + 1e-6) / 10 ** digits;
  const minutes = Math.floor(tenths / 60);
  return `${minutes}:${(tenths - 60 * minutes).toFixed(digits).padStart(digits ? 3 + digits : 2, '0')}`;
}

function spokenTime(seconds) {
  const whole = Math.floor(seconds + 1e-6), minutes = Math.floor(whole / 60);
  return `${minutes ? `${minutes} min ` : ''}${whole % 60} s`;
}

const words = (name) => name.replace(/-/g, ' ').replace('kick off', 'kick-off');
const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
const periodNames = ['', '1st half', '2nd half', 'Overtime', 'Shoot-out'];
const teamNames = ['blue', 'yellow'];

/** A specification such as classic:navigator=bezier is long; the name before its settings is short. */
const shortName = (name) => (name.length > 24 ? name.split(':')[0] : name);

/** An event as text. Titles, details and colours (`favours`) are part of the data, as in pictures and films. */
function eventText(event) {
  const [head, rest] = event.clause.split('.');
  const named = event.goal ? 'Goal' : (!event.restart && event.title) || capital(words(head));
  const gains = event.favours !== undefined && (event.goal || event.restart || rest);
  const detail = event.title ? event.detail : rest && words(rest);
  return named + (gains ? ` for ${teamNames[event.favours]}` : '') + (detail && !event.goal && !event.restart ? `: ${detail}` : '');
}

function eventDetail(event) {
  const parts = [];
  const robot = event.robot === undefined ? '' : `robot ${event.robot}`;
  if (event.goal) parts.push(robot && `by ${robot}`);
  else if (event.team !== undefined && !event.restart) {
    parts.push(`${event.favours === 1 - event.team ? 'against ' : ''}${teamNames[event.team]} ${robot}`.trim());
  }
  parts.push(event.law && `law ${event.law}`, event.measured);
  return parts.filter((part) => part).join(' · ');
}

function swatch(scene, index) {
  const body = scene.bodies[index];
  const mark = element('span', body.team === undefined ? index + 1 : body.number, { class: 'mark', 'aria-hidden': 'true' });
  if (body.team === undefined) {
    mark.style.backgroundColor = colourOf(scene, index);
    mark.style.color = inkOn(colourOf(scene, index));
    mark.classList.toggle('dashed', isDashed(index));
  } else mark.dataset.team = body.team;
  return mark;
}

class EventList {
  constructor(viewer) {
    this.viewer = viewer;
    this.section = $('#events');
    this.body = $('tbody', this.section);
    this.current = -1;
  }
  fill(scene) {
    this.section.hidden = scene.marks.length === 0;
    this.rows = scene.marks.map((event) => {
      const button = element('button', clockText(event.seconds), { type: 'button' });
      button.addEventListener('click', () => this.viewer.seek(event.seconds));
      const what = element('td', null, event.goal ? {} : { colspan: 2 }, element('span', eventText(event)), element('small', eventDetail(event)));
      const row = element('tr', null, { class: event.goal ? 'goal' : event.restart ? 'restart' : 'call' }, element('td', null, {}, button), what);
      if (event.goal) row.append(element('td', scene.score(event.tick).join('–')));
      if (event.favours !== undefined) row.dataset.team = event.favours;
      return row;
    });
    this.body.replaceChildren(...this.rows);
    setText($('.count', this.section), String(scene.marks.length));
    this.current = -1;
  }
  update(scene, seconds) {
    const current = Scene.last(scene.marks.map((event) => event.seconds), seconds + 1e-6);
    if (current === this.current) return;
    if (this.rows[this.current]) this.rows[this.current].removeAttribute('aria-current');
    this.current = current;
    const row = this.rows[current];
    const box = $('.scroll', this.section);
    if (!row) return;
    row.setAttribute('aria-current', 'true');
    if (!box.matches(':hover') && !box.contains(document.activeElement)) {
      box.scrollTop = row.offsetTop - box.clientHeight / 2;
    }
  }
  goalsOnly() {
    return this.section.classList.toggle('only-goals');
  }
}

class RobotCards {
  constructor(viewer) {
    this.viewer = viewer;
  }
  fill(scene) {
    $('#robots').hidden = scene.race;
    this.cards = scene.race ? [] : scene.robots.map((i) => {
      const body = scene.bodies[i];
      const name = body.team === undefined ? `Robot ${i + 1}` : `${capital(teamNames[body.team])} ${body.number}`;
      const values = element('span', null, { class: 'values' });
      const card = element('button', null, { type: 'button', 'aria-pressed': 'false', class: 'card' },
        swatch(scene, i), element('b', name), values);
      card.addEventListener('click', () => this.viewer.select(i));
      return { card, values, i };
    });
    $('#robots .cards').replaceChildren(...this.cards.map(({ card }) => card));
  }
  update(scene, moment, selected) {
    for (const { card, values, i } of this.cards) {
      card.setAttribute('aria-pressed', String(i === selected));
      if (!moment.present[i]) {
        setText(values, 'not on the field');
        continue;
      }
      const speed = Math.hypot(...scene.velocity(i, moment, velocity));
      const degrees = Math.round((moment.heading[i] * 180) / Math.PI);
      const command = scene.command(i, moment);
      const lines = [`${speed.toFixed(2)} m/s, ${((((degrees + 180) % 360) + 360) % 360) - 180}°`,
        `x ${moment.x[i].toFixed(2)} y ${moment.y[i].toFixed(2)} m`];
      if (command) lines.push(`L ${command[0].toFixed(0)} R ${command[1].toFixed(0)} rad/s`);
      const message = this.message(scene, moment, i);
      if (message) lines.push(`“${message}”`);
      setText(values, lines.join('\n').replace(/-/g, '−'));
    }
  }
  /** The latest debug text that the robot's team drew near it in the last two seconds. */
  message(scene, moment, i) {
    const { what, x, y, text, tick } = scene.drawn;
    const [, end] = scene.drawnAt(moment);
    for (let k = end - 1; k >= 0 && k > end - 300 && tick[k] > moment.tick - 2 * scene.rate; --k) {
      const own = what[k] >> 1 === 2 && (!scene.match || (what[k] & 1) === scene.bodies[i].team);
      if (own && Math.hypot(x[k] - moment.x[i], y[k] - moment.y[i]) < 0.15) return text[k].slice(0, 60);
    }
    return '';
  }
}

function fillShare(selector, shares, labels) {
  const bar = $(selector);
  bar.hidden = !shares;
  if (!shares) return;
  [...bar.children].forEach((part, i) => {
    part.style.flexGrow = shares[i];
    setText(part, shares[i] > 11 ? `${shares[i]} %` : '');
  });
  bar.setAttribute('role', 'img');
  bar.setAttribute('aria-label', shares.map((share, i) => `${labels[i]} ${share} %`).join(', '));
  bar.title = bar.getAttribute('aria-label');
}

function updateShare(share, row) {
  $('#share').hidden = !share;
  if (!share) return;
  fillShare('#possession', BallShare.percent(share.held, row), ['Possession: blue', 'yellow']);
  fillShare('#territory', BallShare.percent(share.third, row), ["Ball in blue's third", 'middle', "yellow's third"]);
}

function fillBoard(scene) {
  $('#board').hidden = !scene.match;
  setText($('#title'), scene.match ? scene.teams.join(' – ') : scene.title || 'Trial');
  $('#title').classList.toggle('unseen', scene.match);
  document.querySelectorAll('#board .team').forEach((team, i) => {
    setText($('.name', team), scene.match ? shortName(scene.teams[i]) : '');
    team.title = scene.match ? scene.teams[i] : '';
  });
}

function fillAbout(scene, ghost) {
  const facts = [...scene.facts];
  facts.unshift(['Seed', scene.seed]);
  if (scene.match) facts.unshift(['Blue', scene.teams[0]], ['Yellow', scene.teams[1]]);
  if (ghost) facts.push(['Ghost', ghost.teams.join(' – ')], ['Its seed', ghost.seed], ['Its hash', ghost.result ? ghost.result.hash : 'none']);
  const items = facts.flatMap(([name, value]) => [element('dt', name), element('dd', null, {}, element('bdi', value))]);
  $('#about dl').replaceChildren(...items);
  $('#badge').hidden = !scene.result;
  if (scene.result) setText($('#badge code'), scene.result.hash);
}

function fillMarks(scene) {
  const at = (seconds) => `calc(${scene.seconds ? seconds / scene.seconds : 0} * (100% - 1.25rem) + 0.625rem)`;
  const marks = scene.marks.filter((event) => event.goal).map((event) => {
    const mark = element('span', null, { class: 'mark', 'data-team': event.favours });
    mark.style.left = at(event.seconds);
    return mark;
  });
  scene.plays.forEach((play, i) => {
    if (i === 0 || play.period === scene.plays[i - 1].period) return;
    const mark = element('span', null, { class: 'half' });
    mark.style.left = at(play.tick / scene.rate);
    marks.push(mark);
  });
  $('#marks').replaceChildren(...marks);
}
