// Part 4: colours, and the view that converts metres to pixels.

const kSeries = [];
const colours = {};
function readColours() {
  const style = getComputedStyle(document.documentElement);
  const read = (name) => style.getPropertyValue(`--${name}`).trim();
  for (const name of ['page', 'text', 'dim', 'wall', 'floor', 'line', 'ball', 'seam', 'wheel', 'blue', 'yellow', 'ink', 'obstacle',
    'goal', 'bad', 'trail']) colours[name] = read(name);
  colours.team = [colours.blue, colours.yellow];
  colours.trails = [colours.blue, colours.trail];
  for (const part of ['edge', 'badge', 'digit']) colours[part] = [read(`blue-${part}`), read(`yellow-${part}`)];
  kSeries.length = 0;
  for (let i = 0, colour; (colour = read(`series-${i}`)) !== ''; ++i) kSeries.push(colour);
}

/** Black or white, whichever is readable on a colour of the form #rrggbb. */
function inkOn(colour) {
  const [r, g, b] = [1, 3, 5].map((at) => (parseInt(colour.slice(at, at + 2), 16) / 255) ** 2.2);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b < 0.18 ? '#fff' : '#000';
}

function colourOf(scene, index) {
  const body = scene.bodies[index];
  if (body.kind === 'ball') return colours.ball;
  if (body.kind === 'obstacle') return colours.obstacle;
  return body.team === undefined ? kSeries[index % kSeries.length] : colours.team[body.team];
}

/** Whether a run is dashed: colours repeat after a dozen runs, and dashes mark the second dozen. */
function isDashed(index) {
  return Math.floor(index / kSeries.length) % 2 === 1;
}

/** Maps a field to a rectangle of the canvas. */
class View {
  constructor(field, x, y, width, height, flip) {
    const margin = 0.04;
    this.wide = field.length + 2 * field.goalDepth + 2 * margin;
    this.high = field.width + 2 * margin;
    this.scale = Math.min(width / this.wide, height / this.high);
    this.middleX = x + width / 2;
    this.middleY = y + height / 2;
    this.sign = flip ? -1 : 1;
  }
  x(x) {
    return this.middleX + this.sign * x * this.scale;
  }
  y(y) {
    return this.middleY - this.sign * y * this.scale;
  }
  angle(heading) {
    return (this.sign < 0 ? Math.PI : 0) - heading;
  }
  /** World coordinates [m] of a point on the canvas [px]. */
  metres(px, py) {
    return [(this.sign * (px - this.middleX)) / this.scale, (-this.sign * (py - this.middleY)) / this.scale];
  }
}

function line(ctx, view, points, closed) {
  ctx.beginPath();
  for (const [x, y] of points) ctx.lineTo(view.x(x), view.y(y));
  if (closed) ctx.closePath();
}

function roundRect(ctx, x, y, w, h, r) {
  ctx.beginPath();
  if (ctx.roundRect) ctx.roundRect(x, y, w, h, r);
  else ctx.rect(x, y, w, h);
}
