// Draws charts as SVG, as large as the style makes them: lines with dots, zeros apart from a logarithmic axis, and numbers at the cursor.

const SVG = "http://www.w3.org/2000/svg";
const LEAST = 1e-9; // what is smaller on a logarithmic axis is drawn as 0

function make(name, attributes = {}, ...children) {
  const element = name.startsWith("svg:") ? document.createElementNS(SVG, name.slice(4)) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

const digits = (x) => (x !== 0 && (Math.abs(x) >= 1e6 || Math.abs(x) < 1e-4) ? x.toExponential(2) : String(Number(x.toPrecision(3))));
const isZero = (axis, value) => axis.log && value < LEAST;

// The smallest of 1, 2, 5, 10, 20, ... that is at least `least`.
function round125(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((n) => n * power).find((n) => n >= least * (1 - 1e-9));
}

// Where numbers stand between two ends of the field, and the axis's ticks. Zeros have a strip apart.
function scale(axis, values, begin, end) {
  const shown = values.filter((value) => !isZero(axis, value));
  const of = axis.log ? Math.log10 : (value) => value;
  const all = (shown.length ? shown : [1]).map(of);
  let [low, high] = [Math.min(...all), Math.max(...all)];
  if (axis.log) [low, high] = [Math.floor(low), Math.max(Math.ceil(high), Math.floor(low) + 1)];
  else [low, high] = [-0.04, 1.04].map((share) => low + share * (high - low || Math.abs(low) || 1));
  const hasZeros = shown.length < values.length;
  const from = hasZeros ? begin + Math.sign(end - begin) * 26 : begin;
  const at = (value) => (isZero(axis, value) ? begin + Math.sign(end - begin) * 6 : from + ((of(value) - low) / (high - low)) * (end - from));
  const step = axis.log ? Math.max(1, Math.ceil((high - low) / 6)) : round125((high - low) / 5);
  const ticks = [];
  for (let tick = Math.ceil(low / step - 1e-9) * step; tick <= high + 1e-9; tick += step) ticks.push(axis.log ? 10 ** tick : tick);
  return { at, ticks, hasZeros, edge: from };
}

function label(axis, value, attributes) {
  const text = make("svg:text", attributes);
  if (!axis.log) text.append(digits(Math.abs(value) < 1e-12 ? 0 : value));
  else text.append("10", make("svg:tspan", { dy: -5, "font-size": 9 }, String(Math.round(Math.log10(value)))));
  return text;
}

const hasDots = (line) => line.kind !== "bound" && line.points.length < 60;
const kind = (line, i) => (line.kind === "bound" ? "bound" : `k${i % 5} ${line.kind}`);

// Curves join what isn't 0; a 0 is a dot of its own.
function drawn(chart, line, i, x, y) {
  let path = "";
  let dots = "";
  let joined = false;
  for (const [a, b] of line.points) {
    const point = `${x.at(a).toFixed(1)} ${y.at(b).toFixed(1)}`;
    const apart = isZero(chart.y, b);
    if (!apart) path += `${joined ? "L" : "M"} ${point} `;
    joined = !apart;
    if (hasDots(line)) dots += `M ${point} h 0 `;
  }
  const curve = make("svg:path", { class: `curve ${kind(line, i)}`, d: path });
  return [curve, make("svg:path", { class: `dots ${kind(line, i)}`, d: dots })];
}

function plot(chart, svg) {
  const [width, height] = [Math.max(svg.clientWidth, 240), Math.max(svg.clientHeight, 100)];
  const points = chart.lines.flatMap((line) => line.points);
  const [left, right, bottom] = [chart.y.log ? 58 : 66, width - 12, height - 46];
  const y = scale(chart.y, points.map((point) => point[1]), bottom, 10);
  const x = scale(chart.x, points.map((point) => point[0]), left, right);
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.replaceChildren();
  for (const tick of x.ticks) {
    svg.append(make("svg:path", { class: "grid", d: `M ${x.at(tick)} 10 V ${bottom}` }));
    svg.append(label(chart.x, tick, { x: x.at(tick), y: height - 28, "text-anchor": "middle" }));
  }
  for (const tick of y.ticks) {
    svg.append(make("svg:path", { class: "grid", d: `M ${left} ${y.at(tick)} H ${right}` }));
    svg.append(label(chart.y, tick, { x: left - 7, y: y.at(tick) + 4, "text-anchor": "end" }));
  }
  if (y.hasZeros) {
    svg.append(make("svg:path", { class: "zero", d: `M ${left} ${y.at(0)} H ${right}` }));
    svg.append(make("svg:text", { x: left - 7, y: y.at(0) + 4, "text-anchor": "end" }, "0"));
  }
  svg.append(make("svg:text", { x: (left + right) / 2, y: height - 8, "text-anchor": "middle" }, chart.x.name));
  svg.append(make("svg:text", { transform: `translate(13 ${height / 2 - 18}) rotate(-90)`, "text-anchor": "middle" }, chart.y.name));
  chart.lines.forEach((line, i) => svg.append(...drawn(chart, line, i, x, y)));
  const near = make("svg:circle", { class: "near", r: 7, visibility: "hidden" });
  svg.append(near);
  return { x, y, near, bottom };
}

// The point of a line that lies nearest to the pointer.
function nearest(chart, field, X, Y) {
  const all = chart.lines.flatMap((line) => line.points.map((point) => ({ line, point })));
  const far = ({ point: [a, b] }) => Math.hypot(field.x.at(a) - X, field.y.at(b) - Y);
  return all.reduce((best, one) => (far(one) < far(best) ? one : best));
}

function legend(chart) {
  const sample = (line, i) => {
    const isJoined = line.points.filter((point) => !isZero(chart.y, point[1])).length > 1;
    const curve = isJoined ? [make("svg:path", { class: `curve ${kind(line, i)}`, d: "M 1 5 H 33" })] : [];
    if (hasDots(line)) curve.push(make("svg:path", { class: `dots ${kind(line, i)}`, d: "M 17 5 h 0" }));
    return make("svg:svg", { viewBox: "0 0 34 10", "aria-hidden": "true" }, ...curve);
  };
  return make("ul", { class: "legend" }, ...chart.lines.map((line, i) => make("li", {}, sample(line, i), ` ${line.name}`)));
}

function numbers(chart) {
  const rows = chart.lines.flatMap((line) => line.points.map(([a, b]) => make("tr", {}, make("td", {}, line.name), make("td", {}, digits(a)), make("td", {}, digits(b)))));
  const head = make("tr", {}, ...["", chart.x.name, chart.y.name].map((name) => make(name ? "th" : "td", name ? { scope: "col" } : {}, name)));
  return make("details", {}, make("summary", {}, "The numbers"), make("div", { class: "wide", tabindex: 0, role: "region", "aria-label": `Numbers of ${chart.title}` }, make("table", {}, head, ...rows)));
}

// A figure, which draws itself once it is in the page, and anew when its width changes.
function figure(chart) {
  const svg = make("svg:svg", { role: "img", "aria-label": `${chart.title}. ${chart.sentence}` });
  const shown = make("output", { "aria-live": "off" }, "Point at the chart to read its numbers.");
  const made = make("figure", { id: chart.id }, make("h3", {}, chart.title), svg, shown, legend(chart), make("figcaption", {}, chart.sentence), numbers(chart));
  let field;
  new ResizeObserver(() => (field = plot(chart, svg))).observe(made);
  svg.addEventListener("pointermove", (event) => {
    if (!field || !chart.lines.some((line) => line.points.length)) return;
    const { line, point: [a, b] } = nearest(chart, field, event.offsetX, event.offsetY);
    field.near.setAttribute("cx", field.x.at(a));
    field.near.setAttribute("cy", field.y.at(b));
    field.near.setAttribute("visibility", "visible");
    shown.textContent = `${line.name}: ${chart.x.name} ${digits(a)}; ${chart.y.name} ${isZero(chart.y, b) && b > 0 ? `${digits(b)}, rounding` : digits(b)}`;
  });
  return made;
}
