// What is drawn. q is three rows; motion is {m, mu, epsilon, g, v}, or null if velocities aren't
// known; right is the true q, or null; many holds more of them.
let l, dt, delta, q, motion, right, many;
let T, lows, lowsRight, forces, strongest, places, timePlaces;
let slope = 0; // of the ground on the stage, counter-clockwise, where gravity points down

// An arm in the square's own axes, as the world sees it.
function turned(theta, [x, y]) {
  const [c, s] = [Math.cos(theta), Math.sin(theta)];
  return [c * x - s * y, s * x + c * y];
}

// The corners relative to the centre, r_k = R(theta) s_k, eqs. (3) and (5).
function corners(theta, side = l) {
  const [x, y] = turned(theta, [side / 2, side / 2]);
  return [[x, y], [-y, x], [-x, -y], [y, -x]];
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
  const t = Math.floor(s);
  const next = column(Math.min(t + 1, T - 1), of);
  return column(t, of).map((value, i) => value + (s - t) * (next[i] - value));
}

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
  return { total: kinetic + potential, kinetic, potential };
}

function load(animation) {
  ({ l, dt, delta, q, motion, right = null, many = [] } = animation);
  T = q[0].length;
  [lows, lowsRight] = [q, right].map((of) => of && of[0].map((_, t) => lowest(column(t, of))));
  forces = q[0].map((_, t) => force(t));
  strongest = forces.reduce((most, f) => Math.max(most, Math.hypot(...(f ?? [0]))), 0);
  places = Math.max(0, Math.ceil(3 - Math.log10(l))); // a length is shown to a thousandth of l
  timePlaces = Math.max(2, Math.ceil(-Math.log10(dt)));
}
