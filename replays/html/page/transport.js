// Part 11: time control, and drawing of one frame.

const kSpeeds = [0.25, 0.5, 1, 2, 4, 8, 16];
const kPanelPause = 100;  // [ms] between updates of the texts while the recording plays
const kBannerSeconds = 2.5;

class Viewer {
  constructor(meta, bytes) {
    this.meta = meta;
    let begin = 0;
    this.parts = meta.scenes.map((scene) => bytes.subarray(begin, (begin += scene.bytes)));
    demand(begin === bytes.length, 'The replay is damaged.');
    this.made = [];
    this.options = { trails: true, vectors: false, ids: true, overlays: true, ghost: true, flip: false, split: true };
    this.heatKind = 0;
    this.speed = 1;
    this.playing = false;
    this.time = 0;
    this.selected = -1;
    this.frames = [];
    this.canvas = $('#field');
    this.ctx = this.canvas.getContext('2d');
    this.layer = new FieldLayer();
    this.panelLayer = new FieldLayer();
    this.events = new EventList(this);
    this.cards = new RobotCards(this);
    this.table = new RaceTable(this);
    this.ghost = meta.kind === 'ghost' ? this.sceneOf(1) : null;
    this.index = -1;
  }

  sceneOf(index) {
    if (!this.made[index]) this.made[index] = new Scene(this.meta.scenes[index], this.parts[index], this.meta.steps);
    return this.made[index];
  }

  show(index) {
    this.index = index;
    const scene = (this.scene = this.sceneOf(index));
    this.moment = new Moment(scene.bodies.length);
    this.heat = new HeatMap(scene);
    this.share = scene.match && scene.ball >= 0 ? new BallShare(scene) : null;
    this.selected = -1;
    this.parting = this.ghost ? partingOf(scene, this.ghost) : -1;
    this.ghostMoment = this.ghost && new Moment(this.ghost.bodies.length);
    fillBoard(scene);
    fillAbout(scene, this.ghost);
    fillMarks(scene);
    fillDifference(scene, this.ghost, this.parting);
    this.events.fill(scene);
    this.cards.fill(scene);
    this.table.fill(scene);
    $('#seek').max = scene.seconds;
    $('[data-do="overlays"]').hidden = scene.drawings.count === 0;
    this.shape();
    this.seek(0);
  }

  /** Gives the stage the shape of the field, or of a grid of fields. */
  shape() {
    const { wide, high } = new View(this.scene.field, 0, 0, 1, 1, false);
    const split = this.scene.race && this.options.split;
    $('#stage').classList.toggle('split', split);
    $('#stage').style.aspectRatio = `${wide} / ${high}`;
    // The panels get the width that a field of limited height leaves free.
    $('#main').style.setProperty('--shape', split ? 9 : wide / high);
  }

  seek(seconds) {
    this.time = Math.min(Math.max(seconds, 0), this.scene.seconds);
    this.stale = true;
    this.invalidate();
  }

  setPlaying(playing) {
    if (playing && this.time >= this.scene.seconds - 1e-6) this.time = 0;
    this.playing = playing;
    this.last = null;
    this.stale = true;
    $('#play').setAttribute('aria-label', playing ? 'Pause' : 'Play');
    $('#play').classList.toggle('playing', playing);
    this.invalidate();
  }

  setSpeed(step) {
    const at = kSpeeds.indexOf(this.speed) + step;
    this.speed = kSpeeds[Math.min(Math.max(at, 0), kSpeeds.length - 1)];
    setText($('#speed'), `${{ 0.25: '¼', 0.5: '½' }[this.speed] || this.speed}×`);
  }

  /** Selects a robot; the selected one again deselects it. */
  select(index) {
    this.selected = this.selected === index ? -1 : index;
    this.stale = true;
    this.invalidate();
  }

  stepEvent(step) {
    const times = this.scene.marks.map((event) => event.seconds);
    if (step > 0) {
      const next = times.find((t) => t > this.time + 1e-3);
      return this.seek(next === undefined ? this.scene.seconds : next);
    }
    return this.seek(times.filter((t) => t < this.time - (this.playing ? 0.7 : 1e-3)).pop() || 0);
  }

  /** Moves by one row of the recording. */
  stepFrame(step) {
    this.setPlaying(false);
    const row = this.scene.rowAt(this.time);
    const tick = this.time * this.scene.rate;
    const { tickOf, rows } = this.scene;
    let to = row;
    if (step < 0) while (to > 0 && tickOf[to] > tick - 1e-3) --to;
    else while (to < rows - 1 && tickOf[to] < tick + 1e-3) ++to;
    this.seek(tickOf[to] / this.scene.rate);
  }

