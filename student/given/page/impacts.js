// Shows measured impacts, each beside the answer of the student's form_lcp, and the median errors.

const byId = (id) => document.getElementById(id);
const [impact, slider, which] = ["hit", "slider", "which"].map(byId);
const SLOWER = 40;
const LASTS = 0.06; // s before the impact, and after it

byId("wrong").hidden = !real.wrong;
byId("all").textContent = real.impacts.length;
byId("fitted").textContent = `mu = ${real.mu} and epsilon = ${real.epsilon}`;
byId("sentence").textContent = real.sentence;

// ---- the median errors ----

const largest = (bars) => Math.max(...bars.map(({ error }) => error ?? 0));
const most = Math.min(largest(real.bars), 3 * largest(real.bars.slice(1)));
for (const { name, error, label } of real.bars) {
  const row = byId("bars").insertRow();
  const head = document.createElement("th");
  head.scope = "row";
  head.textContent = name;
  const bar = document.createElement("div");
  bar.className = name.startsWith("your") ? "bar own" : "bar";
  bar.style.width = `${Math.min(100, (100 * (error ?? 0)) / most)}%`;
  row.append(head);
  row.insertCell().append(bar);
  row.insertCell().textContent = error > most ? `${label}, beyond the chart` : label;
}

// ---- one impact ----

const sorted = [...real.impacts].sort((a, b) => (a.error ?? Infinity) - (b.error ?? Infinity));
const answered = sorted.filter(({ error }) => error !== null).length;
slider.max = sorted.length - 1;
slider.value = Math.floor((answered || sorted.length) / 2); // the median one

// The square t seconds after the impact, with the corner at the origin when it touches.
function square({ r: [x, y] }, [vx, vy, omega], t, kind) {
  const half = real.l / 2;
  const turned = (Math.atan2(y, x) * 180) / Math.PI + 135 + (omega * t * 180) / Math.PI;
  return `<rect class="${kind}" x="${-half}" y="${-half}" width="${real.l}" height="${real.l}" transform="translate(${vx * t - x} ${vy * t - y}) rotate(${turned})"/>`;
}

function draw(t) {
  const hit = sorted[slider.value];
  const shown = [square(hit, t < 0 ? hit.before : hit.after, t, "measured")];
  if (t > 0 && hit.mine[0] !== null) shown.push(square(hit, hit.mine, t, "mine"));
  const before = [-LASTS, -LASTS / 2].map((past) => square(hit, hit.before, past, "past"));
  const wide = 5 * real.l;
  impact.setAttribute("viewBox", `${-wide / 2} ${-2.5 * real.l} ${wide} ${2.8 * real.l}`);
  impact.innerHTML = `<g transform="scale(1 -1)"><path class="ground" d="M ${-9 * wide} 0 H ${9 * wide} V ${-wide} H ${-9 * wide} Z"/>${before.join("")}${shown.join("")}</g>`;
}

let began = 0;
function play() {
  const hit = sorted[slider.value];
  which.textContent = hit.error === null ? "For this one solve_lcp finds no solution." : `Here yours is ${Number(hit.error.toPrecision(2))} m/s off.`;
  began = performance.now();
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) draw(LASTS);
  else requestAnimationFrame(next);
}

function next(now) {
  const t = (now - began) / 1000 / SLOWER - LASTS;
  draw(Math.min(t, LASTS));
  if (t < LASTS) requestAnimationFrame(next);
}

slider.addEventListener("input", play);
byId("play").addEventListener("click", play);
play();
