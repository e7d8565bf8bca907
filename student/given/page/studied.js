// Lays out what the study measured: the verdict, where methods fail, and the charts.

const link = (href, text) => make("a", { href }, text);

byId("wrong").hidden = !study.wrong;
for (const { about, text, chart, question } of study.verdicts) {
  if (about) byId("verdict").append(make("section", {}, make("h2", {}, about)));
  const links = [link(`#${chart}`, "Chart"), ", ", link("explore.html", `question ${question}`)];
  byId("verdict").lastElementChild.append(make("p", {}, `${text} `, ...links, "."));
}
const [head, ...causes] = byId("causes").rows;
for (const { title, cells } of study.causes) {
  head.append(make("th", { scope: "col" }, title));
  cells.forEach(([words, share], i) => {
    const bar = make("div", { class: "bar own", style: `width: ${share}%` });
    causes[i].append(make("td", {}, words, share ? bar : ""));
  });
}
for (const { name, found, lines } of study.trials) {
  const { textContent: sentence, dataset } = byId(`about-${name}`); // which the page has
  const [title, , cell] = byId(`row-${name}`).cells;
  cell.textContent = found;
  const [x, y] = [dataset.x, dataset.y].map((axis) => ({ name: axis, log: "log" in dataset }));
  byId("stability").append(figure({ id: name, title: title.textContent, x, y, lines, sentence }));
}
byId("charts").append(...study.charts.map(figure));
