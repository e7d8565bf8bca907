// The page that render writes, but for its data: head, style and body around a script that draws
// `animation` = {l, dt, delta, q}, with q as three rows. It asks for nothing from anywhere.
#pragma once

#include <string_view>

namespace bounce {

inline constexpr std::string_view page_head = R"html(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<link rel="icon" href="data:,">
<title>Bouncing square</title>
)html";

// Blue and vermilion are told apart by every kind of colour vision (Okabe and Ito's palette).
inline constexpr std::string_view page_style = R"css(<style>
:root {
  --paper: #f6f5f1; --card: #ffffff; --text: #22252a; --quiet: #646a73; --edge: #dcdad3; --grid: rgba(0, 0, 0, 0.07);
  --ground: #e6e3da; --ground-line: #77746b; --square: #0072b2; --corner: #c84f00;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #121417; --card: #1a1d21; --text: #e8e6e1; --quiet: #a0a5ad; --edge: #33373d; --grid: rgba(255, 255, 255, 0.08);
    --ground: #2b2f34; --ground-line: #8b8f96; --square: #56b4e9; --corner: #f0a040;
  }
}
* { box-sizing: border-box; margin: 0; }
body {
  display: flex; flex-direction: column; gap: 14px; min-height: 100vh; min-height: 100dvh;
  max-width: 1120px; margin: 0 auto; padding: 20px 24px;
  background: var(--paper); color: var(--text); accent-color: var(--square);
  font: 15px/1.45 system-ui, -apple-system, "Segoe UI", Roboto, sans-serif;
}
header { display: flex; flex-wrap: wrap; align-items: baseline; gap: 0 16px; }
h1 { font-size: 21px; font-weight: 650; letter-spacing: -0.01em; }
header p, figcaption, dt, small, #hint { color: var(--quiet); font-size: 13px; }
i { font-family: "STIX Two Text", Cambria, Georgia, "Times New Roman", serif; font-size: 1.1em; }
figure { display: flex; flex-direction: column; flex: 1 0 auto; gap: 8px; }
#stage {
  flex: 1 0 0px; width: 100%; min-height: 240px; cursor: pointer;
  background: var(--card); border: 1px solid var(--edge); border-radius: 12px;
}
dl { --unit: 48px; display: grid; grid-template-columns: repeat(auto-fit, minmax(calc(var(--longest, 6) * 1ch + var(--unit)), 1fr)); gap: 6px 12px; font-size: 19px; }
dt, dd { white-space: nowrap; }
dd, output { font-variant-numeric: tabular-nums; }
#controls { display: flex; flex-wrap: wrap; align-items: center; gap: 8px 16px; }
#play {
  width: 46px; height: 46px; padding: 0; border: 0; border-radius: 50%; cursor: pointer;
  background: var(--square); color: var(--card);
}
#play svg { display: block; width: 20px; height: 20px; margin: auto; fill: currentColor; }
#slider { flex: 1; min-width: 70%; height: 32px; margin: 0; cursor: pointer; }
output { text-align: right; }
select {
  height: 38px; margin-left: 4px; padding: 0 8px; font: inherit; color: inherit;
  background: var(--card); border: 1px solid var(--edge); border-radius: 8px;
}
:focus-visible { outline: 3px solid var(--corner); outline-offset: 2px; }
@media (pointer: coarse), (max-width: 640px) { #hint { display: none; } }
@media (min-width: 641px) { #slider { min-width: 0; } }
@media (max-width: 640px) { body { padding: 14px; } dl { --unit: 30px; font-size: 16px; } #controls { justify-content: space-between; } output { text-align: left; } }
@media (max-height: 520px) { body { padding: 12px; gap: 8px; } header, figcaption, #hint { display: none; } #stage { min-height: 160px; } }
</style>
</head>
)css";

inline constexpr std::string_view page_body = R"html(<body>
<header>
<h1>Bouncing square</h1>
<p id="about"></p>
</header>
<figure>
<canvas id="stage" role="img" aria-label="The square on its way over the ground. The numbers below say where it is."></canvas>
<figcaption>The line follows the lowest corner and breaks where another one takes over; dots mark contact, <i>&phi;</i> &lt; <i>&delta;</i>.<span id="past"> Faint squares are equal times apart.</span></figcaption>
</figure>
<dl>
<div><dt><i>t</i>, time</dt><dd><span id="time"></span> <small>s</small></dd></div>
<div><dt><i>x</i>, centre</dt><dd><span id="x"></span> <small>m</small></dd></div>
<div><dt><i>y</i>, centre</dt><dd><span id="y"></span> <small>m</small></dd></div>
<div><dt><i>&theta;</i>, angle</dt><dd><span id="theta"></span> <small>rad</small></dd></div>
<div><dt><i>&phi;</i>, lowest corner</dt><dd><span id="phi"></span> <small>m<span id="contact">, contact</span></small></dd></div>
</dl>
<div id="controls">
<button id="play" type="button"><svg viewBox="0 0 20 20" aria-hidden="true"><path></path></svg></button>
<input id="slider" type="range" min="0" value="0" step="1" aria-label="Time step">
<output id="column" for="slider" aria-live="off"></output>
<label>Speed
<select id="speed">
<option value="0.125">1/8&times;</option>
<option value="0.25">1/4&times;</option>
<option value="0.5">1/2&times;</option>
<option value="1">1&times;</option>
<option value="2">2&times;</option>
<option value="fit">10 s a loop</option>
</select></label>
</div>
<p id="hint">Space plays and pauses, the arrows go one step, Home and End to the first and the last.</p>
<noscript>The animation needs JavaScript, which is turned off in this browser.</noscript>
)html";

inline constexpr std::string_view page_script = R"js("use strict";
const { l, dt, delta, q } = animation;
const T = q[0].length;
const byId = (id) => document.getElementById(id);
const [stage, play, slider, speed] = ["stage", "play", "slider", "speed"].map(byId);
const ctx = stage.getContext("2d");
const media = (query) => matchMedia(`(${query})`);

// ---- the square ----

// The corners relative to the centre, r_k = R(theta) s_k, eqs. (3) and (5).
function corners(theta) {
  const c = (l / 2) * Math.cos(theta);
  const s = (l / 2) * Math.sin(theta);
  return [[c - s, s + c], [-c - s, c - s], [s - c, -s - c], [c + s, s - c]];
}

// The lowest corner: its number k, where it is, and so its height y = phi, eq. (4).
function lowest([x, y, theta]) {
  const r = corners(theta);
  const k = r.reduce((best, [, height], i) => (height < r[best][1] ? i : best), 0);
  return { k, x: x + r[k][0], y: y + r[k][1] };
}

const column = (t) => [q[0][t], q[1][t], q[2][t]];
const lows = q[0].map((_, t) => lowest(column(t)));

// Where the square is drawn, s columns on: between two columns, on the straight way from one to the
// other. At a whole s it is the column itself.
function pose(s) {
  const t = Math.min(Math.floor(s), T - 1);
  const next = column(Math.min(t + 1, T - 1));
  return column(t).map((value, i) => value + (s - t) * (next[i] - value));
}

// ---- time ----

const rest = 0.8; // s to look at the last column before the loop starts again
let position = 0; // in columns, from 0 to T - 1 and on through the rest
let playing = false;
let clock = null; // ms, when the position was last moved on
let frame = 0; // the next frame's handle

const shown = () => Math.min(position, T - 1);
const columnShown = () => Math.floor(shown());
// Columns a second. The bound keeps it finite for the tiniest dt.
const rate = () => Math.min(speed.value === "fit" ? Math.max(T - 1, 1) / 10 : Number(speed.value) / dt, 1e12);

function tick(now) {
  const elapsed = clock === null ? 0 : Math.max(now - clock, 0) / 1000;
  clock = now;
  position = (position + elapsed * rate()) % (T - 1 + rest * rate());
  show();
  frame = requestAnimationFrame(tick);
}

function setPlaying(on) {
  if (on === playing) return;
  playing = on;
  clock = null;
  position = columnShown();
  if (on) frame = requestAnimationFrame(tick);
  else cancelAnimationFrame(frame);
  show();
}

function seek(t) {
  setPlaying(false);
  position = Math.min(Math.max(t, 0), T - 1);
  show();
}

// ---- text ----

// A length is shown to a thousandth of the side.
const places = Math.max(0, Math.ceil(3 - Math.log10(l)));
const timePlaces = Math.max(2, Math.ceil(-Math.log10(dt)));
function text(value, digits) {
  const fixed = digits > 15 ? "" : value.toFixed(digits);
  const short = fixed && fixed.length <= 17 ? fixed : value.toExponential(6);
  return (Number(short) === 0 ? short.replace("-", "") : short).replace(/-/g, "\u2212");
}

function showText() {
  const t = columnShown();
  const [x, y, theta] = column(t);
  const numbers = {
    time: text(t * dt, timePlaces),
    x: text(x, places),
    y: text(y, places),
    theta: text(theta, 4),
    phi: text(lows[t].y, places),
  };
  for (const id in numbers) byId(id).textContent = numbers[id];
  byId("contact").hidden = !(lows[t].y < delta);
  byId("column").textContent = `${t} / ${T - 1}`;
  slider.value = t;
  slider.setAttribute("aria-valuetext", `step ${t} of ${T - 1}, ${numbers.time} seconds`);
  play.setAttribute("aria-label", playing ? "Pause" : "Play");
  play.querySelector("path").setAttribute("d", playing ? "M4 3h4v14H4zM12 3h4v14h-4z" : "M5 2.5v15l13-7.5z");
}

// ---- picture ----

let colour = {}; // the style's colours by name
let whole = null; // the view of the whole trajectory
const wide = () => stage.clientWidth;
const high = () => stage.clientHeight;
const small = () => l * whole.scale < 16; // too small a square to be seen in the whole

// A view shows the world's point (x, y), m, at the stage's (X, Y), pixels, with `scale` pixels a metre.
const view = (scale, x, y, X, Y) => ({
  scale,
  X: (a) => X + (a - x) * scale,
  Y: (b) => Y - (b - y) * scale,
  x: (A) => x + (A - X) / scale,
  y: (B) => y - (B - Y) / scale,
});

const span = (row, start = [row[0], row[0]]) => row.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], start);

