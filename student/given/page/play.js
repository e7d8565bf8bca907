// ---- what is thrown ----

let thrown = {}; // all numbers of a throw, by the names that a command has
let throws = Promise.resolve(); // all answers up to the last throw's
let chosen = 1; // the path of the dashed square
let paths = []; // of the program, and the true one with up to 2 corners that touch, 1 and 0
let farthest = []; // m, that each gets from the true motion
let news = ""; // what is said beside an answer

const tell = (sentence) => (byId("status").textContent = sentence);

// A scene's numbers: gravity's size and tilt, degrees; and seconds, which it lasts, in place of T.
function numbersOf({ q: [x, y, theta], v: [vx, vy, omega], params: { T, g, ...others } }) {
  const tilt = (Math.atan2(g[0], -g[1]) * 180) / Math.PI;
  const seconds = (T - 1) * others.dt;
  return { ...others, x, y, theta, vx, vy, omega, g: Math.hypot(...g), tilt, seconds };
}

function sceneOf({ x, y, theta, vx, vy, omega, g, tilt, seconds, ...others }) {
  const down = turned((tilt * Math.PI) / 180, [0, -g]);
  const params = { ...others, g: [...down, 0], T: Math.round(seconds / others.dt) + 1 };
  return { q: [x, y, theta], v: [vx, vy, omega], params };
}

async function ask(name, question) {
  const answer = await fetch(name, question && { method: "POST", body: JSON.stringify(question) });
  if (!answer.ok) throw new Error(answer.status);
  return answer.json();
}

// A scene's motion by the student's program; null where it gives none, and says why.
async function simulate(scene) {
  const waiting = setTimeout(() => tell("Waiting for your program \u2026"), 1000);
  try {
    const { problem, ...answer } = await ask("simulate", scene);
    const sentence = problem && problem[0].toUpperCase() + problem.slice(1).replace(/[^?]$/, "$&.");
    tell(problem ? `${sentence} Change your program and build it; this page notices.` : news);
    return problem ? null : answer;
  } catch {
    const ended = "The program that serves this page was ended. Start ./build/bounce --play again";
    tell(`${ended}, and open the address that it prints.`);
    return null;
  } finally {
    clearTimeout(waiting);
  }
}

// Throws it with these numbers once earlier throws are answered, unless another follows till then;
// whether it is shown.
// Where the square's lowest corner would begin in the ground, it is lifted.
function begin(numbers, time = 0, words = "") {
  const reach = Math.max(...corners(numbers.theta, numbers.l).map(([, y]) => y));
  const mine = (thrown = { ...numbers, y: Math.max(numbers.y, reach) });
  news = words;
  showSettings();
  const run = () => mine === thrown && throwIt(sceneOf(mine), time);
  throws = throws.then(run, run);
  return throws;
}

async function throwIt(scene, time) {
  const answer = await simulate(scene);
  if (!answer || held) return false;
  paths = [answer.q, ...[2, 1, 0].map((touch) => truth(scene.q, scene.v, scene.params, touch))];
  const most = (path) => path[0].reduce((far, _, t) => Math.max(far, distance(path, t)), 0);
  farthest = paths.map(most);
  present({ ...answer, right: paths[chosen] }, time);
  return true;
}

const throwAgain = (numbers = thrown) => begin(numbers).then((isShown) => setPlaying(isShown));

// ---- how far from the true motion ----

function distance(path, t) {
  const [x, y, theta] = column(t, path).map((value, i) => value - paths[1][i][t]);
  return Math.hypot(x, y, (thrown.l / Math.SQRT2) * theta); // an angle is the way of a corner
}

function inWords(metres) {
  if (metres < 1e-6) return "0";
  return metres < 0.1 ? `${digits(1000 * metres)} mm` : `${digits(metres)} m`;
}

