// The true motion: the same square, mu and epsilon without dt and delta. In flight the formula,
// each impact at its own time, and where contact lasts, steps of 0.1 ms. `touch` is the model: so
// many corners may touch at once, 2 (the whole), 1, or 0 (flight alone). All is per mass.
function truth([x, y, theta], [v_x, v_y, omega], { l, mu, epsilon, g, dt, T }, touch = 2) {
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

  function push({ r_x, r_y }, f_t, f_n) {
    v_x += f_t;
    v_y += f_n;
    omega += (r_x * f_n - r_y * f_t) / inertia;
  }

  // Pushes corner after corner until none has to be pushed any more: each leaves at `bounce` times
  // the speed at which it came, or isn't pushed; and friction stops it, or is all it can be.
  function collide(low, bounce) {
    for (const arm of low) {
      const leaves = bounce * Math.max(-normal(arm), 0);
      Object.assign(arm, { f_n: 0, f_t: 0, leaves });
    }
    for (let round = 0, change = 1; round < 500 && change > 1e-11; ++round) {
      change = 0;
      for (const arm of low) {
        const wanted = arm.f_n + (arm.leaves - normal(arm)) / (1 + arm.r_x ** 2 / inertia);
        const f_n = Math.max(wanted, 0);
        push(arm, 0, f_n - arm.f_n);
        const stopping = arm.f_t - along(arm) / (1 + arm.r_y ** 2 / inertia);
        const f_t = between(-mu * f_n, stopping, mu * f_n);
        push(arm, f_t - arm.f_t, 0);
        change += Math.abs(f_n - arm.f_n) + Math.abs(f_t - arm.f_t);
        Object.assign(arm, { f_n, f_t });
      }
    }
    return low.some(({ f_n }) => f_n > 0);
  }

  // A time in which no corner can reach the ground: none is faster than with the strongest pull.
  function safe(arms) {
    const pull = Math.abs(g[1]) + (l / Math.SQRT2) * omega ** 2 + 1e-12;
    const times = arms.map((arm) => {
      const fall = 2 * pull * Math.max(arm.gap - touching / 100, 0);
      return (normal(arm) + Math.sqrt(normal(arm) ** 2 + fall)) / pull;
    });
    return Math.min(...times);
  }

  // The mean of the velocities before and after moves the square; in flight that is exact.
  function move(h, low) {
    const before = [v_x, v_y, omega];
    v_x += h * g[0];
    v_y += h * g[1];
    const held = collide(low, 0);
    x += (h / 2) * (before[0] + v_x);
    y += (h / 2) * (before[1] + v_y);
    theta += (h / 2) * (before[2] + omega);
    const gaps = arms().map((arm) => arm.gap); // it turned off the ground, or into it
    if (low.length) y -= Math.min(...gaps, held ? Infinity : 0);
    asleep = held && Math.hypot(...before, v_x, v_y, omega) < 1e-9;
  }

  for (let column = 1; column < T; ++column) {
    for (let events = 0; t < column * dt && events < 20000 && !asleep; ++events) {
      const all = arms();
      const low = all.filter((arm) => arm.gap < touching && normal(arm) < slow);
      low.sort((a, b) => normal(a) - normal(b)).splice(touch);
      if (low.length && normal(low[0]) < -slow) {
        collide(low, epsilon);
        continue;
      }
      const left = column * dt - t;
      const others = low.length ? all.filter((arm) => arm.gap >= touching) : all;
      const h = Math.min(left, low.length ? brief : Infinity, touch ? safe(others) : Infinity);
      move(h, low);
      t = h === left ? column * dt : t + h;
    }
    [x, y, theta].forEach((value, i) => path[i].push(value));
  }
  return path;
}
