// Lays out what the study measured: the verdict, where methods fail, and the charts.

const byId = (id) => document.getElementById(id);
const link = (href, text) => make("a", { href }, text);

byId("wrong").hidden = !study.wrong;

let card;
for (const { about, text, chart, question } of study.verdicts) {
  if (about) byId("verdict").append((card = make("section", {}, make("h2", {}, about))));
  card.append(make("p", {}, `${text} `, link(`#${chart}`, "Chart"), ", ", link("explore.html", `question ${question}`), "."));
}
for (const { due, found, chart } of study.trials) {
  const row = [make("th", { scope: "row" }, link(`#${chart.id}`, chart.title)), make("td", {}, due), make("td", {}, found)];
  byId("trials").append(make("tr", {}, ...row));
  byId("stability").append(figure(chart));
}
byId("charts").append(...study.charts.map(figure));
