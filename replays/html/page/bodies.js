// Part 6: bodies that move. Teams differ in colour, in the shape behind robot numbers and in lightness.

function paintMark(ctx, team, x, y, size, number) {
  ctx.fillStyle = colours.badge[team];
  ctx.beginPath();
  if (team === 0) {
    ctx.arc(x, y, size * 0.5, 0, 7);
  } else {
    const r = size * 0.64;
    ctx.moveTo(x, y - r);
    ctx.lineTo(x + r, y);
    ctx.lineTo(x, y + r);
    ctx.lineTo(x - r, y);
  }
  ctx.fill();
  if (number === null) return;
  ctx.fillStyle = colours.digit[team];
  ctx.font = `700 ${size * 0.78}px system-ui, sans-serif`;
  ctx.fillText(number, x, y + size * 0.04);
}

/** Length and width [m]; for a round body, its diameter. */
const extentOf = (body) => body.size || [2 * body.radius, 2 * body.radius];

/** Draws a body with wheels and a visible front, which points along +x. */
function paintRobot(ctx, view, body, x, y, heading, colour) {
  const [length, width] = extentOf(body).map((v) => v * view.scale);
  const team = body.team;
  ctx.save();
  ctx.translate(view.x(x), view.y(y));
  ctx.rotate(view.angle(heading));
  roundRect(ctx, -length / 2, -width / 2, length, width, length * (body.size ? 0.15 : 0.5));
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.lineWidth = Math.max(1, length * 0.05);
  ctx.strokeStyle = team === undefined ? colours.ink : colours.edge[team];
  ctx.stroke();
  ctx.fillStyle = colours.wheel;
  for (const side of [-0.49, 0.4]) ctx.fillRect(-length * 0.23, width * side, length * 0.46, width * 0.09);
  ctx.fillStyle = team === undefined ? '#fff' : colours.badge[team];
  ctx.beginPath();
  ctx.moveTo(length * 0.44, -width * 0.18);
  ctx.lineTo(length * 0.44, width * 0.18);
  ctx.lineTo(length * 0.32, width * 0.3);
  ctx.lineTo(length * 0.32, -width * 0.3);
  ctx.fill();
  ctx.restore();
}

function paintNumber(ctx, view, body, index, x, y, ids) {
  const size = extentOf(body)[1] * view.scale * 0.58;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  if (body.team !== undefined) return paintMark(ctx, body.team, view.x(x), view.y(y), size, ids ? body.number : null);
  if (!ids) return undefined;
  ctx.fillStyle = inkOn(kSeries[index % kSeries.length]);
  ctx.font = `700 ${size}px system-ui, sans-serif`;
  return ctx.fillText(index + 1, view.x(x), view.y(y) + 1);
}

function paintBall(ctx, view, body, x, y) {
  const r = Math.max(3.5, body.radius * view.scale);
  ctx.beginPath();
  ctx.arc(view.x(x), view.y(y), r, 0, 7);
  ctx.fillStyle = colours.ball;
  ctx.fill();
  ctx.lineWidth = Math.max(1, r * 0.16);
  ctx.strokeStyle = colours.seam;
  ctx.stroke();
}

function paintObstacle(ctx, view, body, x, y, heading) {
  ctx.fillStyle = colours.obstacle;
  ctx.strokeStyle = colours.ink;
  ctx.lineWidth = 1;
  ctx.save();
  ctx.translate(view.x(x), view.y(y));
  ctx.rotate(view.angle(heading));
  ctx.beginPath();
  if (body.size) {
    const [length, width] = body.size.map((v) => v * view.scale);
    ctx.rect(-length / 2, -width / 2, length, width);
  } else {
    ctx.arc(0, 0, body.radius * view.scale, 0, 7);
  }
  ctx.fill();
  ctx.stroke();
  ctx.restore();
}

function paintSelection(ctx, view, x, y) {
  ctx.beginPath();
  ctx.arc(view.x(x), view.y(y), 0.075 * view.scale, 0, 7);
  ctx.strokeStyle = colours.text;
  ctx.lineWidth = 2;
  ctx.setLineDash([6, 4]);
  ctx.stroke();
  ctx.setLineDash([]);
}

function paintBodies(ctx, view, scene, moment, options, wanted) {
  for (let i = scene.bodies.length - 1; i >= 0; --i) {
    if (!moment.present[i] || (wanted && !wanted(i))) continue;
    const body = scene.bodies[i];
    const x = moment.x[i], y = moment.y[i];
    if (body.kind === 'ball') paintBall(ctx, view, body, x, y);
    else if (body.kind === 'obstacle') paintObstacle(ctx, view, body, x, y, moment.heading[i]);
    else {
      ctx.globalAlpha = options.alphaOf ? options.alphaOf(i) : 1;
      paintRobot(ctx, view, body, x, y, moment.heading[i], colourOf(scene, i));
      paintNumber(ctx, view, body, i, x, y, options.ids);
      ctx.globalAlpha = 1;
    }
    if (i === options.selected) paintSelection(ctx, view, x, y);
  }
}
