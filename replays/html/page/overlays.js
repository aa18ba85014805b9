// Part 7: trails, velocities, debug drawings of teams, and the ghost.

const kTrailSeconds = 3;
const kTrailParts = 5;
const kVectorSeconds = 0.25;
const velocity = [0, 0];

/** Draws the path of a body in the last seconds of its play, fading backwards; Infinity: all of it, not fading. */
function paintTrail(ctx, view, scene, moment, index, seconds, colour, alpha) {
  const { x, y } = scene.bodies[index];
  const begin = Math.max(scene.plays[moment.play].row, scene.rowAt(moment.tick / scene.rate - seconds));
  const parts = seconds === Infinity ? 1 : kTrailParts;
  ctx.strokeStyle = colour;
  ctx.lineJoin = 'round';
  const width = (ctx.lineWidth = Math.max(1.5, 0.009 * view.scale));
  if (scene.bodies[index].team === undefined && isDashed(index)) ctx.setLineDash([2.5 * width, 2 * width]);
  for (let part = 0; part < parts; ++part) {
    const from = begin + Math.floor(((moment.row - begin) * part) / parts);
    const to = begin + Math.floor(((moment.row - begin) * (part + 1)) / parts);
    ctx.globalAlpha = (alpha * (part + 1)) / parts;
    ctx.beginPath();
    ctx.moveTo(view.x(x[from]), view.y(y[from]));
    for (let r = from + 1; r <= to; ++r) ctx.lineTo(view.x(x[r]), view.y(y[r]));
    if (part === parts - 1) ctx.lineTo(view.x(moment.x[index]), view.y(moment.y[index]));
    ctx.stroke();
  }
  ctx.globalAlpha = 1;
  ctx.setLineDash([]);
}

function paintTrails(ctx, view, scene, moment, wanted, alphaOf) {
  for (let i = 0; i < scene.bodies.length; ++i) {
    const body = scene.bodies[i];
    if (!moment.present[i] || body.kind === 'obstacle' || (wanted && !wanted(i))) continue;
    const seconds = scene.task ? Infinity : kTrailSeconds;
    const colour = body.team === undefined ? colourOf(scene, i) : colours.trails[body.team];
    paintTrail(ctx, view, scene, moment, i, seconds, colour, (alphaOf ? alphaOf(i) : 1) * 0.8);
  }
}

function paintVectors(ctx, view, scene, moment, wanted) {
  ctx.strokeStyle = ctx.fillStyle = colours.text;
  ctx.lineWidth = Math.max(1.5, 0.006 * view.scale);
  for (let i = 0; i < scene.bodies.length; ++i) {
    if (!moment.present[i] || (wanted && !wanted(i))) continue;
    const [vx, vy] = scene.velocity(i, moment, velocity);
    const speed = Math.hypot(vx, vy);
    if (speed < 0.02) continue;
    const fromX = view.x(moment.x[i]), fromY = view.y(moment.y[i]);
    const toX = view.x(moment.x[i] + vx * kVectorSeconds), toY = view.y(moment.y[i] + vy * kVectorSeconds);
    const head = Math.min(0.025 * view.scale, 0.5 * Math.hypot(toX - fromX, toY - fromY));
    const angle = Math.atan2(toY - fromY, toX - fromX);
    ctx.beginPath();
    ctx.moveTo(fromX, fromY);
    ctx.lineTo(toX, toY);
    ctx.stroke();
    ctx.beginPath();
    ctx.moveTo(toX + head * 0.4 * Math.cos(angle), toY + head * 0.4 * Math.sin(angle));
    ctx.lineTo(toX - head * Math.cos(angle - 0.45), toY - head * Math.sin(angle - 0.45));
    ctx.lineTo(toX - head * Math.cos(angle + 0.45), toY - head * Math.sin(angle + 0.45));
    ctx.fill();
  }
}

/** Debug drawings of the teams, and paths that navigators drew. */
function paintDrawings(ctx, view, scene, moment) {
  const [from, to] = scene.drawnAt(moment);
  const { what, x, y, toX, toY, radius, text } = scene.drawn;
  ctx.font = `600 ${Math.max(10, 0.03 * view.scale)}px system-ui, sans-serif`;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.lineJoin = 'round';
  const thin = Math.max(1.25, 0.004 * view.scale), seam = Math.max(3, 0.008 * view.scale);
  for (let i = from; i < to; ++i) {
    ctx.lineWidth = thin;
    ctx.strokeStyle = ctx.fillStyle = scene.match ? colours.trails[what[i] & 1] : colours.text;
    ctx.beginPath();
    if (what[i] >> 1 === 0) {
      ctx.moveTo(view.x(x[i]), view.y(y[i]));
      ctx.lineTo(view.x(toX[i]), view.y(toY[i]));
      ctx.stroke();
    } else if (what[i] >> 1 === 1) {
      ctx.arc(view.x(x[i]), view.y(y[i]), Math.max(2, radius[i] * view.scale), 0, 7);
      ctx.stroke();
    } else {
      // An outline in the floor's colour keeps words readable over lines.
      ctx.strokeStyle = colours.floor;
      ctx.lineWidth = seam;
      const words = text[i].slice(0, 80), side = ctx.measureText(words).width / 2 + seam;
      const edge = ctx.canvas.width / ctx.getTransform().a;
      const middle = Math.min(Math.max(view.x(x[i]), side), Math.max(side, edge - side));
      ctx.strokeText(words, middle, view.y(y[i]));
      ctx.fillText(words, middle, view.y(y[i]));
    }
  }
}

/** Draws the second replay over the first, as outlines only. */
function paintGhost(ctx, view, scene, moment) {
  ctx.globalAlpha = 0.9;
  ctx.setLineDash([4, 3]);
  for (let i = 0; i < scene.bodies.length; ++i) {
    if (!moment.present[i]) continue;
    const body = scene.bodies[i];
    ctx.save();
    ctx.translate(view.x(moment.x[i]), view.y(moment.y[i]));
    ctx.rotate(view.angle(moment.heading[i]));
    ctx.beginPath();
    if (body.size) {
      const [length, width] = body.size.map((v) => v * view.scale);
      ctx.rect(-length / 2, -width / 2, length, width);
      ctx.moveTo(0, 0);
      ctx.lineTo(length / 2, 0);
    } else {
      ctx.arc(0, 0, Math.max(3.5, body.radius * view.scale), 0, 7);
    }
    ctx.lineWidth = 2;
    ctx.strokeStyle = body.team === undefined ? colourOf(scene, i) : colours.trails[body.team];
    ctx.stroke();
    ctx.restore();
  }
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}