function fit() {
  const margin = { left: 52, right: 28, top: 24, bottom: 52 };
  const reach = l / Math.SQRT2; // from the centre to a corner
  const [left, right] = span(q[0]);
  const [bottom, top] = span(q[1], [reach, -reach]); // the ground is in view
  const width = wide() - margin.left - margin.right;
  const height = high() - margin.top - margin.bottom;
  const scale = Math.min(
    width / (right - left + 2 * reach),
    height / (top - bottom + 2 * reach),
    (0.3 * Math.min(width, height)) / l, // a square that hardly moves need not fill the stage
  );
  const spare = height - (top - bottom + 2 * reach) * scale;
  return view(scale, (left + right) / 2, bottom - reach, margin.left + width / 2, high() - margin.bottom - spare / 4);
}

// The least of 1, 2, 5, 10, 20, ... that is not below `least`.
function round125(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((n) => n * power).find((n) => n >= least * (1 - 1e-9));
}

// The multiples of `step` from a to b. They are counted, since far from 0 a sum may stand still.
function multiples(step, a, b) {
  const first = Math.ceil(a / step);
  const count = Math.min(Math.floor(b / step) - first + 1, 200) || 0;
  return Array.from({ length: count }, (_, i) => (first + i) * step);
}

// A grid of squares, numbered in metres along the lower and the left edge.
function drawGrid(at) {
  const name = (value, step) => text(value, Math.min(Math.max(0, -Math.floor(Math.log10(step))), 15)) + " m";
  const width = (step) => Math.max(...[at.x(0), at.x(wide())].map((x) => ctx.measureText(name(x, step)).width));
  let step = round125(70 / at.scale);
  for (let i = 0; i < 20 && width(step) + 24 > step * at.scale; ++i) step = round125(1.5 * step);

  ctx.fillStyle = colour.quiet;
  ctx.textAlign = "left";
  ctx.beginPath();
  for (const x of multiples(step, at.x(0), at.x(wide()))) {
    const X = Math.round(at.X(x)) + 0.5;
    ctx.moveTo(X, 0);
    ctx.lineTo(X, high());
    if (X > 0 && X + width(step) + 10 < wide()) ctx.fillText(name(x, step), X + 5, high() - 10);
  }
  for (const y of multiples(step, at.y(high()), at.y(0))) {
    const Y = Math.round(at.Y(y)) + 0.5;
    ctx.moveTo(0, Y);
    ctx.lineTo(wide(), Y);
    if (Y > 20 && Y < high() - 28) ctx.fillText(name(y, step), 10, Y - 5);
  }
  stroke("grid", 1);
}

