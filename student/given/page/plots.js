// ---- plots ----

let plotted = []; // the charts beside the square, each with its legend and the time that is shown

// Not every column of a long motion, and nothing that is beyond all bounds.
function line(name, values) {
  const every = Math.ceil(T / 2000);
  const points = values.map((value, t) => [t * dt, value]);
  return { name, values, kind: "own", points: points.filter(([, value], t) => t % every === 0 && Math.abs(value) < 1e100) };
}

function plotsOf() {
  const phi = [line("\u03c6", lows.map(({ y }) => y))];
  if (comparing()) phi.push(line("dashed", lowsRight.map(({ y }) => y)));
  const found = [["height \u03c6, m", phi]];
  if (many.length) {
    const apart = q[0].map((x, t) => Math.max(...many.map((path) => Math.hypot(path[0][t] - x, path[1][t] - q[1][t]))));
    found.unshift(["farthest from the middle one, m", [line("apart", apart)]]);
  }
  if (motion) {
    const all = q[0].map((_, t) => energies(t));
    found.push(["energy, J", ["total", "kinetic", "potential"].map((name) => line(name, all.map((energy) => energy[name])))]);
  }
  return found.map(([name, lines]) => ({ x: { name: "t, s", log: false }, y: { name, log: false }, lines }));
}

function layOut() {
  plotted = plotsOf().map((chart) => ({ chart, svg: make("svg:svg", { role: "img", "aria-label": chart.y.name, preserveAspectRatio: "none" }), names: legend(chart), cursor: make("svg:path", { class: "cursor" }) }));
  plots.replaceChildren(...plotted.map(({ svg, names }) => make("div", {}, svg, names)));
  showNumbers(); // which have to have their room
  for (const one of plotted) {
    one.field = plot(one.chart, one.svg);
    one.svg.append(one.cursor);
  }
}

function showNumbers() {
  for (const { chart, names } of plotted) chart.lines.forEach(({ name, values }, i) => (names.children[i].lastChild.data = ` ${name} ${text(values[columnShown()] ?? NaN, 4)}`));
}

function drawPlots() {
  showNumbers();
  for (const { field, cursor } of plotted) cursor.setAttribute("d", `M ${field.x.at(shown() * dt)} 10 V ${field.bottom}`);
}

// The column under a pointer.
function columnAt(event) {
  const { svg, field } = plotted.find((one) => one.svg.parentNode.contains(event.target)) ?? plotted[0];
  const { at } = field.x;
  const share = (event.clientX - svg.getBoundingClientRect().left - at(0)) / (at((T - 1) * dt) - at(0) || 1);
  return Math.round(Math.min(Math.max(share, 0), 1) * (T - 1));
}
