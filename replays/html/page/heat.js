// Part 8: heat maps, which show where the ball, a team or a robot has been so far.

const kHeatCell = 0.025;  // [m]
const kHeatSpread = [1, 0.75, 0.56, 0, 0.32, 0.24, 0, 0, 0.1];  // weight by squared distance in cells
const kHeatKinds = ['off', 'ball', 'blue', 'yellow', 'robot'];

class HeatMap {
  constructor(scene) {
    this.scene = scene;
    const { length, width, goalDepth } = scene.field;
    this.columns = Math.ceil((length + 2 * goalDepth) / kHeatCell);
    this.lines = Math.ceil(width / kHeatCell);
    this.left = -length / 2 - goalDepth;
    this.top = width / 2;
    this.canvas = document.createElement('canvas');
    this.canvas.width = this.columns;
    this.canvas.height = this.lines;
    this.counts = new Float32Array(this.columns * this.lines);
    this.bodies = '';
    this.row = 0;
  }

  count(row, bodies) {
    const { scene, columns, lines } = this;
    const play = scene.plays[scene.playOf[row]];
    if (scene.tickOf[row] < play.signal) return;
    for (const i of bodies) {
      if (!play.present[i]) continue;
      const c = Math.floor((scene.bodies[i].x[row] - this.left) / kHeatCell);
      const l = Math.floor((this.top - scene.bodies[i].y[row]) / kHeatCell);
      // A body is larger than a cell, so it is spread over its neighbours.
      for (let dl = -2; dl <= 2; ++dl) {
        for (let dc = -2; dc <= 2; ++dc) {
          const inside = c + dc >= 0 && c + dc < columns && l + dl >= 0 && l + dl < lines;
          if (inside) this.counts[(l + dl) * columns + c + dc] += kHeatSpread[dl * dl + dc * dc];
        }
      }
    }
  }

  /** Brings the map to a row. Moving on to a later row is cheap. */
  update(row, bodies) {
    const key = bodies.join();
    if (key === this.bodies && row === this.row) return;
    if (key !== this.bodies || row < this.row) {
      this.counts.fill(0);
      this.row = -1;
      this.bodies = key;
    }
    while (this.row < row) this.count(++this.row, bodies);
    this.colour();
  }

  colour() {
    const ctx = this.canvas.getContext('2d');
    const image = ctx.createImageData(this.columns, this.lines);
    // A body that waits for long would darken all other cells, so the brightest hundredth is clipped.
    const sorted = this.counts.filter((count) => count > 0).sort();
    const most = Math.max(1, sorted[Math.floor(sorted.length * 0.99)] || 0);
    for (let i = 0; i < this.counts.length; ++i) {
      const share = Math.min(1, (this.counts[i] / most) ** 0.6);
      image.data[4 * i] = 255 * Math.min(1, 0.4 + share);
      image.data[4 * i + 1] = 225 * share * share;
      image.data[4 * i + 2] = 140 * (1 - share) + 30 * share;
      image.data[4 * i + 3] = 225 * Math.min(1, share * 1.2);
    }
    ctx.putImageData(image, 0, 0);
  }

  paint(ctx, view) {
    const x = view.x(view.sign * this.left), y = view.y(view.sign * this.top);
    const width = this.columns * kHeatCell * view.scale, height = this.lines * kHeatCell * view.scale;
    ctx.save();
    line(ctx, view, this.scene.field.contour, true);
    ctx.clip();
    if (view.sign < 0) {
      ctx.translate(2 * view.middleX, 2 * view.middleY);
      ctx.scale(-1, -1);
    }
    ctx.imageSmoothingEnabled = true;
    ctx.drawImage(this.canvas, x, y, width, height);
    ctx.restore();
  }
}

/** The bodies that a kind of map shows; empty if the scene has no such map. */
function heatBodies(scene, kind, selected) {
  if (kind === 'ball') return scene.ball >= 0 ? [scene.ball] : [];
  if (kind === 'robot') return selected >= 0 ? [selected] : [];
  return scene.robots.filter((i) => scene.bodies[i].team === ['blue', 'yellow'].indexOf(kind));
}
