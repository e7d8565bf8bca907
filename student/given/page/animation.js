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
if (!media("prefers-reduced-motion: reduce").matches) setPlaying(true);