showMore = () => {
  if (question?.isOpen && position > 0) question.isOpen = false;
  document.body.classList.toggle("unknown", Boolean(held || question?.isOpen));
  if (held) return drawThread();
  const [now, most] = [distance(q, columnShown()), farthest[0]].map(inWords);
  const [, , one, none] = farthest.map((metres) => metres < 1e-3);
  const least = none ? "flight alone" : one ? "contact at one corner" : "contact at two corners";
  byId("errors").textContent =
    `Your program is ${now} from the true motion now, and ${most} at most. ` +
    `To be exact to a millimetre, a model needs ${least} here.`;
  if (question && position >= T - 1 && question.told !== q) compare(question);
};

byId("model").addEventListener("change", ({ target }) => {
  chosen = Number(target.value);
  byId("dashed").textContent = target.selectedOptions[0].text;
  present({ l, dt, delta, q, motion, right: paths[chosen] }, shown() * dt);
});

// ---- predictions ----

let question = null; // of the scene: the data of its option; open until it is run

// What is asked for, in the unit of the question.
const outcomes = {
  energy: () => (100 * energies(T - 1).total) / energies(0).total,
  depth: () => -100 * span(lows.map(({ y }) => y))[0],
  height: () => 1000 * span(lows.map(({ y }) => y))[1],
  spin: () => Math.abs(motion.v[2][lows.findIndex(({ y }) => y < delta) + 1]),
  way: () => 100 * Math.abs(q[0][T - 1] - q[0][0]),
  apart: () => dt * q[0].findIndex((_, t) => distance(q, t) > l),
};

function setQuestion(option) {
  if (option?.dataset.ask && q) seek(0); // what moved before says nothing of it
  question = option?.dataset.ask ? { ...option.dataset, isOpen: true } : null;
  byId("prediction").hidden = !question;
  if (!question) return;
  document.body.classList.add("unknown");
  for (const [id, words] of [["asked", question.ask], ["unit", question.unit], ["happened", ""]])
    byId(id).textContent = words;
  byId("predicted").value = "";
}

function compare({ outcome, unit, why }) {
  question.told = q;
  const number = outcomes[outcome]();
  const own = number >= 0 ? `${digits(number)} ${unit}` : "no answer";
  const { value } = byId("predicted");
  const predicted = value && `You predicted ${value} ${unit}. `;
  byId("happened").textContent = `${predicted}Your program gives ${own}. ${why}`;
}

byId("prediction").addEventListener("submit", (event) => {
  event.preventDefault();
  seek(0);
  setPlaying(true);
});

// ---- settings ----

const settings = byId("settings"); // an input has the name of its number

function showSettings() {
  for (const input of settings.querySelectorAll("input")) {
    const { dataset, name } = input;
    const value = dataset.power ? Math.log10(thrown[name]) : digits(thrown[name], 5);
    if (document.activeElement !== input) input.value = value;
    if (input.type !== "range") continue;
    const words = `${digits(thrown[name])} ${dataset.unit}`;
    input.nextElementSibling.value = words;
    input.setAttribute("aria-valuetext", words);
  }
}

settings.addEventListener("input", ({ target: { name, value, dataset } }) => {
  const number = dataset.power ? 10 ** value : Number(value);
  if (!name) return;
  setQuestion(null);
  begin({ ...thrown, [name]: Number(digits(number, 5)) }, shown() * dt);
});
settings.addEventListener("submit", (event) => {
  event.preventDefault();
  throwAgain();
});
keys.t = () => throwAgain();

// ---- scenes ----

const select = byId("scene");

// As `./build/bounce --scene` takes it: the scene's name if it is another one, and numbers.
function setScene(command) {
  const words = command.split(" ");
  const scene = given.scenes.find(({ name }) => name === words[0]);
  const numbers = scene ? numbersOf(scene) : { ...thrown };
  for (const word of words.slice(scene ? 1 : 0)) {
    const [name, value] = word.split("=");
    if (name === "T") numbers.seconds = (value - 1) * numbers.dt;
    else numbers[name] = Number(value);
  }
  select.value = command;
  if (select.selectedIndex < 0) select.value = ""; // it isn't in the list
  const [option] = select.selectedOptions;
  speed.value = option.dataset.speed ?? "1";
  setQuestion(option);
  const isStill = question || media("prefers-reduced-motion: reduce").matches;
  return begin(numbers).then((isShown) => setPlaying(isShown && !isStill));
}

