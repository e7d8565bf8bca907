// ---- what is thrown ----

// The start of a throw, and all numbers that it is made with; T follows from `seconds`.
let start = { q: [0, 0.6, 0.3], v: [1, 0, 5] };
let params = { l: 0.2, m: 0.3, mu: 0.3, epsilon: 0.5, g: [0, -9.81, 0], dt: 0.001, delta: 0.001 };
let seconds = 2;
let chosen = 2; // the model of the dashed square, by how many corners may touch
let paths = []; // of each model, whichever is chosen
let version = null; // of the program that answered last

const model = (touch) => ["flight alone", "one corner", "the whole"][touch];
const tell = (sentence) => (byId("status").textContent = sentence);

async function ask(name, question) {
  const answer = await fetch(name, question && { method: "POST", body: JSON.stringify(question) });
  if (!answer.ok) throw new Error(answer.status);
  return answer.json();
}

// A motion of this many columns by the student's program; null where it gives none, and says why.
async function simulate(from, numbers, T) {
  const waiting = setTimeout(() => tell("Waiting for your program \u2026"), 1000);
  try {
    const { problem, version: asked, ...motion_ } = await ask("simulate", { ...from, params: { ...numbers, T } });
    if (version !== null && version !== asked) news = "Your program was built again: this is the same throw with the new one.";
    version = asked;
    tell(problem ? `${problem[0].toUpperCase()}${problem.slice(1).replace(/[^?]$/, "$&.")} Change your program and build it; this page notices.` : news);
    return problem ? null : motion_;
  } catch {
    tell("The program that serves this page was ended. Start ./build/bounce --play again, and open the address that it prints.");
    return null;
  } finally {
    clearTimeout(waiting);
  }
}

// What is said beside an answer, until something else is thrown.
let news = "";

// Throws it from `start`. What was asked meanwhile is asked once it is over, and only the last.
let busy = false;
let again = null;
async function throwIt(time = 0) {
  if (busy) return (again = time);
  busy = true;
  const T = Math.round(seconds / params.dt) + 1;
  const answer = await simulate(start, params, T);
  if (answer && !held) {
    paths = [0, 1, 2].map((touch) => truth(start.q, start.v, params, params.dt, T, touch));
    farthest = [answer.q, ...paths].map((path) => path[0].reduce((most, _, t) => Math.max(most, distance(path, paths[2], t)), 0));
    present({ ...answer, right: paths[chosen] }, time);
  }
  busy = false;
  if (again !== null) throwIt(again);
  again = null;
}

// Where the square's lowest corner would begin in the ground, it is lifted.
function begin(state, numbers, time = 0) {
  news = "";
  [start, params] = [structuredClone(state), structuredClone(numbers)];
  const reach = Math.max(...corners(start.q[2], params.l).map((r) => -r[1]));
  start.q[1] = Math.max(start.q[1], reach);
  showSettings();
  return throwIt(time);
}

function throwAgain() {
  begin(start, params).then(() => setPlaying(true));
}

// ---- how far from the true motion ----

const distance = (a, b, t) => Math.hypot(a[0][t] - b[0][t], a[1][t] - b[1][t], (params.l / Math.SQRT2) * (a[2][t] - b[2][t]));
const length = (metres) => (metres < 1e-6 ? "0" : metres < 0.1 ? `${Number((1000 * metres).toPrecision(3))} mm` : `${Number(metres.toPrecision(3))} m`);
let farthest = [];

function showNow() {
  if (!paths.length) return;
  [q, ...paths].forEach((path, i) => {
    const row = byId("errors").tBodies[0].rows[[0, 3, 2, 1][i]];
    row.cells[1].textContent = length(distance(path, paths[2], columnShown()));
    row.cells[2].textContent = length(farthest[i]);
  });
}

