"use strict";
// What the page carries: runs with their series, cells and frames. Nothing is fetched.

const data = (() => {
  function bytes(text) {
    const letters = atob(text), list = new Uint8Array(letters.length);
    for (let k = 0; k < list.length; ++k) list[k] = letters.charCodeAt(k);
    return list;
  }
  // Units that make numbers of this field readable.
  const shown = { m: [1e6, "µm"], "m^2": [1e12, "µm²"], s: [1e3, "ms"], "m/s": [1e3, "mm/s"], "Pa s": [1e3, "mPa s"], "Pa/m": [1e-3, "kPa/m"],
    "N/m": [1e6, "µN/m"], "m^2/s": [1e9, "10⁻⁹ m²/s"] };
  const convert = (unit) => shown[unit] || [1, unit];

  // The last index whose value is not after `to`; 0 if all are.
  function lastBefore(times, to) {
    let low = 0, high = times.length;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= to * (1 + 1e-9)) low = middle;
      else high = middle;
    }
    return low;
  }

  function nearest(times, to) {
    const k = lastBefore(times, to);
    return k + 1 < times.length && times[k + 1] - to < to - times[k] ? k + 1 : k;
  }

  function openCells(cells) {
    const values = new Float32Array(bytes(cells.values).buffer), rows = cells.time.length;
    const index = new Map(cells.keys.map((k, i) => [k.key, i]));
    cells.has = (key) => index.has(key);
    cells.column = (key) => cells.keys[index.get(key)];
    cells.value = (key, cell, row) => values[(index.get(key) * rows + row) * cells.count + cell];
    cells.row = (time) => nearest(cells.time, time);
    cells.curve = (key, cell) => cells.time.map((_, row) => cells.value(key, cell, row));
  }

  function openPlayer(p) {
    p.position = new Int16Array(bytes(p.nodes).buffer);
    p.speedBytes = bytes(p.speed);
    p.nodeCount = p.first[p.first.length - 1];
    p.cellCount = p.first.length - 1;
    if (p.stretch) p.stretch.level = bytes(p.stretch.bytes);
    p.frame = (time) => lastBefore(p.times, time);
    p.last = p.times[p.times.length - 1];
  }

  const all = JSON.parse(document.getElementById("data").textContent).runs;
  for (const run of all) {
    if (run.cells) openCells(run.cells);
    if (run.player) openPlayer(run.player);
    run.column = (key) => run.columns.find((c) => c.key === key);
  }
  return { runs: all, playing: all.filter((run) => run.player), convert, single: all.length === 1, nearest };
})();

const element = (id) => document.getElementById(id);
