// Part 4: colours, and the view that turns metres into pixels.

const kSeries = ['#56b4e9', '#e69f00', '#009e73', '#f0e442', '#6e46ff', '#d55e00', '#cc79a7', '#3fe0d8', '#cc00cc',
  '#ffbb99', '#aa77ff', '#aa5599'];

const colours = {};
function readColours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ['page', 'text', 'dim', 'wall', 'floor', 'line', 'ball', 'seam', 'blue', 'yellow', 'ink', 'obstacle', 'goal',
    'bad', 'trail']) colours[name] = style.getPropertyValue(`--${name}`).trim();
  colours.team = [colours.blue, colours.yellow];
  colours.trails = [colours.blue, colours.trail];
  colours.badge = ['#fff', '#2c2204'];
  colours.digit = ['#0e347a', '#ffe278'];
  colours.edge = ['#082659', '#684800'];
}

/** Black or white, whichever can be read on a colour of the form #rrggbb. */
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

/** Colours come again after a dozen runs: dashes tell the second dozen from the first. */
function isDashed(index) {
  return Math.floor(index / kSeries.length) % 2 === 1;
}

/** A rectangle of the canvas that shows a whole field. */
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
  /** Metres of a place on the canvas. */
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
