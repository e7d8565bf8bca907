// Draws charts as SVG, as large as the style makes them: lines with dots, zeros apart from a
// logarithmic axis, and numbers at the cursor.

const byId = (id) => document.getElementById(id);
const LEAST = 1e-9; // what is smaller on a logarithmic axis is drawn as 0
const isZero = (axis, value) => axis.log && value < LEAST;
const media = (query) => matchMedia(`(${query})`);
const between = (low, value, high) => Math.max(low, Math.min(value, high));
const digits = (x, count = 3) => String(Number(x.toPrecision(count)));
const raised = (n) => String(n).replace(/./g, (c) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[c] ?? "⁻");

function make(name, attributes = {}, ...children) {
  const isDrawn = ["svg", "path", "text", "circle"].includes(name);
  const svg = "http://www.w3.org/2000/svg";
  const element = isDrawn ? document.createElementNS(svg, name) : document.createElement(name);
  for (const key in attributes) element.setAttribute(key, attributes[key]);
  element.append(...children);
  return element;
}
const path = (kind, d) => make("path", { class: kind, d });

// The least and the greatest of all, and of `ends`.
const span = (all, ends = [all[0], all[0]]) =>
  all.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], ends);

// The smallest of 1, 2, 5, 10, 20, ... that is at least `least`.
function round125(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((n) => n * power).find((n) => n >= least * (1 - 1e-9));
}

// The multiples of `step` from a to b. They are counted: far from 0, adding a step may change
// nothing.
function multiples(step, a, b) {
  const first = Math.ceil(a / step);
  const count = Math.min(Math.floor(b / step) - first + 1, 200) || 0;
  return Array.from({ length: count }, (_, i) => (first + i) * step);
}

// Where numbers stand between two ends of the field, and the places of ticks with their names.
// Zeros have a strip apart.
function scale(axis, values, begin, end) {
  const others = values.filter((value) => !isZero(axis, value));
  const hasZeros = others.length < values.length;
  const of = axis.log ? Math.log10 : (value) => value;
  let [low, high] = span((others.length ? others : [1]).map(of));
  if (axis.log) [low, high] = [Math.floor(low), Math.max(Math.ceil(high), Math.floor(low) + 1)];
  else [low, high] = [-0.04, 1.04].map((share) => low + share * (high - low || Math.abs(low) || 1));
  const inwards = Math.sign(end - begin);
  const from = begin + (hasZeros ? 26 * inwards : 0);
  const place = (number) => from + ((number - low) / (high - low)) * (end - from);
  const at = (value) => (isZero(axis, value) ? begin + 6 * inwards : place(of(value)));
  const step = axis.log ? Math.ceil((high - low) / 6) : round125((high - low) / 5);
  const name = (n) => (axis.log ? `10${raised(n)}` : digits(n));
  const ticks = multiples(step, low, high).map((n) => [place(n), name(n)]);
  return { at, ticks: hasZeros ? [[at(0), "0"], ...ticks] : ticks };
}

// A line's curve and its dots.
function strokes(line, i, curve, dots) {
  const kind = ["bound", "right"].includes(line.kind) ? line.kind : `k${i % 5} ${line.kind}`;
  const hasDots = line.kind !== "bound" && line.points.length < 60;
  return [path(`curve ${kind}`, curve), path(`dots ${kind}`, hasDots ? dots : "")];
}

// Curves join what isn't 0; a 0 is a dot of its own.
function drawn(chart, line, i, x, y) {
  let [curve, dots, pen] = ["", "", "M"];
  for (const [a, b] of line.points) {
    const point = `${x.at(a).toFixed(1)} ${y.at(b).toFixed(1)} `;
    const isApart = isZero(chart.y, b);
    if (!isApart) curve += pen + point;
    dots += `M ${point} h 0 `;
    pen = isApart ? "M" : "L";
  }
  return strokes(line, i, curve, dots);
}

function plot(chart, svg) {
  const [width, height] = [Math.max(svg.clientWidth, 240), Math.max(svg.clientHeight, 100)];
  const [left, right, bottom] = [66, width - 12, height - 46];
  const points = chart.lines.flatMap((line) => line.points);
  const x = scale(chart.x, points.map((point) => point[0]), left, right);
  const y = scale(chart.y, points.map((point) => point[1]), bottom, 10);
  const write = (words, x, y, more) => make("text", { x, y, ...more }, words);
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.replaceChildren(
    ...x.ticks.map(([X]) => path("grid", `M ${X} 10 V ${bottom}`)),
    ...y.ticks.map(([Y]) => path("grid", `M ${left} ${Y} H ${right}`)),
    ...x.ticks.map(([X, words]) => write(words, X, height - 28)),
    ...y.ticks.map(([Y, words]) => write(words, left - 7, Y + 4, { class: "end" })),
    write(chart.x.name, (left + right) / 2, height - 8),
    write(chart.y.name, 18 - height / 2, 13, { transform: "rotate(-90)" }),
    ...chart.lines.flatMap((line, i) => drawn(chart, line, i, x, y)),
  );
  return { x, y, bottom };
}

function legend(chart) {
  const rows = chart.lines.map((line, i) => {
    const isJoined = line.points.filter(([, b]) => !isZero(chart.y, b)).length > 1;
    const sample = strokes(line, i, isJoined ? "M 1 5 H 33" : "", "M 17 5 h 0");
    const svg = make("svg", { viewBox: "0 0 34 10", "aria-hidden": true }, ...sample);
    return make("li", {}, svg, ` ${line.name}`);
  });
  return make("ul", { class: "legend" }, ...rows);
}

const row = (kind, ...cells) => make("tr", {}, ...cells.map((cell) => make(kind, {}, cell)));

function numbers({ title, x, y, lines }) {
  const table = make("table", {}, row("th", "line", x.name, y.name));
  for (const { name, points } of lines)
    table.append(...points.map(([a, b]) => row("td", name, digits(a), digits(b))));
  const about = { class: "wide", tabindex: 0, role: "region", "aria-label": `Numbers: ${title}` };
  return make("details", {}, make("summary", {}, "The numbers"), make("div", about, table));
}

// A figure, which draws itself once it is in the page, and anew when its width changes.
function figure(chart) {
  const { id, title, sentence, lines } = chart;
  const svg = make("svg", { role: "img", "aria-label": `${title}. ${sentence}` });
  const shown = make("output", { "aria-live": "off" }, "Point at the chart to read its numbers.");
  const words = [legend(chart), make("figcaption", {}, sentence), numbers(chart)];
  const made = make("figure", { id }, make("h3", {}, title), svg, shown, ...words);
  const points = lines.flatMap(({ name, points }) => points.map(([a, b]) => ({ name, a, b })));
  let field;
  new ResizeObserver(() => (field = plot(chart, svg))).observe(made);
  svg.addEventListener("pointermove", ({ offsetX, offsetY }) => {
    if (!points.length) return;
    const away = ({ a, b }) => Math.hypot(field.x.at(a) - offsetX, field.y.at(b) - offsetY);
    const { name, a, b } = points.reduce((best, one) => (away(one) < away(best) ? one : best));
    svg.querySelector(".near")?.remove();
    svg.append(make("circle", { class: "near", r: 7, cx: field.x.at(a), cy: field.y.at(b) }));
    const rounding = isZero(chart.y, b) && b > 0 ? ", rounding" : "";
    shown.value = `${name}: ${chart.x.name} ${digits(a)}; ${chart.y.name} ${digits(b)}${rounding}`;
  });
  return made;
}
