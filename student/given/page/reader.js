// ---- what the reader does ----

function resize() {
  if (!q) return; // nothing is shown yet
  const ratio = window.devicePixelRatio || 1;
  stage.width = Math.round(wide() * ratio);
  stage.height = Math.round(high() * ratio);
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  ctx.lineJoin = "round";
  whole = fit();
  redraw();
}

function redraw() {
  const style = getComputedStyle(document.documentElement);
  const names = ["card", "quiet", "grid", "ground", "ground-line", "square", "corner", "force", "right"];
  colour = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  byId("other").hidden = !comparing();
  layOut();
  show();
}

const keys = {
  " ": () => setPlaying(!playing),
  ArrowLeft: () => seek(columnShown() - 1),
  ArrowRight: () => seek(columnShown() + 1),
  Home: () => seek(0),
  End: () => seek(T - 1),
  c: () => right && compare.click(),
};

// Whether the focused control handles this key itself.
const ownOf = (key) => (key === " " ? "button, summary, [type=checkbox], [type=radio]" : "[type=range], [type=radio]");
const answers = (target, key) => target.matches(`select, textarea, [type=number], ${ownOf(key)}`);

document.addEventListener("keydown", (event) => {
  const act = keys[event.key];
  if (!act || event.ctrlKey || event.metaKey || event.altKey || answers(event.target, event.key)) return;
  event.preventDefault();
  act();
});
slider.addEventListener("input", () => seek(Number(slider.value)));
compare.addEventListener("change", redraw);
plots.addEventListener("pointerdown", (event) => seek(columnAt(event)));
plots.addEventListener("pointermove", (event) => event.buttons && seek(columnAt(event)));
const watching = new ResizeObserver(resize);
for (const element of [stage, plots]) watching.observe(element);
media("prefers-color-scheme: dark").addEventListener("change", redraw);

// Shows this from its start on, or at the same time as what was shown before.
function present(animation, time = 0) {
  load(animation);
  position = Math.min(Math.round(time / dt), T - 1);
  byId("about").innerHTML = `<i>T</i> = ${T}, &Delta;<i>t</i> = ${Number(dt.toPrecision(6))} s, <i>l</i> = ${Number(l.toPrecision(6))} m`;
  const lengths = q.flatMap((row) => span(row)).map((value) => text(value, places).length);
  document.documentElement.style.setProperty("--longest", Math.max(...lengths));
  byId("column").style.minWidth = `${2 * String(T - 1).length + 2}ch`;
  slider.max = T - 1;
  byId("crowd").hidden = !many.length;
  for (const id of ["choice", "key"]) byId(id).hidden = !right;
  for (const id of ["forces", "tangential", "normal"]) byId(id).hidden = !motion;
  resize();
}
