// What is drawn: a key of one axis along x, another axis as curves, the others at a value or averaged over.
const { axes, runs, quantities } = JSON.parse(element("data").textContent);
const keys = axes.flatMap((axis, a) => axis.keys.map((key) => ({ ...key, axis: a })));
const average = -1, none = -1;
const choice = { key: 0, curves: none, fixed: [], log: false };
const ownAxis = () => keys[choice.key].axis;
const isSeed = (axis) => axis.keys.length === 1 && axis.keys[0].key === "cells.seed";
const placeName = (axis, place) => axis.keys.map((key) => key.short + " = " + key.values[place]).join(", ");

// Axes of numbers first, then those of words; seeds last.
const byUse = axes.map((_, a) => a).sort((a, b) => {
  const rank = (axis) => (isSeed(axis) ? 0 : axis.keys.some((key) => key.numbers) ? 2 : 1);
  return rank(axes[b]) - rank(axes[a]);
});

function chooseCurves(curves) {
  choice.curves = curves;
  choice.fixed = axes.map((axis, a) => (a === ownAxis() || a === curves || isSeed(axis) ? average : 0));
}

function chooseKey(k) {
  choice.key = k;
  const others = byUse.filter((a) => a !== ownAxis() && !isSeed(axes[a]));
  chooseCurves(others.length ? others[0] : none);
  const numbers = keys[k].numbers;
  choice.log = Boolean(numbers) && Math.min(...numbers) > 0 && Math.max(...numbers) >= 20 * Math.min(...numbers);
}

function chooseFirst() {
  const numeric = keys.findIndex((key) => key.axis === byUse[0] && key.numbers);
  chooseKey(numeric >= 0 ? numeric : keys.findIndex((key) => key.axis === byUse[0]));
}

// Mean over the runs of one point, and its error: the scatter over them; of one run its own.
function over(members, q) {
  const found = members.map((run) => run.means[q]).filter((m) => m && m[0] !== null);
  if (!found.length) return null;
  const n = found.length, mean = found.reduce((sum, m) => sum + m[0], 0) / n;
  if (n === 1) return { mean, error: found[0][1], n };
  const square = found.reduce((sum, m) => sum + (m[0] - mean) ** 2, 0) / (n - 1);
  return { mean, error: Math.sqrt(square / n), n };
}

// [{label, points: [{x, label, runs}]}]
function curvesNow() {
  const { axis, numbers, values } = keys[choice.key];
  const shown = (run) =>
    axes.every((_, a) => a === axis || a === choice.curves || choice.fixed[a] === average || run.places[a] === choice.fixed[a]);
  const curves = new Map();
  for (const run of runs.filter(shown)) {
    const curve = choice.curves === none ? 0 : run.places[choice.curves];
    if (!curves.has(curve)) curves.set(curve, new Map());
    const points = curves.get(curve), place = run.places[axis];
    if (!points.has(place)) points.set(place, { x: numbers ? numbers[place] : place, label: values[place], runs: [] });
    points.get(place).runs.push(run);
  }
  return [...curves].sort((a, b) => a[0] - b[0]).map(([curve, points]) => ({
    label: choice.curves === none ? "" : placeName(axes[choice.curves], curve),
    points: [...points.values()].sort((a, b) => a.x - b.x),
  }));
}

const known = quantities.map((_, q) => runs.map((run) => run.means[q]).filter((m) => m && m[0] !== null));
const indices = quantities.map((_, q) => q);
function differs(q) {
  const values = known[q].map((m) => m[0]), low = Math.min(...values), high = Math.max(...values);
  return values.length > 0 && high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high));
}
const lively = indices.filter(differs);
