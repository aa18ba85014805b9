// Part 3: possession and ball position, summed up row by row over the time of play.

const kLead = 0.02;  // [m] as in match statistics: a team must be this much nearer than the other to take the ball over

class BallShare {
  constructor(scene) {
    const n = scene.rows;
    this.held = [new Float32Array(n), new Float32Array(n)];
    this.third = [new Float32Array(n), new Float32Array(n), new Float32Array(n)];
    const ball = scene.bodies[scene.ball];
    let holder = -1;
    for (let r = 1; r < n; ++r) {
      for (const sums of [...this.held, ...this.third]) sums[r] = sums[r - 1];
      const play = scene.plays[scene.playOf[r]];
      if (scene.first[r]) {
        holder = -1;
        continue;
      }
      const ticks = scene.tickOf[r] - Math.max(scene.tickOf[r - 1], play.signal);
      if (ticks <= 0) continue;
      const near = [Infinity, Infinity];
      for (const i of scene.robots) {
        const { x, y, team } = scene.bodies[i];
        if (play.present[i]) near[team] = Math.min(near[team], Math.hypot(x[r] - ball.x[r], y[r] - ball.y[r]));
      }
      const nearer = near[0] < near[1] ? 0 : 1;
      if (near[nearer] < near[1 - nearer] - kLead) holder = nearer;
      if (holder >= 0) this.held[holder][r] += ticks;  // nobody has held the ball yet while both teams are equally far from it
      const side = play.side ? -1 : 1;  // thirds: blue's own, the middle, yellow's
      const forward = (side * ball.x[r]) / scene.field.length;
      this.third[forward < -1 / 6 ? 0 : forward > 1 / 6 ? 2 : 1][r] += ticks;
    }
  }
  /** The shares as whole percentages that add up to 100. */
  static percent(sums, row) {
    const values = sums.map((sum) => sum[row]);
    const total = values.reduce((a, b) => a + b, 0);
    if (!total) return null;
    const shares = values.map((value) => Math.round((100 * value) / total));
    shares[shares.length - 1] = 100 - shares.slice(0, -1).reduce((a, b) => a + b, 0);
    return shares;
  }
}