function stroke(name, width) {
  ctx.strokeStyle = colour[name];
  ctx.lineWidth = width;
  ctx.stroke();
}

function disc(X, Y, radius, fill) {
  ctx.beginPath();
  ctx.arc(X, Y, radius, 0, 2 * Math.PI);
  if (!fill) return;
  ctx.fillStyle = colour[fill];
  ctx.fill();
}

function drawGround(at) {
  ctx.fillStyle = colour.ground;
  ctx.fillRect(0, at.Y(0), wide(), Math.max(high() - at.Y(0), 0));
  ctx.fillStyle = colour["ground-line"];
  ctx.fillRect(0, at.Y(0), wide(), 1.5);
}

// The way of the lowest corner up to s, with dots at the columns in contact. Points that would fall
// on the last one are left out, and so are those too far off for a canvas to draw.
function drawTrace(at, s) {
  const nowhere = { k: -1, X: Infinity, Y: 0 };
  const off = (a, b) => Math.abs(a.X - b.X) + Math.abs(a.Y - b.Y);
  const dots = [];
  let dot = nowhere;
  let pen = nowhere;
  ctx.beginPath();
  for (let t = 0; t <= s + 1; ++t) {
    const { k, x, y } = t <= s ? lows[t] : lowest(pose(s));
    const point = { k, X: at.X(x), Y: at.Y(y) };
    if (Math.abs(point.X) + Math.abs(point.Y) > 1e6) {
      pen = nowhere;
      continue;
    }
    if (y < delta && off(point, dot) >= 2) dots.push((dot = point));
    if (k === pen.k && off(point, pen) < 1) continue;
    if (k === pen.k) ctx.lineTo(point.X, point.Y);
    else ctx.moveTo(point.X, point.Y);
    pen = point;
  }
  stroke("corner", 2);
  for (const { X, Y } of dots) disc(X, Y, 3, "corner");
}

