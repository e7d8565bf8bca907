let plotted = []; // the charts beside the square, each with its legend and the time that is shown

// Not every column of a long motion, and nothing that is beyond all bounds.
function line(name, values, kind = "own") {
  const every = Math.ceil(T / 2000);
  const points = values.map((value, t) => [t * dt, value]);
  const isDrawn = ([, value], t) => t % every === 0 && Math.abs(value) < 1e100;
  return { name, values, kind, points: points.filter(isDrawn) };
}

function layOut() {
  byId("other").hidden = !comparing();
  const charts = {};
  if (many.length) {
    const away = (t) => ([xs, ys]) => Math.hypot(xs[t] - q[0][t], ys[t] - q[1][t]);
    const apart = q[0].map((_, t) => Math.max(...many.map(away(t))));
    charts["largest distance, m"] = [line("from the middle one", apart)];
  }
  const heights = (lows) => lows.map(({ y }) => y);
  charts["height \u03c6, m"] = [line("\u03c6", heights(lows))];
  if (comparing()) charts["height \u03c6, m"].push(line("dashed", heights(lowsRight), "right"));
  if (motion) {
    const all = q[0].map((_, t) => energies(t));
    charts["energy, J"] = Object.keys(all[0]).map((name) => line(name, all.map((of) => of[name])));
  }
  plotted = Object.entries(charts).map(([name, lines]) => {
    const about = { role: "img", "aria-label": name, preserveAspectRatio: "none" };
    const chart = { x: { name: "t, s" }, y: { name }, lines };
    return { chart, svg: make("svg", about), names: legend(chart), cursor: path("cursor", "") };
  });
  byId("plots").replaceChildren(...plotted.map(({ svg, names }) => make("div", {}, svg, names)));
  showNumbers(); // which have to have their room
  for (const one of plotted) {
    one.field = plot(one.chart, one.svg);
    one.svg.append(one.cursor);
    const { at } = one.field.x;
    one.svg.onpointerdown = one.svg.onpointermove = ({ buttons, offsetX }) =>
      buttons && seek(Math.round((offsetX - at(0)) / (at(dt) - at(0))));
  }
}

function showNumbers() {
  for (const { chart, names, field, cursor } of plotted) {
    chart.lines.forEach(({ name, values }, i) => {
      names.children[i].lastChild.data = ` ${name} ${text(values[columnShown()], 4)}`;
    });
    if (field) cursor.setAttribute("d", `M ${field.x.at(shown() * dt)} 10 V ${field.bottom}`);
  }
}
