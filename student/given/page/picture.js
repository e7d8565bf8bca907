const stage = byId("stage");
let size = [0, 0]; // its own, in pixels; to ask it in each frame would lay the page out each time
const [wide, high] = [() => size[0], () => size[1]];
const comparing = () => right !== null && byId("compare").checked;

let whole = null; // the view of the whole trajectory
let base = null; // the view for which ways are drawn: the stage's, but for a shift
let middle = [0, 0]; // of the trajectory
const least = 60; // pixels that the square is wide, or else the view follows it

// A view shows the world's point (x, y), m, at the stage's (X, Y), pixels, with `scale` pixels a
// metre, turned so that gravity points down. What is too far off to be drawn is drawn nearer.
const near = (pixels) => between(-1e6, pixels, 1e6);
const view = (scale, x, y, X, Y) => ({
  scale,
  to: (a, b) => {
    const [right, up] = turned(slope, [a - x, b - y]);
    return [near(X + right * scale), near(Y - up * scale)];
  },
  from: (A, B) => {
    const [right, up] = turned(-slope, [(A - X) / scale, (Y - B) / scale]);
    return [x + right, y + up];
  },
});

function fit() {
  const reach = l / Math.SQRT2; // from the centre to a corner
  const paths = right ? [q, right, ...many] : [q, ...many];
  const centres = paths.flatMap(([xs, ys]) => xs.map((x, t) => [x, ys[t]]));
  const onGround = span(centres.map(([x]) => x)).map((x) => [x, reach]);
  const points = [...centres, ...onGround].map((point) => turned(slope, point));
  const [left, rightmost] = span(points.map(([x]) => x));
  const [bottom, top] = span(points.map(([, y]) => y));
  const [width, height] = [wide() - 80, high() - 76]; // within the margins
  const scale = Math.min(
    width / (rightmost - left + 2 * reach),
    height / (top - bottom + 2 * reach),
    (0.3 * Math.min(width, height)) / l, // a square that hardly moves doesn't fill the stage
  );
  const spare = height - (top - bottom + 2 * reach) * scale;
  const Y = high() - 52 - spare / 4;
  middle = turned(-slope, [(left + rightmost) / 2, bottom - reach]);
  whole = view(scale, ...middle, 52 + width / 2, Y);
  base = l * scale >= least || many.length ? whole : view(least / l, ...middle, 0, 0);
}

// The view of what is drawn: the whole, or near the square, with the ground where there is room.
function camera() {
  if (base === whole) return whole;
  const [x, y] = pose(shown());
  const scale = least / l;
  const Y = between(least + 20, high() - 52 - y * scale, high() - least - 20);
  return view(scale, x, y, wide() / 2, Y);
}

// The stage's paths have names, and the style their looks.
const set = (id, d) => byId(id).setAttribute("d", d);
const through = (points) => `M ${points.join(" L ")} `;
const inPixels = (place) => place.map((pixels) => pixels.toFixed(1)).join(" ");

// Points {t, x, y} of `of` up to column s, as texts, without those that would fall on the last one.
// They are found once for a base, and not anew for each frame.
let [foundIn, found] = [null, null];
function upTo(s, of, points) {
  if (base !== foundIn) [foundIn, found] = [base, new WeakMap()];
  if (!found.has(of)) {
    let last = [Infinity, 0];
    const isNew = ([X, Y]) => Math.abs(X - last[0]) + Math.abs(Y - last[1]) >= 1;
    const all = points().map(({ t, x, y }) => ({ t, place: base.to(x, y) }));
    const kept = all.filter(({ place }) => isNew(place) && (last = place));
    found.set(of, kept.map(({ t, place }) => ({ t, text: inPixels(place) })));
  }
  return found.get(of).filter(({ t }) => t <= s).map(({ text }) => text);
}

// The way of the centre up to s.
function way(s, path) {
  const points = () => path[0].map((x, t) => ({ t, x, y: path[1][t] }));
  return through([...upTo(s, path, points), inPixels(base.to(...pose(s, path)))]);
}