for (const touch of [null, 2, 1, 0]) {
  const row = byId("errors").tBodies[0].insertRow();
  const name = touch === null ? "your program" : `<label><input type="radio" name="model" value="${touch}"${touch === 2 ? " checked" : ""}> ${model(touch)}</label>`;
  row.innerHTML = `<th scope="row">${name}</th><td></td><td></td>`;
}
byId("errors").addEventListener("change", (event) => {
  chosen = Number(event.target.value);
  byId("dashed").textContent = chosen === 2 ? "the true motion" : `a square with less than the whole model, ${model(chosen)}`;
  present({ l, dt, delta, q, motion, right: paths[chosen] }, shown() * dt);
});

// ---- settings ----

const tilt = () => Math.atan2(params.g[0], -params.g[1]);
const tilted = (degrees) => (params.g = [9.81 * Math.sin((degrees * Math.PI) / 180), -9.81 * Math.cos((degrees * Math.PI) / 180), 0]);
const own = (name) => [() => params[name], (value) => (params[name] = value)];
// Name, unit, least, most, whether in powers of ten, and how it is read and set.
const SLIDERS = [
  ["dt", "s", 1e-4, 0.05, true, ...own("dt")],
  ["delta", "m", 1e-6, 0.02, true, ...own("delta")],
  ["epsilon", "", 0, 1, false, ...own("epsilon")],
  ["mu", "", 0, 1, false, ...own("mu")],
  ["tilt of gravity", "\u00b0", -45, 45, false, () => (tilt() * 180) / Math.PI, tilted],
  ["l", "m", 0.05, 0.5, false, ...own("l")],
  ["duration", "s", 0.2, 6, false, () => seconds, (value) => (seconds = value)],
];
const STARTS = [["x, m", "q", 0], ["y, m", "q", 1], ["theta, rad", "q", 2], ["v_x, m/s", "v", 0], ["v_y, m/s", "v", 1], ["omega, rad/s", "v", 2]];

const sliders = SLIDERS.map(([name, unit, least, most, isPower, read, set]) => {
  const label = document.createElement("label");
  const [from, to] = isPower ? [Math.log10(least), Math.log10(most)] : [least, most];
  label.innerHTML = `<span>${name}</span><input type="range" min="${from}" max="${to}" step="${isPower ? 0.01 : (to - from) / 90}"><output></output>`;
  const input = label.querySelector("input");
  const show = () => {
    const value = `${Number(read().toPrecision(3))} ${unit}`;
    label.querySelector("output").textContent = value;
    input.setAttribute("aria-valuetext", value);
  };
  input.addEventListener("input", () => {
    set(Number((isPower ? 10 ** input.value : Number(input.value)).toPrecision(3)));
    show();
    begin(start, params, shown() * dt);
  });
  byId("sliders").append(label);
  return () => {
    if (document.activeElement !== input) input.value = isPower ? Math.log10(read()) : read();
    show();
  };
});
const starts = STARTS.map(([name, of, i]) => {
  const label = document.createElement("label");
  label.innerHTML = `${name} <input type="number" step="any">`;
  const input = label.querySelector("input");
  input.addEventListener("change", () => {
    start[of][i] = Number(input.value);
    throwAgain();
  });
  byId("start").append(label);
  return () => (input.value = Number(start[of][i].toPrecision(5)));
});

function showSettings() {
  for (const show_ of [...sliders, ...starts]) show_();
}

// ---- scenes ----

// Those in which methods fail: a name, the scene, and what is changed in it.
const FAILURES = [
  ["Energy from nowhere", "tumble epsilon=1 mu=0.4 dt=0.001 seconds=3"],
  ["Too fast for its step", "tumble vy=-60 dt=0.01"],
  ["At rest, it trembles", "rest dt=0.01 seconds=5"],
  ["Flat, on one corner", "flat_drop dt=0.001 seconds=2"],
  ["On a slope that should hold it", "rest tilt=15 dt=0.01 seconds=2"],
  ["Contact that is thin", "tumble delta=0.000001 dt=0.01 seconds=2"],
  ["A long run", "tumble epsilon=0.9 dt=0.001 seconds=6"],
];