// Lays the square's outline as the path, and gives its corners on the stage.
function outline(at, [x, y, theta]) {
  const c = corners(theta).map(([r_x, r_y]) => [at.X(x) + r_x * at.scale, at.Y(y) - r_y * at.scale]);
  ctx.beginPath();
  for (const corner of c) ctx.lineTo(...corner);
  ctx.closePath();
  return c;
}

// Where the square was at equal steps of time, as a stroboscope shows it.
function drawPast(at, s) {
  const every = round125(Math.max(T / 20, 1));
  ctx.globalAlpha = 0.28;
  for (let t = 0; t < s; t += every) {
    outline(at, column(t));
    stroke("square", 1);
  }
  ctx.globalAlpha = 1;
}

// The square, with a line along its own x axis and a ring at its lowest corner, filled in contact.
function drawSquare(at, now) {
  const low = lowest(now);
  const c = outline(at, now);
  ctx.fillStyle = colour.square;
  ctx.globalAlpha = 0.22;
  ctx.fill();
  ctx.globalAlpha = 1;
  ctx.moveTo(at.X(now[0]), at.Y(now[1]));
  ctx.lineTo((c[0][0] + c[3][0]) / 2, (c[0][1] + c[3][1]) / 2);
  stroke("square", 2);
  disc(...c[low.k], Math.min(5, Math.max(2, (l * at.scale) / 5)), low.y < delta ? "corner" : "card");
  stroke("corner", 2);
}

