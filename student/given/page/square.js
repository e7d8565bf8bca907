// What is drawn: {l, dt, delta, q, motion, right, many}. q is three rows; motion is {m, mu, epsilon, g, v},
// or null if velocities aren't known; right is the true q, or null; many holds more of them.
let l, dt, delta, q, motion, right, many;
let T, lows, lowsRight, forces, strongest, places, timePlaces;
const byId = (id) => document.getElementById(id);
const [stage, plots, play, slider, speed, compare] = ["stage", "plots", "play", "slider", "speed", "compare"].map(byId);
const ctx = stage.getContext("2d");
const media = (query) => matchMedia(`(${query})`);

// ---- the square ----

// The corners relative to the centre, r_k = R(theta) s_k, eqs. (3) and (5).
function corners(theta, side = l) {
  const c = (side / 2) * Math.cos(theta);
  const s = (side / 2) * Math.sin(theta);
  return [[c - s, s + c], [-c - s, c - s], [s - c, -s - c], [c + s, s - c]];
}

// The lowest corner: its number k, where it is, and so its height y = phi, eq. (4).
function lowest([x, y, theta]) {
  const r = corners(theta);
  const k = r.reduce((best, [, height], i) => (height < r[best][1] ? i : best), 0);
  return { k, x: x + r[k][0], y: y + r[k][1] };
}

const column = (t, of = q) => of.map((row) => row[t]);

// The square's pose at column s, interpolated linearly between two columns if s isn't whole.
function pose(s, of = q) {
  const last = of[0].length - 1;
  const t = Math.min(Math.floor(s), last);
  const next = column(Math.min(t + 1, last), of);
  return column(t, of).map((value, i) => value + Math.min(s - t, 1) * (next[i] - value));
}

// ---- forces and energies ----

// The force of the ground in the step from column t, (f_t, f_n) in N: eq. (13) solved for the
// force, f = M ((v' - v) / dt - g). Null without contact at the start of the step, eq. (11).
function force(t) {
  if (!motion || t + 1 >= T || !(lows[t].y < delta)) return null;
  const { m, g, v } = motion;
  return [0, 1].map((i) => m * ((v[i][t + 1] - v[i][t]) / dt - g[i]));
}

// Kinetic and potential energy and their sum, J; the potential is 0 at the world's origin.
function energies(t) {
  const { m, g, v } = motion;
  const kinetic = (m / 2) * (v[0][t] ** 2 + v[1][t] ** 2 + ((l * l) / 6) * v[2][t] ** 2);
  const potential = -m * (g[0] * q[0][t] + g[1] * q[1][t]);
  return { kinetic, potential, total: kinetic + potential };
}

// ---- what is drawn ----

function load(animation) {
  ({ l, dt, delta, q, motion, right = null, many = [] } = animation);
  T = q[0].length;
  lows = q[0].map((_, t) => lowest(column(t)));
  lowsRight = right ? right[0].map((_, t) => lowest(column(t, right))) : [];
  forces = q[0].map((_, t) => force(t));
  strongest = forces.reduce((most, f) => (f ? Math.max(most, Math.hypot(...f)) : most), 0);
  places = Math.max(0, Math.ceil(3 - Math.log10(l))); // a length is shown to a thousandth of the side
  timePlaces = Math.max(2, Math.ceil(-Math.log10(dt)));
}

// ---- time ----

const rest = 0.8; // s that the last column is shown before the loop starts again
let position = 0; // in columns, from 0 to T - 1 and beyond during the rest
let playing = false;
let clock = null; // ms, when the position was last moved on
let frame = 0; // the next frame's handle

const shown = () => Math.min(position, T - 1);
const columnShown = () => Math.floor(shown());
// Columns per second. The bound keeps it finite for the tiniest dt.
const rate = () => Math.min(speed.value === "fit" ? Math.max(T - 1, 1) / 10 : Number(speed.value) / dt, 1e12);

function tick(now) {
  const elapsed = clock === null ? 0 : Math.max(now - clock, 0) / 1000;
  clock = now;
  position = (position + elapsed * rate()) % (T - 1 + rest * rate());
  show();
  frame = requestAnimationFrame(tick);
}

function setPlaying(on) {
  if (on === playing || !q) return;
  playing = on;
  clock = null;
  position = columnShown();
  if (on) frame = requestAnimationFrame(tick);
  else cancelAnimationFrame(frame);
  show();
}

function seek(t) {
  setPlaying(false);
  position = Math.min(Math.max(t, 0), T - 1);
  show();
}

// ---- text ----

function text(value, digits) {
  const fixed = digits > 15 ? "" : value.toFixed(digits);
  const short = fixed && fixed.length <= 17 ? fixed : value.toExponential(6);
  return (Number(short) === 0 ? short.replace("-", "") : short).replace(/-/g, "\u2212");
}

function showText() {
  const t = columnShown();
  const [x, y, theta] = column(t);
  const numbers = {
    time: text(t * dt, timePlaces),
    x: text(x, places),
    y: text(y, places),
    theta: text(theta, 4),
    phi: text(lows[t].y, places),
  };
  for (const id in numbers) byId(id).textContent = numbers[id];
  const f = forces[t];
  byId("f_t").textContent = f ? text(f[0], 1) : "\u2013";
  byId("f_n").textContent = f ? text(f[1], 1) : "\u2013";
  byId("contact").hidden = !(lows[t].y < delta);
  byId("column").textContent = `${t} / ${T - 1}`;
  slider.value = t;
  slider.setAttribute("aria-valuetext", `step ${t} of ${T - 1}, ${numbers.time} seconds`);
  play.setAttribute("aria-label", playing ? "Pause" : "Play");
  play.querySelector("path").setAttribute("d", playing ? "M4 3h4v14H4zM12 3h4v14h-4z" : "M5 2.5v15l13-7.5z");
}