// As `./build/bounce --scene` takes it: the scene's name if it is another one, and numbers.
function setScene(command) {
  const words = command.trim().split(/\s+/);
  const scene = given.scenes.find(({ name }) => name === words[0]);
  const { T, ...numbers } = scene ? scene.params : { ...params, T: 0 };
  const next = structuredClone(scene ? { q: scene.q, v: scene.v } : start);
  params = structuredClone(numbers);
  byId("scene").value = [...byId("scene").options].some(({ value }) => value === command) ? command : "";
  if (scene) seconds = Number(((T - 1) * params.dt).toPrecision(6));
  const places_ = { x: [next.q, 0], y: [next.q, 1], theta: [next.q, 2], vx: [next.v, 0], vy: [next.v, 1], omega: [next.v, 2] };
  for (const word of words.slice(scene ? 1 : 0)) {
    const [name, value] = word.split("=");
    if (name === "seconds") seconds = Number(value);
    else if (name === "tilt") tilted(Number(value));
    else if (name === "T") seconds = (Number(value) - 1) * params.dt;
    else if (name in places_) places_[name][0][places_[name][1]] = Number(value);
    else params[name] = Number(value);
  }
  return begin(next, params).then(() => setPlaying(!media("prefers-reduced-motion: reduce").matches));
}

byId("scene").append(new Option("your own throw", ""));
for (const [name, options] of [["Where methods fail", FAILURES], ["Scenes", given.scenes.map((s) => [s.title, `${s.name} dt=0.001`])]]) {
  const group = document.createElement("optgroup");
  group.label = name;
  group.append(...options.map(([title, command]) => new Option(title, command)));
  byId("scene").append(group);
}
byId("scene").addEventListener("change", () => setScene(byId("scene").value));
byId("throw").addEventListener("click", throwAgain);
keys.t = throwAgain;

// ---- holding it ----

// A spring pulls the point that is held to the pointer. Its force is gravity's to the program, which
// so moves the square, against the ground, too.
let held = null; // {arm, x, y}: the point in the square's own axes, and where it is pulled to
let state = null; // while it is held
let lastFrame = 0;

function point(event) {
  const at = camera();
  return [at.x(event.offsetX), at.y(event.offsetY)];
}

// The same force acts for `elapsed`, so the longer this is, the softer the spring has to be.
function pull({ q: [x, y, theta], v: [v_x, v_y, omega] }, elapsed) {
  const spring = Math.min(30, 0.5 / elapsed); // rad/s
  const [c, s] = [Math.cos(theta), Math.sin(theta)];
  const r = [c * held.arm[0] - s * held.arm[1], s * held.arm[0] + c * held.arm[1]];
  const inertia = (l * l) / 6;
  const share = 1 / (1 + (r[0] ** 2 + r[1] ** 2) / inertia); // of the mass that the point seems to have
  const a_x = share * (spring ** 2 * (held.x - x - r[0]) - 2 * spring * (v_x - omega * r[1]));
  const a_y = share * (spring ** 2 * (held.y - y - r[1]) - 2 * spring * (v_y + omega * r[0]));
  const [g_x, g_y] = params.g;
  return [g_x + a_x, g_y + a_y - share * g_y, (r[0] * a_y - r[1] * a_x) / inertia - 4 * omega];
}

function drawThread() {
  const at = camera();
  const [x, y, theta] = state.q;
  const [c, s] = [Math.cos(theta), Math.sin(theta)];
  ctx.beginPath();
  ctx.moveTo(at.X(x + c * held.arm[0] - s * held.arm[1]), at.Y(y + s * held.arm[0] + c * held.arm[1]));
  ctx.lineTo(at.X(held.x), at.Y(held.y));
  stroke("quiet", 2);
  disc(at.X(held.x), at.Y(held.y), 4, "quiet");
}

