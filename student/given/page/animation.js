if (animation.title) document.title = byId("title").textContent = animation.title;
const seconds = (animation.q[0].length - 1) * animation.dt;
if (!(seconds === 0 || (seconds >= 0.5 && seconds <= 60))) speed.value = "fit";
stage.addEventListener("click", () => setPlaying(!playing));

// The true motion from the same start; null where that isn't known, or grows beyond all bounds.
function trueMotion({ q, motion, ...numbers }) {
  if (!motion) return null;
  const [start, velocity] = [q, motion.v].map((rows) => column(0, rows));
  const path = truth(start, velocity, { ...numbers, ...motion, T: q[0].length });
  return path.flat().every(Number.isFinite) ? path : null;
}

present({ ...animation, right: trueMotion(animation) });
if (animation.about) byId("about").textContent = animation.about;

// Till its first contact a right program is off by flight alone.
const last = lows.findIndex(({ y }) => y < delta) - 1;
if (right && last > 0) {
  const off = digits(100 * Math.hypot(...[0, 1].map((i) => right[i][last] - q[i][last])), 2);
  byId("apart").append(` Here, just before its first contact, it is ${off} cm off.`);
}
if (!media("prefers-reduced-motion: reduce").matches) setPlaying(true);
