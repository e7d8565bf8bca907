// ---- the animation begins ----

for (const element of [play, stage]) element.addEventListener("click", () => setPlaying(!playing));
if (animation.title) document.title = byId("title").textContent = animation.title;
const seconds = (animation.q[0].length - 1) * animation.dt;
speed.value = seconds > 0 && (seconds < 0.5 || seconds > 60) ? "fit" : "1";
present(animation);
if (!media("prefers-reduced-motion: reduce").matches) setPlaying(true);