// Where lowest corners were in contact up to s.
function contacts(s, lows) {
  const points = () => lows.map((low, t) => ({ t, ...low })).filter(({ y }) => y < delta);
  return upTo(s, lows, points).map((dot) => `M ${dot} h 0 `).join("");
}

// The corners on the stage.
function cornersOn(at, [x, y, theta]) {
  const [X, Y] = at.to(x, y);
  return corners(theta + slope).map(([r_x, r_y]) => [X + r_x * at.scale, Y - r_y * at.scale]);
}

const outline = (at, pose) => `${through(cornersOn(at, pose))}Z `;

// The force of the ground at its corner; the longest arrow is a quarter of the stage.
function arrow(at, t) {
  if (!forces[t]) return "";
  const [x, y] = turned(slope, forces[t]).map((f) => (f * Math.min(high() / 4, 120)) / strongest);
  const [X, Y] = at.to(lows[t].x, lows[t].y);
  const head = Math.min(9 / Math.hypot(x, y), 0.5);
  const tip = [X + x, Y - y];
  const barb = (side) => [tip[0] - head * (x + side * y), tip[1] + head * (y - side * x)];
  return Math.hypot(x, y) > 1 ? through([[X, Y], tip, barb(-0.5), tip, barb(0.5)]) : "";
}

// The ground, and a grid of squares, numbered in metres along the lower and the left edge.
function drawGround(at) {
  const [W, H] = size;
  const ends = [[0, 0], [W, 0], [0, H], [W, H]].map((end) => at.from(...end));
  const [x_0, y_0] = at.from(W / 2, H / 2);
  // Where the line of an x is at a height of the stage, and that of a y at a width.
  const lean = Math.tan(slope);
  const X = (x, height, [a, b] = at.to(x, y_0)) => a + lean * (height - b);
  const Y = (y, width, [a, b] = at.to(x_0, y)) => b - lean * (width - a);
  const crisp = (pixels) => Math.round(pixels) + 0.5;
  const step = round125(100 / at.scale);
  const places = between(0, -Math.floor(Math.log10(step)), 15);
  const label = (value, X, Y) => make("text", { x: X, y: Y }, `${text(value, places)} m`);
  const [columns, rows] = [0, 1].map((i) => multiples(step, ...span(ends.map((end) => end[i]))));
  const isWithin = (y) => 16 < Y(y, 10) && Y(y, 10) < H - 28;
  byId("grid").replaceChildren(
    ...columns.map((x) => path("grid", `M ${crisp(X(x, 0))} 0 L ${crisp(X(x, H))} ${H}`)),
    ...rows.map((y) => path("grid", `M 0 ${crisp(Y(y, 0))} L ${W} ${crisp(Y(y, W))}`)),
    ...columns.filter((x) => X(x, H) < W - 60).map((x) => label(x, X(x, H - 10) + 5, H - 10)),
    ...rows.filter(isWithin).map((y) => label(y, 10, Y(y, 10) - 5)),
  );
  set("ground", `M -9 ${Y(0, -9)} L ${W + 9} ${Y(0, W + 9)} V ${H + 9} H -9 Z`);
}

const echo = 0.25; // s of real time: a bounce lasts one step, too short to be seen

let grounded = null; // the view of which the ground is

function draw(at, s) {
  if (at !== grounded) drawGround((grounded = at));
  const [from, to] = [base, at].map((view) => view.to(...middle));
  const shift = `translate(${to[0] - from[0]} ${to[1] - from[1]})`;
  for (const id of ["way", "contacts", "true-way", "true-contacts"])
    byId(id).setAttribute("transform", shift);
  set("squares", many.map((path) => outline(at, pose(s, path))).join(""));
  // Past positions of the square at equal steps of time, as under a stroboscope.
  const past = multiples(round125(Math.max(T / 20, 1)), 0, s);
  set("past", past.map((t) => outline(at, column(t))).join(""));
  set("way", way(s, q));
  set("contacts", contacts(s, lows));
  byId("ghost").toggleAttribute("hidden", !comparing());
  if (comparing()) {
    set("true-way", way(s, right));
    set("true-contacts", contacts(s, lowsRight));
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
