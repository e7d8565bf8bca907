// ---- time ----

const [play, slider, speed] = ["play", "slider", "speed"].map(byId);
const rest = 0.8; // s that the last column is shown before the loop starts again
let position = 0; // in columns, from 0 to T - 1 and beyond during the rest
let playing = false;
let clock = null; // ms, when the position was last moved on
let frame = 0; // the next frame's handle

const shown = () => Math.min(position, T - 1);
const columnShown = () => Math.floor(shown());

// Columns per second. The bound keeps it finite for the tiniest dt.
function rate() {
  const all = Math.max(T - 1, 1) / 10;
  return Math.min(speed.value === "fit" ? all : Number(speed.value) / dt, 1e12);
}

function tick(now) {
  const elapsed = Math.max(now - (clock ?? now), 0) / 1000;
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
  position = between(0, t, T - 1);
  show();
}

// ---- what the reader sees ----

let showMore = () => {}; // what a page adds

function text(value, digits) {
  const fixed = digits > 15 ? "" : value.toFixed(digits);
  const short = fixed && fixed.length <= 17 ? fixed : value.toExponential(6);
  return (Number(short) === 0 ? short.replace("-", "") : short).replace(/-/g, "\u2212");
}

function show() {
  if (!whole) return; // nothing yet
  const t = columnShown();
  const time = text(t * dt, timePlaces);
  const [x, y, phi] = [q[0][t], q[1][t], lows[t].y].map((value) => text(value, places));
  const [f_t, f_n] = forces[t]?.map((f) => text(f, 1)) ?? ["\u2013", "\u2013"];
  const numbers = { time, x, y, theta: text(q[2][t], 4), f_t, f_n, phi, column: `${t} / ${T - 1}` };
  for (const id in numbers) byId(id).textContent = numbers[id];
  byId("contact").hidden = !(lows[t].y < delta);
  slider.value = t;
  slider.setAttribute("aria-valuetext", `step ${t} of ${T - 1}, ${time} seconds`);
  play.setAttribute("aria-label", playing ? "Pause" : "Play");
  const sign = playing ? "M4 3h4v14H4zM12 3h4v14h-4z" : "M5 2.5v15l13-7.5z";
  play.querySelector("path").setAttribute("d", sign);
  draw(camera(), shown());
  showNumbers();
  showMore();
}

function redraw() {
  if (!q) return;
  size = [stage.clientWidth, stage.clientHeight];
  fit();
  set("ways", many.map((path) => way(T - 1, path)).join(""));
  layOut();
  show();
}

// Shows this from its start on, or at the same time as what was shown before.
function present(animation, time = 0) {
  load(animation);
  position = Math.min(Math.round(time / dt), T - 1);
  const [g_x, g_y] = motion?.g ?? [0, 0];
  slope = g_y < 0 ? Math.atan2(-g_x, -g_y) : 0;
  for (const id of ["gravity", "sloping"]) byId(id).toggleAttribute("hidden", slope === 0);
  const [step, side] = [dt, l].map((value) => digits(value, 6));
  byId("about").textContent = `T = ${T}, dt = ${step} s, l = ${side} m`;
  byId("column").style.minWidth = `${2 * String(T - 1).length + 2}ch`;
  slider.max = T - 1;
  byId("crowd").hidden = !many.length;
  for (const id of ["choice", "key"]) byId(id).hidden = !right;
  for (const id of ["forces", "tangential", "normal"]) byId(id).hidden = !motion;
  redraw();
}

// ---- what the reader does ----

const keys = {
  " ": () => setPlaying(!playing),
  ArrowLeft: () => seek(columnShown() - 1),
  ArrowRight: () => seek(columnShown() + 1),
  Home: () => seek(0),
  End: () => seek(T - 1),
  c: () => right && byId("compare").click(),
};

document.addEventListener("keydown", (event) => {
  const act = keys[event.key];
  // What has the focus handles some keys itself.
  const own = event.key === " " ? "button, summary, [type=checkbox]" : "[type=range]";
  const takes = event.target.matches(`select, [type=number], ${own}`);
  if (!act || takes || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  act();
});
slider.addEventListener("input", () => seek(Number(slider.value)));
play.addEventListener("click", () => setPlaying(!playing));
byId("compare").addEventListener("change", redraw);
const watching = new ResizeObserver(redraw);
for (const element of [stage, byId("plots")]) watching.observe(element);
