// Shows measured impacts, each beside the answer of the student's form_lcp, and the median errors.

const slider = byId("slider");
const SLOWER = 40;
const LASTS = 0.06; // s before the impact, and after it

byId("wrong").hidden = !real.wrong;
byId("all").textContent = real.impacts.length;
byId("fitted").textContent = `mu = ${real.mu} and epsilon = ${real.epsilon}`;
byId("sentence").textContent = real.sentence;

const largest = (bars) => Math.max(...bars.map(({ error }) => error));
const most = Math.min(largest(real.bars), 3 * largest(real.bars.slice(1)));
for (const { name, error, label } of real.bars) {
  const width = `width: ${Math.min(100, (100 * error) / most)}%`;
  const bar = make("div", { class: name.startsWith("your") ? "bar own" : "bar", style: width });
  byId("bars").append(row("td", name, bar, error > most ? `${label}, beyond the chart` : label));
}

const sorted = real.impacts.sort((a, b) => (a.error ?? Infinity) - (b.error ?? Infinity));
const answered = sorted.filter(({ error }) => error !== null).length;
slider.max = sorted.length - 1;
slider.value = Math.floor((answered || sorted.length) / 2); // the median one

// Where a square with this velocity is t seconds after the impact, in sides. The corner is at the
// origin when it touches.
function at({ r: [x, y] }, [vx, vy, omega], t) {
  const turn = Math.atan2(y, x) + 0.75 * Math.PI + omega * t;
  const [X, Y] = [vx * t - x, vy * t - y].map((metres) => `${metres / real.l}px`);
  return { transform: `translate(${X}, ${Y}) rotate(${turn}rad)`, visibility: "visible" };
}

function play() {
  const hit = sorted[slider.value];
  const { before, after, mine, error } = hit;
  const isStill = media("prefers-reduced-motion: reduce").matches;
  const duration = isStill ? 0 : SLOWER * LASTS * 1000;
  const move = (id, v, from, to) => {
    const timing = { duration, delay: from < 0 ? 0 : duration, fill: "forwards" };
    byId(id).animate([at(hit, v, from), at(hit, v, to)], timing);
  };
  byId("hit").getAnimations({ subtree: true }).forEach((motion) => motion.cancel());
  move("early", before, -LASTS, -LASTS);
  move("late", before, -LASTS / 2, -LASTS / 2);
  move("measured", before, -LASTS, 0);
  move("measured", after, 0, LASTS);
  if (error !== null) move("mine", mine, 0, LASTS);
  const off = `Here yours is ${digits(error ?? 0, 2)} m/s off.`;
  byId("which").value = error === null ? "For this one solve_lcp finds no solution." : off;
}

slider.addEventListener("input", play);
byId("play").addEventListener("click", play);
play();