// A small square is ringed, and shown under a lens as well.
function drawLens() {
  const [x, y] = pose(shown());
  const radius = Math.min(72, high() / 5);
  const [X, Y] = [wide() - radius - 18, radius + 18];
  const lens = view((0.8 * radius) / l, x, y, X, Y);
  disc(whole.X(x), whole.Y(y), 13);
  stroke("quiet", 1);
  ctx.save();
  disc(X, Y, radius, "card");
  ctx.clip();
  drawScene(lens);
  ctx.restore();
  disc(X, Y, radius);
  stroke("quiet", 1.5);
  ctx.fillStyle = colour.quiet;
  ctx.textAlign = "center";
  ctx.fillText(`${Number((lens.scale / whole.scale).toPrecision(2))}\u00d7`, X, Y + radius + 18);
}

function drawScene(at) {
  drawGround(at);
  if (at === whole) drawGrid(at);
  if (!small()) drawPast(at, shown());
  drawTrace(at, shown());
  drawSquare(at, pose(shown()));
}

function draw() {
  if (!whole) return;
  ctx.clearRect(0, 0, wide(), high());
  ctx.font = "12px system-ui, -apple-system, sans-serif";
  drawScene(whole);
  if (small()) drawLens();
}

function show() {
  showText();
  draw();
}

// ---- what the reader does ----

function resize() {
  const ratio = window.devicePixelRatio || 1;
  stage.width = Math.round(wide() * ratio);
  stage.height = Math.round(high() * ratio);
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  ctx.lineJoin = "round";
  whole = fit();
  byId("past").hidden = small();
  draw();
}

function recolour() {
  const style = getComputedStyle(document.documentElement);
  const names = ["card", "quiet", "grid", "ground", "ground-line", "square", "corner"];
  colour = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  draw();
}

const keys = {
  " ": () => setPlaying(!playing),
  ArrowLeft: () => seek(columnShown() - 1),
  ArrowRight: () => seek(columnShown() + 1),
  Home: () => seek(0),
  End: () => seek(T - 1),
};

// What already answers a key by itself is left to do so.
const answers = (target, key) =>
  target === speed || (target === slider && key !== " ") || (target === play && key === " ");

document.addEventListener("keydown", (event) => {
  const act = keys[event.key];
  if (!act || event.ctrlKey || event.metaKey || event.altKey || answers(event.target, event.key)) return;
  event.preventDefault();
  act();
});
for (const element of [play, stage]) element.addEventListener("click", () => setPlaying(!playing));
slider.addEventListener("input", () => seek(Number(slider.value)));
new ResizeObserver(resize).observe(stage);
media("prefers-color-scheme: dark").addEventListener("change", recolour);

byId("about").innerHTML = `<i>T</i> = ${T}, &Delta;<i>t</i> = ${Number(dt.toPrecision(6))} s, <i>l</i> = ${Number(l.toPrecision(6))} m`;
const lengths = q.flatMap((row) => span(row)).map((value) => text(value, places).length);
document.documentElement.style.setProperty("--longest", Math.max(...lengths));
byId("column").style.minWidth = `${2 * String(T - 1).length + 2}ch`;
slider.max = T - 1;
const seconds = (T - 1) * dt;
speed.value = T > 1 && (seconds < 0.5 || seconds > 60) ? "fit" : "1";
recolour();
show();
if (!media("prefers-reduced-motion: reduce").matches) setPlaying(true);
)js";

}  // namespace bounce
