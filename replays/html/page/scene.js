// Part 2: a scene, which returns positions and the state of the match at any time.

const kDrawingStep = 1e-4;

/** The state of all bodies at one time. The object is reused for other times. */
class Moment {
  constructor(count) {
    this.x = new Float64Array(count);
    this.y = new Float64Array(count);
    this.heading = new Float64Array(count);
    this.present = new Uint8Array(count);
    this.tick = 0;
    this.row = 0;
    this.play = 0;
  }
}

class Scene {
  constructor(json, bytes, steps) {
    Object.assign(this, json);
    this.seconds = json.ticks / json.rate;
    this.first = new Uint8Array(json.rows);
    this.playOf = new Uint32Array(json.rows);
    demand(json.plays[0].row === 0, 'The replay is damaged.');
    json.plays.forEach((play, i) => {
      const end = i + 1 < json.plays.length ? json.plays[i + 1].row : json.rows;
      demand(isCount(play.row, json.rows - 1) && end > play.row, 'The replay is damaged.');
      this.first[play.row] = 1;
      this.playOf.fill(i, play.row, end);
      play.present = json.bodies.map((_, b) => !(play.absent || []).includes(b));
    });
    this.unpack(new Varints(bytes), steps);
    this.robots = json.bodies.map((_, i) => i).filter((i) => json.bodies[i].kind === 'robot');
    this.ball = json.bodies.findIndex((body) => body.kind === 'ball');
    this.race = json.runs.length > 0;
    this.match = json.teams.length === 2;
    this.marks = this.listEvents();
  }

  unpack(from, steps) {
    const { rows, first } = this;
    this.tickOf = unpackColumn(from, rows, first, 1);
    for (const body of this.bodies) {
      body.x = unpackColumn(from, rows, first, steps[0]);
      body.y = unpackColumn(from, rows, first, steps[0]);
      body.heading = body.size || body.turns ? unpackColumn(from, rows, first, steps[1]) : null;
    }
    const robots = this.bodies.filter((body) => body.kind === 'robot');
    const count = robots.length ? this.commands.values / robots.length : 0;
    demand(Number.isInteger(count), 'The replay is damaged.');
    for (const robot of robots) {
      robot.left = unpackPlain(from, count, steps[2]);
      robot.right = unpackPlain(from, count, steps[2]);
    }
    const n = this.drawings.count;
    const place = () => unpackPlain(from, n, kDrawingStep);
    this.drawn = { tick: unpackPlain(from, n, 1, new Float64Array(n)), what: unpackPlain(from, n, 1),
      x: place(), y: place(), toX: place(), toY: place(), radius: place(), text: [] };
    for (let i = 0, text = 0; i < n; ++i) this.drawn.text.push(this.drawn.what[i] >> 1 === 2 ? this.drawings.texts[text++] : '');
    demand(from.sound(), 'The replay is damaged.');
  }

  /** Last index in the increasing `list` with a value of at most `value`; -1 if there is none. */
  static last(list, value) {
    let low = 0, high = list.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (list[middle] <= value) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }

  rowAt(seconds) {
    // The small margin makes sure that a time computed from a tick leads back to this tick.
    return Math.max(0, Scene.last(this.tickOf, seconds * this.rate + 1e-6));
  }

  at(seconds, moment) {
    const tick = Math.min(Math.max(seconds, 0), this.seconds) * this.rate;
    const row = this.rowAt(tick / this.rate);
    const next = row + 1 < this.rows && !this.first[row + 1] ? row + 1 : row;
    const span = this.tickOf[next] - this.tickOf[row];
    const share = span > 0 ? Math.min(1, Math.max(0, (tick - this.tickOf[row]) / span)) : 0;
    moment.tick = tick;
    moment.row = row;
    moment.play = this.playOf[row];
    const { present } = this.plays[moment.play];
    for (let i = 0; i < this.bodies.length; ++i) {
      const { x, y, heading } = this.bodies[i];
      moment.present[i] = present[i] ? 1 : 0;
      moment.x[i] = x[row] + (x[next] - x[row]) * share;
      moment.y[i] = y[row] + (y[next] - y[row]) * share;
      moment.heading[i] = heading ? heading[row] + (heading[next] - heading[row]) * share : 0;
    }
    return moment;
  }

  /** Velocity of a body [m/s], from the rows around the moment. */
  velocity(body, moment, to) {
    const { x, y } = this.bodies[body];
    let a = moment.row, b = a;
    if (b + 1 < this.rows && !this.first[b + 1]) ++b;
    else if (!this.first[a]) --a;
    const seconds = (this.tickOf[b] - this.tickOf[a]) / this.rate;
    to[0] = seconds > 0 ? (x[b] - x[a]) / seconds : 0;
    to[1] = seconds > 0 ? (y[b] - y[a]) / seconds : 0;
    return to;
  }

  command(body, moment) {
    const { left, right } = this.bodies[body];
    const i = Math.min(Math.floor(moment.tick / this.commands.every), left.length - 1);
    return i < 0 ? null : [left[i], right[i]];
  }

  /** Index range [from, to) of the drawings that are visible at the moment. */
  drawnAt(moment) {
    const tick = Math.floor(moment.tick + 1e-6);
    const last = Scene.last(this.drawn.tick, tick);
    const shown = last < 0 ? -Infinity : this.drawn.tick[last];
    const over = shown <= this.plays[moment.play].tick && !this.task;
    if (over || tick - shown >= this.drawings.ticks) return [0, 0];
    return [Scene.last(this.drawn.tick, shown - 0.5) + 1, last + 1];
  }

  playing(moment) {
    return moment.tick + 1e-6 >= this.plays[moment.play].signal && moment.tick < this.ticks;
  }

  /** Seconds since the begin of the period. */
  clock(moment) {
    const play = this.plays[moment.play];
    return play.clock + Math.max(0, moment.tick - play.signal) / this.rate;
  }

  score(tick) {
    let score = [0, 0, 0];
    for (const change of this.scores) if (change[0] <= tick + 1e-6) score = change;
    return [score[1], score[2]];
  }

  /** Restarts and the referee's calls in order, for the event list and for steps between events. */
  listEvents() {
    const marks = this.events.map((event) => ({ ...event, seconds: event.tick / this.rate, goal: event.clause === 'goal' }));
    for (const play of this.plays) {
      if (!play.kind) continue;
      // A restart that the referee also calls is shown as one event.
      const called = marks.findIndex((event) => event.clause === play.kind && event.tick >= play.tick - 1 && event.tick <= play.signal + 1 && !event.restart);
      const call = called < 0 ? {} : marks.splice(called, 1)[0];
      marks.push({ ...call, ...play, seconds: play.tick / this.rate, restart: true, clause: play.kind });
    }
    return marks.sort((a, b) => a.tick - b.tick || !!a.restart - !!b.restart);
  }
}