  invalidate() {
    if (!this.waiting) this.waiting = requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    this.waiting = 0;
    if (this.playing) {
      const passed = this.last === null ? 0 : Math.min(now - this.last, 250) / 1000;
      this.last = now;
      this.advance(this.time + passed * this.speed);
    }
    const begin = performance.now();
    this.paint();
    if (this.stale || !this.playing || now - this.told > kPanelPause) this.tell(now);
    this.frames[this.frames.length < 600 ? this.frames.length : Math.floor(now) % 600] = performance.now() - begin;
    if (this.playing) this.invalidate();
  }

  advance(time) {
    const goal = this.scene.marks.find((event) => event.goal && event.seconds > this.time && event.seconds <= time);
    if (goal) this.announce(goal);
    this.time = Math.min(time, this.scene.seconds);
    if (this.time >= this.scene.seconds) this.setPlaying(false);
  }

  announce(goal) {
    const score = this.scene.score(goal.tick);
    setText($('#live'), `${eventText(goal)}, ${score.join(' to ')}`);
  }

  /** Gives the canvas as many pixels as the screen shows. */
  fit() {
    const box = this.canvas.getBoundingClientRect();
    const ratio = Math.min(window.devicePixelRatio || 1, 4);
    const width = Math.max(1, Math.round(box.width * ratio)), height = Math.max(1, Math.round(box.height * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
  }

  paint() {
    this.scene.at(this.time, this.moment);
    const { width, height } = this.canvas;
    this.ctx.clearRect(0, 0, width, height);
    this.paintStage(this.ctx, 0, 0, width, height, this.layer);
  }

  paintStage(ctx, x, y, width, height, layer) {
    const { scene, moment, options } = this;
    if (scene.race && options.split) return paintPanels(ctx, this, width, height, this.panelLayer);
    const view = new View(scene.field, x, y, width, height, options.flip);
    layer.paint(ctx, scene, view, x, y, width, height, this.theme);
    if (scene.match) paintGoals(ctx, view, scene.field, scene.plays[moment.play].side);
    if (scene.task) paintTask(ctx, view, scene.task);
    this.paintHeat(ctx, view);
    const alphaOf = scene.race ? (i) => this.alphaOf(i) : null;
    if (options.trails) paintTrails(ctx, view, scene, moment, null, alphaOf);
    if (options.overlays) paintDrawings(ctx, view, scene, moment);
    if (options.vectors) paintVectors(ctx, view, scene, moment, null);
    paintBodies(ctx, view, scene, moment, { ids: options.ids, selected: this.selected, alphaOf });
    if (this.ghost && options.ghost) paintGhost(ctx, view, this.ghost, this.ghost.at(this.time, this.ghostMoment));
    return (this.view = view);
  }

  /** Opacity of run `i` in a race: the selected run stands out, failed runs fade. */
  alphaOf(i) {
    if (this.selected >= 0 && i !== this.selected) return 0.25;
    const run = this.scene.runs[i];
    return run && !run.success && this.time >= run.seconds ? 0.45 : 1;
  }

  paintHeat(ctx, view) {
    const bodies = heatBodies(this.scene, kHeatKinds[this.heatKind], this.selected);
    if (!bodies.length) return;
    const row = this.moment.row;
    if (row < this.heat.row || row > this.heat.row + 5 || !this.playing || bodies.join() !== this.heat.bodies) {
      this.heat.update(row, bodies);
    }
    this.heat.paint(ctx, view);
  }

  /** Updates all texts to the moment. */
  tell(now) {
    this.told = now;
    this.stale = false;
    const { scene, moment } = this;
    const score = scene.score(moment.tick);
    if (scene.match) document.querySelectorAll('#score b').forEach((b, i) => setText(b, String(score[i])));
    setText($('#period'), scene.match ? periodNames[scene.plays[moment.play].period] || '' : '');
    setText($('#clock'), clockText(scene.match ? scene.clock(moment) : this.time));
    setText($('#time'), `${clockText(this.time)} / ${clockText(scene.seconds)}`);
    const seek = $('#seek');
    seek.value = this.time;
    seek.style.setProperty('--done', `${scene.seconds ? (100 * this.time) / scene.seconds : 0}%`);
    seek.setAttribute('aria-valuetext', spokenTime(this.time) + (scene.match ? `, ${score.join('–')}` : ''));
    this.events.update(scene, this.time);
    this.cards.update(scene, moment, this.selected);
    this.table.update(scene, moment, this.selected);
    updateShare(this.share, moment.row);
    this.tellBanner();
  }

  tellBanner() {
    const { scene, time } = this;
    const news = scene.marks.filter((event) => event.title || event.restart);
    const recent = news.filter((event) => event.seconds <= time + 1e-6 && event.seconds > time - kBannerSeconds);
    const event = recent.find((e) => e.goal) || recent.filter((e) => !e.restart).pop() || recent.pop();
    const banner = $('#banner');
    banner.classList.toggle('goal', !!(event && event.goal));
    if (event && event.favours !== undefined) banner.dataset.team = event.favours;
    else delete banner.dataset.team;
    setText(banner, event ? eventText(event) + (event.goal ? '!' : '') : '');
  }
}
