// ---- picture ----

let colour = {}; // the style's colours by name
let whole = null; // the view of the whole trajectory
const wide = () => stage.clientWidth;
const high = () => stage.clientHeight;
const comparing = () => right !== null && compare.checked;
const least = 60; // pixels that the square is wide, or else the view follows it
const following = () => l * whole.scale < least && !many.length;

// A view shows the world's point (x, y), m, at the stage's (X, Y), pixels, with `scale` pixels a metre.
const view = (scale, x, y, X, Y) => ({
  scale,
  X: (a) => X + (a - x) * scale,
  Y: (b) => Y - (b - y) * scale,
  x: (A) => x + (A - X) / scale,
  y: (B) => y - (B - Y) / scale,
});

const span = (row, start = [row[0], row[0]]) => row.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], start);

function fit() {
  const margin = { left: 52, right: 28, top: 24, bottom: 52 };
  const reach = l / Math.SQRT2; // from the centre to a corner
  const [x, y] = [0, 1].map((i) => q[i].concat(...[...many, ...(right ? [right] : [])].map((path) => span(path[i]))));
  const [leftmost, rightmost] = span(x);
  const [bottom, top] = span(y, [reach, -reach]); // the ground is in view
  const width = wide() - margin.left - margin.right;
  const height = high() - margin.top - margin.bottom;
  const scale = Math.min(
    width / (rightmost - leftmost + 2 * reach),
    height / (top - bottom + 2 * reach),
    (0.3 * Math.min(width, height)) / l, // a square that hardly moves doesn't fill the stage
  );
  const spare = height - (top - bottom + 2 * reach) * scale;
  return view(scale, (leftmost + rightmost) / 2, bottom - reach, margin.left + width / 2, high() - margin.bottom - spare / 4);
}

// The view of what is drawn: the whole, or near the square, with the ground where there is room.
function camera() {
  if (!following()) return whole;
  const [x, y] = pose(shown());
  const scale = least / l;
  const Y = Math.min(high() - 52 - y * scale, high() - least - 20); // of the square, and not below
  return view(scale, x, y, wide() / 2, Math.max(Y, least + 20));
}

// The multiples of `step` from a to b. They are counted: far from 0, adding a step may change
// nothing.
function multiples(step, a, b) {
  const first = Math.ceil(a / step);
  const count = Math.min(Math.floor(b / step) - first + 1, 200) || 0;
  return Array.from({ length: count }, (_, i) => (first + i) * step);
}

// A grid of squares, numbered in metres along the lower and the left edge.
function drawGrid(at) {
  const name = (value, step) => text(value, Math.min(Math.max(0, -Math.floor(Math.log10(step))), 15)) + " m";
  const width = (step) => Math.max(...[at.x(0), at.x(wide())].map((x) => ctx.measureText(name(x, step)).width));
  let step = round125(70 / at.scale);
  for (let i = 0; i < 20 && width(step) + 24 > step * at.scale; ++i) step = round125(1.5 * step);

  ctx.fillStyle = colour.quiet;
  ctx.textAlign = "left";
  ctx.beginPath();
  for (const x of multiples(step, at.x(0), at.x(wide()))) {
    const X = Math.round(at.X(x)) + 0.5;
    ctx.moveTo(X, 0);
    ctx.lineTo(X, high());
    if (X > 0 && X + width(step) + 10 < wide()) ctx.fillText(name(x, step), X + 5, high() - 10);
  }
  for (const y of multiples(step, at.y(high()), at.y(0))) {
    const Y = Math.round(at.Y(y)) + 0.5;
    ctx.moveTo(0, Y);
    ctx.lineTo(wide(), Y);
    if (Y > 20 && Y < high() - 28) ctx.fillText(name(y, step), 10, Y - 5);
  }
  stroke("grid", 1);
}

function stroke(name, width) {
  ctx.strokeStyle = colour[name];
  ctx.lineWidth = width;
  ctx.stroke();
}

function disc(X, Y, radius, fill) {
  ctx.beginPath();
  ctx.arc(X, Y, radius, 0, 2 * Math.PI);
  if (!fill) return;
  ctx.fillStyle = colour[fill];
  ctx.fill();
}

function drawGround(at) {
  ctx.fillStyle = colour.ground;
  ctx.fillRect(0, at.Y(0), wide(), Math.max(high() - at.Y(0), 0));
  ctx.fillStyle = colour["ground-line"];
  ctx.fillRect(0, at.Y(0), wide(), 1.5);
}

