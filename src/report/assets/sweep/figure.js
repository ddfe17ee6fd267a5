// A quantity against the key along x.
const dark = matchMedia("(prefers-color-scheme: dark)").matches;
const colours = [dark ? "#4DA3E0" : "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#B07A00", dark ? "#9AD4F5" : "#2A9FD6", "#7F7F7F"];
const ramp = [dark ? [150, 110, 190] : [68, 1, 84], dark ? [110, 130, 200] : [59, 82, 139], [33, 145, 140], [94, 201, 98], [200, 190, 20]];

function colour(k, count) {
  if (count <= colours.length) return colours[k];
  const at = (k / (count - 1)) * (ramp.length - 1), low = Math.min(Math.floor(at), ramp.length - 2);
  return "rgb(" + ramp[low].map((v, i) => Math.round(v + (ramp[low + 1][i] - v) * (at - low))) + ")";
}

function ticks(low, high, most) {
  const rough = (high - low) / most, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((s) => s * power >= rough * (1 - 1e-9));
  const list = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) list.push(k * step);
  return list;
}

function logTicks(low, high) {
  const list = [], multiples = high / low > 300 ? [1] : high / low > 30 ? [1, 3] : [1, 2, 5];
  for (let p = Math.floor(Math.log10(low)); p <= Math.ceil(Math.log10(high)); ++p)
    for (const m of multiples)
      if (m * 10 ** p >= low * (1 - 1e-9) && m * 10 ** p <= high * (1 + 1e-9)) list.push(m * 10 ** p);
  return list.length > 1 ? list : [low, high];
}

const frame = { width: 330, height: 220, left: 58, right: 12, top: 8, bottom: 40 };
frame.x1 = frame.width - frame.right;
frame.y0 = frame.height - frame.bottom;

// Where an x lies, and the marks of its axis. Words stand evenly.
function xAxis(key, xs) {
  let low = Math.min(...xs), high = Math.max(...xs);
  const words = !key.numbers;
  if (words) [low, high] = [-0.5, key.values.length - 0.5];
  else if (low === high) [low, high] = [low - (Math.abs(low) || 1) / 2, high + (Math.abs(high) || 1) / 2];
  const log = choice.log && !words && low > 0, scale = log ? Math.log : (v) => v;
  const span = scale(high) - scale(low), pad = words ? 0 : 0.04 * span;
  const at = (x) => frame.left + ((scale(x) - scale(low) + pad) / (span + 2 * pad)) * (frame.x1 - frame.left);
  return { at, words, marks: words ? key.values.map((_, k) => k) : log ? logTicks(low, high) : ticks(low, high, 6) };
}

// The same upwards, with room for the bars.
function yAxis(points) {
  let low = Math.min(...points.map((p) => p.mean - (p.error || 0))), high = Math.max(...points.map((p) => p.mean + (p.error || 0)));
  const wide = high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high));
  const pad = wide ? 0.07 * (high - low) : (Math.abs(low) || 1) / 10;
  [low, high] = [low - pad, high + pad];
  return { at: (y) => frame.top + ((high - y) / (high - low)) * (frame.y0 - frame.top), marks: ticks(low, high, 5) };
}

function drawAxes(picture, key, x, y) {
  for (const mark of y.marks) {
    picture.append(svg("line", { class: "grid", x1: frame.left, x2: frame.x1, y1: y.at(mark), y2: y.at(mark) }));
    picture.append(svg("text", { x: frame.left - 5, y: y.at(mark) + 4, "text-anchor": "end" }, plain(mark, 6)));
  }
  picture.append(svg("path", { class: "axis", d: "M" + frame.left + " " + frame.top + "V" + frame.y0 + "H" + frame.x1 }));
  const every = Math.max(1, Math.ceil(x.marks.length / 7)), most = Math.max(4, Math.floor((42 * every) / x.marks.length));
  x.marks.forEach((mark, k) => {
    picture.append(svg("line", { class: "axis", x1: x.at(mark), x2: x.at(mark), y1: frame.y0, y2: frame.y0 + 4 }));
    if (k % every) return;
    const text = x.words ? key.values[mark] : plain(mark, 6), short = text.length > most ? text.slice(0, most - 1) + "…" : text;
    picture.append(svg("text", { x: x.at(mark), y: frame.y0 + 16, "text-anchor": "middle" }, short));
  });
  const middle = (frame.left + frame.x1) / 2;
  picture.append(svg("text", { x: middle, y: frame.height - 6, "text-anchor": "middle" }, withUnit(key.short, key.unit)));
}

// A point with its bar; what it is shows where the pointer rests.
function drawPoint(picture, p, at, paint, small, told) {
  const mark = svg("g", { stroke: paint, fill: paint });
  if (p.error > 0) {
    const caps = small ? "" : "M" + (at.x - 3) + " " + at.low + "h6M" + (at.x - 3) + " " + at.high + "h6";
    mark.append(svg("path", { fill: "none", "stroke-width": small ? 0.8 : 1.2, d: "M" + at.x + " " + at.low + "V" + at.high + caps }));
  }
  mark.append(svg("circle", { cx: at.x, cy: at.y, r: small ? 1.6 : 2.8, stroke: "none" }), svg("title", {}, told));
  picture.append(mark);
}

function figure(q, curves) {
  const quantity = quantities[q], key = keys[choice.key];
  const drawn = curves.map((curve) => curve.points.map((p) => ({ ...p, ...over(p.runs, q) })).filter((p) => p.mean !== undefined));
  const all = drawn.flat(), x = xAxis(key, all.map((p) => p.x)), y = yAxis(all);
  const picture = svg("svg", { viewBox: "0 0 " + frame.width + " " + frame.height, role: "img" });
  picture.append(svg("title", {}, quantity.name + " against " + key.key));
  drawAxes(picture, key, x, y);
  drawn.forEach((points, c) => {
    const paint = colour(c, drawn.length);
    const line = points.map((p) => x.at(p.x) + "," + y.at(p.mean)).join(" ");
    if (points.length > 1 && !x.words)
      picture.append(svg("polyline", { points: line, fill: "none", stroke: paint, "stroke-width": 1.3, "stroke-opacity": 0.75 }));
    const aside = x.words && drawn.length > 1 ? (c - (drawn.length - 1) / 2) * Math.min(7, 26 / drawn.length) : 0;
    for (const p of points) {
      const at = { x: x.at(p.x) + aside, y: y.at(p.mean), low: y.at(p.mean - p.error), high: y.at(p.mean + p.error) };
      const told = [curves[c].label, key.short + " = " + p.label, withError(p.mean, p.error) + " " + quantity.unit,
        p.n > 1 ? "mean of " + p.n + " runs" : p.runs[0].name];
      drawPoint(picture, p, at, paint, all.length > 60, told.filter(Boolean).join("\n"));
    }
  });
  const box = make("figure"), caption = make("figcaption");
  caption.append(make("b", {}, withUnit(quantity.name, quantity.unit)), make("span", {}, quantity.meaning));
  box.append(caption, picture);
  return box;
}
