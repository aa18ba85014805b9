// Part 5: the field and its markings.

/** Draws the markings of one half; `s` is the sign of its x. */
function paintGoalArea(ctx, view, field, [depth, width], s) {
  const goal = (s * field.length) / 2;
  line(ctx, view, [[goal, width / 2], [goal - s * depth, width / 2], [goal - s * depth, -width / 2], [goal, -width / 2]]);
  ctx.stroke();
}

function paintArc(ctx, view, field, s) {
  const [depth, chord] = field.arc;
  if (!depth || !chord) return;
  const radius = (chord * chord / 4 + depth * depth) / (2 * depth);
  const front = field.length / 2 - field.area[0];
  const points = [];
  const half = Math.asin(Math.min(1, chord / 2 / radius));
  for (let i = -12; i <= 12; ++i) {
    const angle = (half * i) / 12;
    points.push([s * (front - depth + radius - radius * Math.cos(angle)), radius * Math.sin(angle)]);
  }
  line(ctx, view, points);
  ctx.stroke();
}

function paintCross(ctx, view, x, y, size) {
  for (const [dx, dy] of [[size, 0], [0, size]]) {
    line(ctx, view, [[x - dx, y - dy], [x + dx, y + dy]]);
    ctx.stroke();
  }
}

function paintField(ctx, view, field) {
  ctx.lineJoin = 'round';
  line(ctx, view, field.contour, true);
  ctx.lineWidth = 0.034 * view.scale;
  ctx.strokeStyle = colours.wall;
  ctx.stroke();
  ctx.fillStyle = colours.floor;
  ctx.fill();
  ctx.save();
  ctx.clip();
  ctx.strokeStyle = colours.line;
  ctx.lineWidth = Math.max(1, 0.005 * view.scale);
  // A field without goals and circle is a room; rooms have no lines.
  if (field.goalDepth || field.circle) {
    line(ctx, view, [[0, field.width], [0, -field.width]]);
    ctx.stroke();
  }
  if (field.circle) {
    ctx.beginPath();
    ctx.arc(view.x(0), view.y(0), field.circle * view.scale, 0, 7);
    ctx.stroke();
  }
  for (const s of field.goalDepth ? [-1, 1] : []) {
    paintGoalArea(ctx, view, field, field.area, s);
    if (field.bigArea[0]) paintGoalArea(ctx, view, field, field.bigArea, s);
    paintArc(ctx, view, field, s);
    line(ctx, view, [[(s * field.length) / 2, field.goalWidth / 2], [(s * field.length) / 2, -field.goalWidth / 2]]);
    ctx.stroke();
    if (field.penaltyMark) paintCross(ctx, view, s * field.penaltyMark, 0, 0.0125);
    const [x, y] = field.freeBall;
    if (x || y) for (const t of [-1, 1]) paintCross(ctx, view, s * x, t * y, 0.0125);
  }
  ctx.restore();
}

/** Draws the goals in the colour of the team that defends them, as teams change sides. */
function paintGoals(ctx, view, field, side) {
  if (!field.goalDepth) return;
  for (const team of [0, 1]) {
    const s = team === side ? -1 : 1;
    const goal = (s * field.length) / 2, back = goal + s * field.goalDepth, post = field.goalWidth / 2;
    ctx.globalAlpha = 0.28;
    ctx.fillStyle = colours.team[team];
    line(ctx, view, [[goal, post], [back, post], [back, -post], [goal, -post]], true);
    ctx.fill();
    ctx.globalAlpha = 1;
  }
}

function paintTask(ctx, view, task) {
  const [x, y] = task.goal;
  ctx.strokeStyle = ctx.fillStyle = colours.goal;
  ctx.lineWidth = Math.max(1.5, 0.006 * view.scale);
  ctx.setLineDash([4, 3]);
  ctx.beginPath();
  ctx.arc(view.x(x), view.y(y), Math.max(5, task.tolerance * view.scale), 0, 7);
  ctx.stroke();
  ctx.setLineDash([]);
  paintCross(ctx, view, x, y, 0.02);
  if (task.heading !== undefined) {
    line(ctx, view, [[x, y], [x + 0.1 * Math.cos(task.heading), y + 0.1 * Math.sin(task.heading)]]);
    ctx.stroke();
  }
}

/** The field as a cached picture, redrawn only when its size or colours change. */
class FieldLayer {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.key = '';
  }
  paint(ctx, scene, view, x, y, width, height, theme) {
    const key = [scene.title, scene.field.name, width, height, view.sign, theme].join();
    if (key !== this.key) {
      this.key = key;
      this.canvas.width = Math.max(1, Math.ceil(width));
      this.canvas.height = Math.max(1, Math.ceil(height));
      const own = this.canvas.getContext('2d');
      paintField(own, new View(scene.field, 0, 0, width, height, view.sign < 0), scene.field);
    }
    ctx.drawImage(this.canvas, x, y);
  }
}