const scenes = given.scenes.map(({ name, title }) => new Option(title, `${name} dt=0.001`));
select.lastElementChild.append(...scenes);
select.addEventListener("change", () => setScene(select.value));

// ---- holding it ----

// A spring pulls the point that is held to the pointer. Its force is gravity's to the program,
// which so moves the square, against the ground, too.
let held = null; // {arm, to, q, v}: the point, as an arm, where it is pulled to, and the square
let lastFrame = 0;

// The same force acts for `elapsed`, so the longer this is, the softer the spring has to be.
function pull({ arm, to, q, v: [v_x, v_y, omega] }, elapsed, g) {
  const spring = Math.min(30, 0.5 / elapsed); // rad/s
  const [r_x, r_y] = turned(q[2], arm);
  const inertia = (l * l) / 6;
  const share = 1 / (1 + (r_x ** 2 + r_y ** 2) / inertia); // of the mass that the point has
  const a_x = spring ** 2 * (to[0] - q[0] - r_x) - 2 * spring * (v_x - omega * r_y);
  const a_y = spring ** 2 * (to[1] - q[1] - r_y) - 2 * spring * (v_y + omega * r_x);
  const turning = (share * (r_x * a_y - r_y * a_x)) / inertia - 4 * omega;
  return [g[0] + share * a_x, g[1] + share * (a_y - g[1]), turning];
}

function drawThread() {
  const [r_x, r_y] = turned(held.q[2], held.arm);
  const ends = [[held.q[0] + r_x, held.q[1] + r_y], held.to];
  set("thread", through(ends.map((end) => camera().to(...end))));
}

async function hold(now) {
  if (!held) return;
  const { params } = sceneOf(thrown);
  const elapsed = Math.max(between(4, now - lastFrame, 50) / 1000, params.dt);
  lastFrame = now;
  const T = Math.max(1, Math.round(elapsed / params.dt)) + 1;
  const g = pull(held, elapsed, params.g);
  const answer = await simulate({ ...held, params: { ...params, g, T } });
  if (!held) return;
  if (!answer) return letGo();
  [held.q, held.v] = [answer.q, answer.motion.v].map((rows) => column(T - 1, rows));
  load(answer);
  position = T - 1;
  show();
  requestAnimationFrame(hold);
}

function letGo() {
  if (!held) return;
  const [[x, y, theta], [vx, vy, omega]] = [held.q, held.v];
  held = null;
  set("thread", "");
  select.value = "";
  setQuestion(null);
  throwAgain({ ...thrown, x, y, theta, vx, vy, omega });
}

stage.addEventListener("pointerdown", ({ offsetX, offsetY, pointerId }) => {
  const to = camera().from(offsetX, offsetY);
  const now = pose(shown());
  const arm = turned(-now[2], [to[0] - now[0], to[1] - now[1]]);
  const away = Math.hypot(...arm);
  if (away > Math.max(l, 30 / camera().scale)) return setPlaying(!playing);
  setPlaying(false);
  stage.setPointerCapture(pointerId);
  const within = Math.min(1, (0.6 * l) / away);
  const v = column(columnShown(), motion.v);
  held = { arm: arm.map((r) => within * r), to, q: now, v };
  lastFrame = performance.now();
  requestAnimationFrame(hold);
});
stage.addEventListener("pointermove", ({ offsetX, offsetY }) => {
  if (held) held.to = camera().from(offsetX, offsetY);
});
for (const end of ["pointerup", "pointercancel"]) addEventListener(end, letGo);

// ---- the page begins ----

let version = null; // of the program
setInterval(async () => {
  const now = (await ask("version").catch(() => null))?.version;
  if (!now || version === now || held) return;
  const words = "Your program was built again: this is the same throw with the new one.";
  if (version) begin({ ...thrown }, 0, words);
  version = now;
}, 1000);
setScene(select.options[1].value);
