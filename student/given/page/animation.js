// ---- the animation begins ----

for (const element of [play, stage]) element.addEventListener("click", () => setPlaying(!playing));
if (animation.title) document.title = byId("title").textContent = animation.title;
const seconds = (animation.q[0].length - 1) * animation.dt;
speed.value = seconds > 0 && (seconds < 0.5 || seconds > 60) ? "fit" : "1";

// The true motion from the same start; null where that isn't known, or grows beyond all bounds.
function trueMotion({ q, motion, l, dt }) {
  if (!motion) return null;
  const [start, velocity] = [q, motion.v].map((rows) => rows.map((row) => row[0]));
  const path = truth(start, velocity, { l, ...motion }, dt, q[0].length);
  return path.flat().every(Number.isFinite) ? path : null;
}

present({ ...animation, right: trueMotion(animation) });
if (!media("prefers-reduced-motion: reduce").matches) setPlaying(true);