// The path of the centre up to s, with dots where a corner is in contact. Points that would fall on
// the last one are left out, and so are those too far off for a canvas to draw.
function drawTrace(at, s, of = q, points = lows, name = "square") {
  let [lastX, lastY] = [Infinity, 0];
  const dots = [];
  ctx.beginPath();
  for (let t = 0; t <= Math.min(s, of[0].length - 1) + 1; ++t) {
    const [x, y] = t <= s ? column(t, of) : pose(s, of);
    const [X, Y] = [at.X(x), at.Y(y)];
    const far = !(Math.abs(X) + Math.abs(Y) < 1e6);
    if (t <= s && t < points.length && points[t].y < delta) dots.push(points[t]);
    if (!far && Math.abs(X - lastX) + Math.abs(Y - lastY) < 1) continue;
    if (lastX < Infinity && !far) ctx.lineTo(X, Y);
    else ctx.moveTo(X, Y);
    [lastX, lastY] = far ? [Infinity, 0] : [X, Y];
  }
  stroke(name, name === "square" ? 1.5 : 1);
  let last = Infinity;
  for (const { x, y } of dots) {
    if (Math.abs(at.X(x) - last) < 2 || !(Math.abs(at.X(x)) < 1e6)) continue;
    disc((last = at.X(x)), at.Y(y), 2.5, name === "square" ? "corner" : name);
  }
}

// Makes the square's outline the current path, and returns its corners on the stage.
function outline(at, [x, y, theta]) {
  const c = corners(theta).map(([r_x, r_y]) => [at.X(x) + r_x * at.scale, at.Y(y) - r_y * at.scale]);
  ctx.beginPath();
  for (const corner of c) ctx.lineTo(...corner);
  ctx.closePath();
  return c;
}

// Past positions of the square at equal steps of time, as under a stroboscope.
function drawPast(at, s) {
  const every = round125(Math.max(T / 20, 1));
  ctx.globalAlpha = 0.28;
  for (let t = 0; t < s; t += every) {
    outline(at, column(t));
    stroke("square", 1);
  }
  ctx.globalAlpha = 1;
}

// The square, with a line along its own x axis and a ring at its lowest corner, filled in contact.
function drawSquare(at, now) {
  const low = lowest(now);
  const c = outline(at, now);
  ctx.fillStyle = colour.square;
  ctx.globalAlpha = 0.22;
  ctx.fill();
  ctx.globalAlpha = 1;
  ctx.moveTo(at.X(now[0]), at.Y(now[1]));
  ctx.lineTo((c[0][0] + c[3][0]) / 2, (c[0][1] + c[3][1]) / 2);
  stroke("square", 2);
  disc(...c[low.k], Math.min(5, Math.max(2, (l * at.scale) / 5)), low.y < delta ? "corner" : "card");
  stroke("corner", 2);
}

// The true square, dashed.
function drawRight(at, s) {
  ctx.setLineDash([6, 4]);
  drawTrace(at, s, right, lowsRight, "right");
  outline(at, pose(s, right));
  stroke("right", 2);
  ctx.setLineDash([]);
}

const echo = 0.25; // s of real time: a bounce lasts one step, too short to be seen

// The force of the ground at its corner; the longest arrow is a quarter of the stage. While
// playing, forces of the previous columns stay visible in a pale colour; a paused picture shows
// only its own.
function drawForces(at) {
  const now = columnShown();
  const pixels = Math.min(high() / 4, 120) / strongest;
  const back = Math.min(echo * rate(), 200);
  for (let t = playing ? Math.max(0, Math.ceil(position - 1 - back)) : now; t <= now; ++t) {
    if (!forces[t]) continue;
    const [X, Y] = [at.X(lows[t].x), at.Y(lows[t].y)];
    if (!(Math.abs(X) + Math.abs(Y) < 1e6)) continue;
    ctx.globalAlpha = t === now ? 1 : 0.5 * (1 - (position - t - 1) / back);
    arrow(X, Y, X + forces[t][0] * pixels, Y - forces[t][1] * pixels);
  }
  ctx.globalAlpha = 1;
}

function arrow(X, Y, toX, toY) {
  const length = Math.hypot(toX - X, toY - Y);
  if (!(length > 1)) return;
  const [x, y] = [(toX - X) / length, (toY - Y) / length];
  const head = Math.min(9, length / 2);
  ctx.beginPath();
  ctx.moveTo(X, Y);
  ctx.lineTo(toX, toY);
  for (const side of [-0.5, 0.5]) {
    ctx.moveTo(toX, toY);
    ctx.lineTo(toX - head * (x + side * y), toY - head * (y - side * x));
  }
  stroke("force", 3);
}

// Many squares, and the ways of their centres.
function drawMany(at, s) {
  if (!many.length) return;
  ctx.beginPath();
  for (const [x, y] of many) for (let t = 0; t <= s; t += 2) ctx[t ? "lineTo" : "moveTo"](at.X(x[t]), at.Y(y[t]));
  ctx.globalAlpha = 0.12;
  stroke("square", 1);
  ctx.globalAlpha = 0.45;
  for (const path of many) {
    outline(at, pose(s, path));
    stroke("square", 1);
  }
  ctx.globalAlpha = 1;
}

function drawScene(at) {
  drawGround(at);
  drawGrid(at);
  drawMany(at, shown());
  drawPast(at, shown());
  drawTrace(at, shown());
  if (comparing()) drawRight(at, shown());
  drawSquare(at, pose(shown()));
  drawForces(at);
}

function draw() {
  if (!whole) return;
  ctx.clearRect(0, 0, wide(), high());
  ctx.font = "12px system-ui, -apple-system, sans-serif";
  drawScene(camera());
  drawPlots();
}

function show() {
  if (!q) return; // nothing yet
  showText();
  draw();
}
