// ---- the true motion ----

// The same square, mu and epsilon without dt and delta: in flight the formula, each impact at its own
// time, and where contact lasts, steps of 0.1 ms. `touch` is the model: so many corners may touch
// at once, 2 (the whole), 1, or 0 (flight alone). All is per mass, since m cancels.
function truth([x, y, theta], [v_x, v_y, omega], { l, mu, epsilon, g }, dt, T, touch = 2) {
  const inertia = (l * l) / 6;
  const touching = 1e-7 * l; // m, a corner this low is on the ground
  const slow = 1e-3; // m/s, an impact below this is no bounce any more
  const brief = 1e-4; // s
  const path = [[x], [y], [theta]];
  let t = 0;
  let asleep = false; // at rest, and as nothing changes, for ever

  const arms = () => corners(theta, l).map(([r_x, r_y]) => ({ r_x, r_y, gap: y + r_y }));
  const normal = ({ r_x }) => v_y + r_x * omega;
  const along = ({ r_y }) => v_x - r_y * omega;

  function push(arm, f_t, f_n) {
    v_x += f_t;
    v_y += f_n;
    omega += (arm.r_x * f_n - arm.r_y * f_t) / inertia;
  }

  // Pushes corner after corner until none has to be pushed any more: each leaves at `bounce` times
  // the speed at which it came, or isn't pushed; and friction stops it, or is all it can be.
  function collide(low, bounce) {
    const pushes = low.map((arm) => ({ arm, f_n: 0, f_t: 0, leaves: bounce * Math.max(-normal(arm), 0) }));
    for (let round = 0, change = 1; round < 500 && change > 1e-11; ++round) {
      change = 0;
      for (const push_ of pushes) {
        const { arm, leaves } = push_;
        const f_n = Math.max(push_.f_n + (leaves - normal(arm)) / (1 + arm.r_x ** 2 / inertia), 0);
        change += Math.abs(f_n - push_.f_n);
        push(arm, 0, f_n - push_.f_n);
        const wanted = push_.f_t - along(arm) / (1 + arm.r_y ** 2 / inertia);
        const f_t = Math.min(Math.max(wanted, -mu * f_n), mu * f_n);
        change += Math.abs(f_t - push_.f_t);
        push(arm, f_t - push_.f_t, 0);
        Object.assign(push_, { f_n, f_t });
      }
    }
    return pushes.some(({ f_n }) => f_n > 0);
  }

  function fly(h) {
    x += h * (v_x + (h / 2) * g[0]);
    y += h * (v_y + (h / 2) * g[1]);
    v_x += h * g[0];
    v_y += h * g[1];
    theta += h * omega;
  }

  // A time in which no corner can reach the ground: none is faster than with the strongest pull.
  function safe(low) {
    const pull = Math.abs(g[1]) + (l / Math.SQRT2) * omega ** 2 + 1e-12;
    return Math.min(...low.map((arm) => (normal(arm) + Math.sqrt(normal(arm) ** 2 + 2 * pull * Math.max(arm.gap - touching / 100, 0))) / pull));
  }

  // The mean of the velocities before and after moves the square.
  function press(low, h) {
    const [v, w, turn] = [v_x, v_y, omega];
    v_x += h * g[0];
    v_y += h * g[1];
    const held = collide(low, 0);
    x += (h / 2) * (v + v_x);
    y += (h / 2) * (w + v_y);
    theta += (h / 2) * (turn + omega);
    asleep = held && Math.hypot(v, w, turn, v_x, v_y, omega) < 1e-9;
    y -= Math.min(...arms().map((arm) => arm.gap), held ? Infinity : 0); // the turn moved it off the ground
  }

  for (let column = 1; column < T; ++column) {
    for (let events = 0; t < column * dt && events < 20000 && !asleep; ++events) {
      const left = column * dt - t;
      const all = arms();
      const low = all.filter((arm) => arm.gap < touching && normal(arm) < slow).sort((a, b) => normal(a) - normal(b)).slice(0, touch);
      let h = 0;
      if (low.length === 0) fly((h = touch ? Math.min(left, safe(all)) : left));
      else if (normal(low[0]) < -slow) collide(low, epsilon);
      else press(low, (h = Math.min(left, brief, safe(all.filter((arm) => arm.gap >= touching)))));
      t = h === left ? column * dt : t + h;
    }
    [x, y, theta].forEach((value, i) => path[i].push(value));
  }
  return path;
}
