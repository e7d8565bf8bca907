// Lays out what the study measured: the verdict, where methods fail, and the charts.

const byId = (id) => document.getElementById(id);
const link = (href, text) => make("a", { href }, text);

byId("wrong").hidden = !study.wrong;

let card;
for (const { about, text, chart, question } of study.verdicts) {
  if (about) byId("verdict").append((card = make("section", {}, make("h2", {}, about))));
  card.append(make("p", {}, `${text} `, link(`#${chart}`, "Chart"), ", ", link("explore.html", `question ${question}`), "."));
}
for (const { name, found, lines } of study.trials) {
  const words = byId(`about-${name}`); // which the page has
  const [title, , cell] = byId(`row-${name}`).cells;
  cell.textContent = found;
  const [x, y] = ["x", "y"].map((axis) => ({ name: words.dataset[axis], log: "log" in words.dataset }));
  byId("stability").append(figure({ id: name, title: title.textContent, x, y, lines, sentence: words.textContent }));
}
byId("charts").append(...study.charts.map(figure));
