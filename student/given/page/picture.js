const stage = byId("stage");
const wide = () => stage.clientWidth;
const high = () => stage.clientHeight;
const comparing = () => right !== null && byId("compare").checked;

let whole = null; // the view of the whole trajectory
const least = 60; // pixels that the square is wide, or else the view follows it

// A view shows the world's point (x, y), m, at the stage's (X, Y), pixels, with `scale` pixels a
// metre. What is too far off to be drawn is drawn nearer.
const near = (pixels) => between(-1e6, pixels, 1e6);
const view = (scale, x, y, X, Y) => ({
  scale,
  to: (a, b) => [near(X + (a - x) * scale), near(Y - (b - y) * scale)],
  from: (A, B) => [x + (A - X) / scale, y - (B - Y) / scale],
});

function fit() {
  const reach = l / Math.SQRT2; // from the centre to a corner
  const paths = right ? [q, right, ...many] : [q, ...many];
  const [left, rightmost] = span(paths.flatMap((path) => span(path[0])));
  const [bottom, top] = span(paths.flatMap((path) => span(path[1])), [reach, -reach]); // and ground
  const [width, height] = [wide() - 80, high() - 76]; // within the margins
  const scale = Math.min(
    width / (rightmost - left + 2 * reach),
    height / (top - bottom + 2 * reach),
    (0.3 * Math.min(width, height)) / l, // a square that hardly moves doesn't fill the stage
  );
  const spare = height - (top - bottom + 2 * reach) * scale;
  const Y = high() - 52 - spare / 4;
  return view(scale, (left + rightmost) / 2, bottom - reach, 52 + width / 2, Y);
}

// The view of what is drawn: the whole, or near the square, with the ground where there is room.
function camera() {
  if (l * whole.scale >= least || many.length) return whole;
  const [x, y] = pose(shown());
  const scale = least / l;
  const Y = between(least + 20, high() - 52 - y * scale, high() - least - 20);
  return view(scale, x, y, wide() / 2, Y);
}

// The stage's paths have names, and the style their looks.
const set = (id, d) => byId(id).setAttribute("d", d);
const through = (points) => `M ${points.join(" L ")} `;

// Points without those that would fall on the last one.
function thinned(points) {
  let last = [Infinity, 0];
  const isNew = ([X, Y]) => Math.abs(X - last[0]) + Math.abs(Y - last[1]) >= 1;
  return points.filter((point) => isNew(point) && (last = point));
}

// The way of the centre up to s.
function way(at, s, path) {
  const places = path[0].slice(0, s + 1).map((x, t) => at.to(x, path[1][t]));
  return through([...thinned(places), at.to(...pose(s, path))]);
}

// Where lowest corners were in contact up to s.
function contacts(at, s, lows) {
  const touching = lows.slice(0, s + 1).filter(({ y }) => y < delta);
  return thinned(touching.map(({ x, y }) => at.to(x, y))).map((dot) => `M ${dot} h 0 `).join("");
}

// The corners on the stage.
function cornersOn(at, [x, y, theta]) {
  const [X, Y] = at.to(x, y);
  return corners(theta).map(([r_x, r_y]) => [X + r_x * at.scale, Y - r_y * at.scale]);
}

const outline = (at, pose) => `${through(cornersOn(at, pose))}Z `;

// The force of the ground at its corner; the longest arrow is a quarter of the stage.
function arrow(at, t) {
  const [x, y] = (forces[t] ?? [0, 0]).map((f) => (f * Math.min(high() / 4, 120)) / strongest);
  const [X, Y] = at.to(lows[t].x, lows[t].y);
  const head = Math.min(9 / Math.hypot(x, y), 0.5);
  const tip = [X + x, Y - y];
  const barb = (side) => [tip[0] - head * (x + side * y), tip[1] + head * (y - side * x)];
  return Math.hypot(x, y) > 1 ? through([[X, Y], tip, barb(-0.5), tip, barb(0.5)]) : "";
}

// The ground, and a grid of squares, numbered in metres along the lower and the left edge.
function drawGround(at) {
  const [[left, top], [rightmost, bottom]] = [at.from(0, 0), at.from(wide(), high())];
  const step = round125(100 / at.scale);
  const places = between(0, -Math.floor(Math.log10(step)), 15);
  const label = (value, X, Y) => make("text", { x: X, y: Y }, `${text(value, places)} m`);
  const [columns, rows] = [multiples(step, left, rightmost), multiples(step, bottom, top)];
  const X = columns.map((x) => Math.round(at.to(x, 0)[0]) + 0.5);
  const Y = rows.map((y) => Math.round(at.to(0, y)[1]) + 0.5);
  byId("grid").replaceChildren(
    ...X.map((X) => path("grid", `M ${X} 0 V ${high()}`)),
    ...Y.map((Y) => path("grid", `M 0 ${Y} H ${wide()}`)),
    ...columns.map((x, i) => (X[i] < wide() - 60 ? label(x, X[i] + 5, high() - 10) : "")),
    ...rows.map((y, i) => (16 < Y[i] && Y[i] < high() - 28 ? label(y, 10, Y[i] - 5) : "")),
  );
  set("ground", `M -9 ${at.to(0, 0)[1]} H ${wide() + 9} V ${high() + 9} H -9 Z`);
}

const echo = 0.25; // s of real time: a bounce lasts one step, too short to be seen

let grounded = null; // the view of which the ground is

function draw(at, s) {
  if (at !== grounded) drawGround((grounded = at));
  set("squares", many.map((path) => outline(at, pose(s, path))).join(""));
  // Past positions of the square at equal steps of time, as under a stroboscope.
  const past = multiples(round125(Math.max(T / 20, 1)), 0, s);
  set("past", past.map((t) => outline(at, column(t))).join(""));
  set("way", way(at, s, q));
  set("contacts", contacts(at, s, lows));
  byId("ghost").toggleAttribute("hidden", !comparing());
  if (comparing()) {
    set("true-way", way(at, s, right));
    set("true-contacts", contacts(at, s, lowsRight));
    set("true-square", outline(at, pose(s, right)));
  }
  // The square, with a line along its own x axis and a ring at its lowest corner.
  const [low, ends] = [lowest(pose(s)), cornersOn(at, pose(s))];
  const front = [0, 1].map((i) => (ends[0][i] + ends[3][i]) / 2);
  set("square", outline(at, pose(s)) + through([at.to(...pose(s)), front]));
  set("low", `M ${ends[low.k]} h 0`);
  set("air", low.y < delta ? "" : `M ${ends[low.k]} h 0`);
  // While playing, forces of the previous columns stay visible in a pale colour; a paused picture
  // shows only its own.
  const now = columnShown();
  const first = Math.max(0, position - 1 - Math.min(echo * rate(), 200));
  set("echo", playing ? multiples(1, first, now - 1).map((t) => arrow(at, t)).join("") : "");
  set("force", arrow(at, now));
}