async function hold(now) {
  if (!held) return;
  const elapsed = Math.max(Math.min(Math.max(now - lastFrame, 4), 50) / 1000, params.dt);
  lastFrame = now;
  const T = Math.max(1, Math.round(elapsed / params.dt)) + 1;
  const answer = await simulate(state, { ...params, g: pull(state, elapsed) }, T);
  if (!held) return;
  if (!answer) return letGo();
  const last = (rows) => rows.map((row) => row[T - 1]);
  state = { q: last(answer.q), v: last(answer.motion.v) };
  load({ ...answer, right: null });
  position = T - 1;
  show();
  drawThread();
  requestAnimationFrame(hold);
}

function letGo() {
  held = null;
  byId("scene").value = "";
  begin(state, params).then(() => setPlaying(true));
}

stage.addEventListener("pointerdown", (event) => {
  const [x, y] = point(event);
  const now = pose(shown());
  const [dx, dy] = [x - now[0], y - now[1]];
  if (Math.hypot(dx, dy) > Math.max(l, 30 / camera().scale)) return setPlaying(!playing);
  setPlaying(false);
  stage.setPointerCapture(event.pointerId);
  const [c, s] = [Math.cos(now[2]), Math.sin(now[2])];
  const grip = Math.min(1, (0.6 * l) / Math.hypot(dx, dy));
  state = { q: now, v: motion ? motion.v.map((row) => row[columnShown()]) : [0, 0, 0] };
  held = { arm: [grip * (c * dx + s * dy), grip * (c * dy - s * dx)], x, y };
  lastFrame = performance.now();
  requestAnimationFrame(hold);
});
stage.addEventListener("pointermove", (event) => held && ([held.x, held.y] = point(event)));
for (const end of ["pointerup", "pointercancel"]) addEventListener(end, () => held && letGo());

// ---- experiments ----

// Explore's text: a question is a heading, paragraphs and answers that unfold.
function experiment(markdown) {
  const card = document.createElement("article");
  const escaped = (text) => text.replace(/&(?!\w+;)/g, "&amp;");
  const inline = (text) => escaped(text).replace(/\*\*(.+?)\*\*/g, "<b>$1</b>").replace(/\*(.+?)\*/g, "<em>$1</em>").replace(/\[(.+?)\]\(.+?\)/g, "$1").replace(/`(.+?)`/g, "<code>$1</code>");
  const [title, ...paragraphs] = markdown.trim().split("\n\n");
  card.innerHTML = `<h3>${inline(title)}</h3>` + paragraphs.map((text) => (text.startsWith("<") ? text : `<p>${inline(text)}</p>`)).join("\n");
  const predicted = document.createElement("textarea");
  predicted.setAttribute("aria-label", `Your prediction for ${title}`);
  predicted.placeholder = "Your prediction";
  card.querySelector("p").after(predicted);
  const answers_ = [...card.querySelectorAll("details")];
  const open = (isOpen) => answers_.forEach((answer) => (answer.hidden = !isOpen));
  open(false);
  predicted.addEventListener("input", () => open(predicted.value.trim() !== ""));
  for (const code of card.querySelectorAll("p code")) {
    const command = code.textContent.replace(/^.*--scene /, "");
    const isScene = given.scenes.some(({ name }) => name === command.split(" ")[0]);
    if (code.closest("details") || !(isScene || /^\w+=\S+$/.test(command))) continue;
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = command;
    button.addEventListener("click", () => {
      open(true);
      stage.scrollIntoView({ block: "nearest" });
      setScene(command);
    });
    code.replaceWith(button);
  }
  return card;
}

const questions = given.explore.split(/^## /m).slice(1).filter((text) => /^\d/.test(text));
byId("experiments").querySelector("div").append(...questions.map(experiment));
byId("experiments").hidden = questions.length === 0;

// ---- the page begins ----

const showColumn = show;
show = () => {
  showColumn();
  if (!held) showNow();
};

setInterval(async () => {
  const now = await ask("version").catch(() => null);
  if (now && now.version !== version && !busy && !held) throwIt();
}, 1000);
play.addEventListener("click", () => setPlaying(!playing));
speed.value = "1";
setScene(FAILURES[0][1]);
