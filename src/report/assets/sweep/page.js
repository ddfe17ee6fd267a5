// The controls, and what they show.
function showFigures() {
  const curves = curvesNow(), numbers = keys[choice.key].numbers;
  const any = (q) => curves.some((curve) => curve.points.some((point) => over(point.runs, q)));
  element("plots").replaceChildren(...lively.filter(any).map((q) => figure(q, curves)));
  element("curves").replaceChildren(...(choice.curves === none ? [] : curves.map((curve, c) => {
    const item = make("li"), line = svg("svg", { viewBox: "0 0 32 12" }), paint = colour(c, curves.length);
    line.append(svg("line", { x1: 0, x2: 32, y1: 6, y2: 6, stroke: paint, "stroke-width": 2 }), svg("circle", { cx: 16, cy: 6, r: 3.4, fill: paint }));
    item.append(line, curve.label);
    return item;
  })));
  const several = curves.some((curve) => curve.points.some((point) => point.runs.length > 1));
  element("what").textContent = several
    ? "A point is the mean over runs that differ in nothing else shown. Its bar is their standard deviation over the root of their number, " +
      "or of a single run the standard error over time."
    : "Bars are standard errors of the mean over time, by batch means (one standard deviation).";
  element("log").parentElement.hidden = !numbers || Math.min(...numbers) <= 0;
}

function showAll() {
  showControls();
  showFigures();
  showDifferences();
}

function showControls() {
  const others = axes.map((axis, a) => [a, axis]).filter(([a]) => a !== ownAxis());
  const names = (axis) => axis.keys.map((key) => key.key).join(", ");
  const change = (act) => (value) => { act(value); showAll(); };
  const parts = [select("along", "along x", keys.map((key, k) => [k, key.key]), choice.key, change(chooseKey))];
  if (others.length)
    parts.push(select("as-curves", "curves", [[none, "none"], ...others.map(([a, axis]) => [a, names(axis)])], choice.curves, change(chooseCurves)));
  for (const [a, axis] of others.filter(([other]) => other !== choice.curves)) {
    const places = axis.keys[0].values.map((_, p) => [p, placeName(axis, p)]);
    const act = change((p) => { choice.fixed[a] = p; });
    parts.push(select("at-" + a, axis.keys[0].short, [[average, "mean over all"], ...places], choice.fixed[a], act));
  }
  const box = make("label", {}, " logarithmic x"), tick = make("input", { type: "checkbox", id: "log" });
  tick.checked = choice.log;
  tick.addEventListener("change", () => { choice.log = tick.checked; showFigures(); });
  box.prepend(tick);
  element("choices").replaceChildren(...parts, box);
}

const constant = indices.filter((q) => known[q].length > 0 && !differs(q));
if (constant.length && runs.length > 1) {
  const texts = constant.map((q) => quantities[q].name + " " + plain(known[q][0][0]) + (quantities[q].unit ? " " + quantities[q].unit : ""));
  element("same").textContent = "The same in all runs: " + texts.join(", ") + ".";
}
showRuns();
if (lively.length) {
  chooseFirst();
  showAll();
} else {
  element("what").textContent = runs.some((run) => run.ending === "done") ? "No quantity differs between the runs." : "No run is finished yet.";
}
