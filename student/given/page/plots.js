// ---- plots ----

const plotting = plots.getContext("2d");
let still = null; // the plots without their cursor, drawn once for each size and colour

// Each line has its own dash and name, so that no colour is needed.
function panels() {
  const height = [{ name: "\u03c6", values: lows.map(({ y }) => y), colour: "corner", dash: [], width: 2 }];
  if (comparing()) height.push({ name: "right", values: lowsRight.map(({ y }) => y), colour: "right", dash: [6, 4], width: 1.5 });
  const found = [{ title: "height \u03c6 of the lowest corner, m", lines: height }];
  if (many.length) {
    const apart = q[0].map((x, t) => Math.max(...many.map((path) => Math.hypot(path[0][t] - x, path[1][t] - q[1][t]))));
    found.unshift({ title: "farthest from the square in the middle, m", lines: [{ name: "apart", values: apart, colour: "right", dash: [], width: 2 }] });
  }
  if (!motion) return found;
  const all = q[0].map((_, t) => energies(t));
  const line = (name, colour, dash, width) => ({ name, values: all.map((e) => e[name]), colour, dash, width });
  const lines = [line("total", "text", [], 2), line("kinetic", "square", [7, 3], 1.5), line("potential", "force", [2, 3], 1.5)];
  return [...found, { title: "energy, J", lines }];
}

const edges = { left: 54, right: 84, top: 20, bottom: 20, gap: 26 };
const timeX = (s) => edges.left + (s / Math.max(T - 1, 1)) * (plots.clientWidth - edges.left - edges.right);

// Names at the lines' ends, moved apart if they would overlap.
function drawNames(on, lines, Y, low, high) {
  const ends = lines.map((line) => ({ line, at: Y(line.values[line.values.length - 1]) || low }));
  ends.sort((a, b) => a.at - b.at);
  ends.forEach((end, i) => (end.at = Math.max(Math.min(end.at, low - 14 * (ends.length - 1 - i)), i > 0 ? ends[i - 1].at + 14 : high)));
  for (const { line, at } of ends) {
    const X = plots.clientWidth - edges.right + 6;
    on.setLineDash(line.dash);
    on.strokeStyle = colour[line.colour];
    on.lineWidth = line.width;
    on.beginPath();
    on.moveTo(X, at);
    on.lineTo(X + 12, at);
    on.stroke();
    on.fillStyle = colour.text;
    on.fillText(line.name, X + 15, at + 4);
  }
  on.setLineDash([]);
}

function drawPanel(on, { title, lines }, top, height) {
  const [low, high] = lines.reduce((range, line) => span(line.values, range), [0, 0]);
  const Y = (value) => top + height - ((value - low) / (high - low || 1)) * height;
  on.fillStyle = colour.quiet;
  on.textAlign = "left";
  on.fillText(title, edges.left, top - 7);
  on.textAlign = "right";
  for (const value of new Set([low, 0, high])) {
    on.fillStyle = colour.grid;
    on.fillRect(edges.left, Math.round(Y(value)), timeX(T - 1) - edges.left, 1);
    on.fillStyle = colour.quiet;
    if (value === 0 || Math.abs(Y(value) - Y(0)) > 12) on.fillText(text(value, Math.max(0, 2 - Math.floor(Math.log10(high - low || 1)))).slice(0, 8), edges.left - 6, Y(value) + 4);
  }
  on.textAlign = "left";
  for (const line of lines) {
    on.setLineDash(line.dash);
    on.strokeStyle = colour[line.colour];
    on.lineWidth = line.width;
    on.beginPath();
    line.values.slice(0, T).forEach((value, t) => on.lineTo(timeX(t), Y(value)));
    on.stroke();
  }
  drawNames(on, lines, Y, top + height, top);
}

function drawStill() {
  const ratio = window.devicePixelRatio || 1;
  plots.width = Math.max(1, Math.round(plots.clientWidth * ratio));
  plots.height = Math.max(1, Math.round(plots.clientHeight * ratio));
  still = new OffscreenCanvas(plots.width, plots.height);
  const on = still.getContext("2d");
  on.scale(ratio, ratio);
  on.lineJoin = "round";
  on.font = "12px system-ui, -apple-system, sans-serif";
  const shown = panels();
  const room = plots.clientHeight - edges.top - edges.bottom - edges.gap * (shown.length - 1);
  shown.forEach((panel, i) => drawPanel(on, panel, edges.top + i * (room / shown.length + edges.gap), room / shown.length));
  on.fillStyle = colour.quiet;
  on.fillText("0 s", edges.left, plots.clientHeight - 5);
  on.textAlign = "right";
  on.fillText(`${text((T - 1) * dt, timePlaces)} s`, timeX(T - 1), plots.clientHeight - 5);
}

function drawPlots() {
  if (!still) return;
  const ratio = plots.width / plots.clientWidth;
  plotting.setTransform(1, 0, 0, 1, 0, 0);
  plotting.clearRect(0, 0, plots.width, plots.height);
  plotting.drawImage(still, 0, 0);
  plotting.fillStyle = colour.text;
  plotting.fillRect(Math.round((timeX(shown()) - 0.75) * ratio), 0, Math.max(1, Math.round(1.5 * ratio)), plots.height - 18 * ratio);
}

// The column under a pointer.
function columnAt(event) {
  const share = (event.offsetX - timeX(0)) / (timeX(T - 1) - timeX(0) || 1);
  return Math.round(Math.min(Math.max(share, 0), 1) * (T - 1));
}
