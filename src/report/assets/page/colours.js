// What cells and flow are coloured by: maps from numbers to colours, the quantities and their ranges.

const colours = (() => {
  const stops = {
    light: { flow: ["f7fbff", "c6dbef", "6baed6", "2d7dbb", "0b4a8f"], cell: ["fff0b2", "fec05a", "fa803c", "d42820", "6e001e"] },
    dark: { flow: ["0d1420", "12345a", "1f5c94", "5b9acb", "c3ddf2"], cell: ["5a0a26", "b8242a", "f0703a", "fdb95a", "fff3c4"] },
  };
  const several = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"];
  const channels = (hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16));
  function table(names) {
    const list = names.map(channels), steps = [];
    for (let b = 0; b < 256; ++b) {
      const at = b / 255 * (list.length - 1), k = Math.min(Math.floor(at), list.length - 2);
      steps.push(list[k].map((v, i) => Math.round(v + (list[k + 1][i] - v) * (at - k))));
    }
    return steps;
  }
  const tables = { light: {}, dark: {} };
  for (const scheme of ["light", "dark"]) for (const name of ["flow", "cell"]) tables[scheme][name] = table(stops[scheme][name]);
  const map = (name) => tables[theme.now().dark ? "dark" : "light"][name];

  // `where`: a number for each cell, for each piece of membrane, or none.
  const quantities = [
    { key: "lambda_C", name: "λ_C, perimeter / at rest", where: "cell", unit: "" },
    { key: "stretch", name: "local stretch λ", where: "piece", unit: "" },
    { key: "tension", name: "membrane tension", where: "piece", unit: "N/m" },
    { key: "taylor_inertia", name: "Taylor deformation D", where: "cell", unit: "" },
    { key: "velocity", name: "velocity along x", where: "cell", unit: "m/s" },
    { key: "kind", name: "kind of cell", where: "kind", unit: "" },
    { key: "number", name: "number of the cell", where: "number", unit: "" },
    { key: "none", name: "one colour", where: "none", unit: "" },
  ];
  function known(run, q) {
    if (q.key === "stretch") return Boolean(run.player.stretch);
    if (q.key === "tension") return Boolean(run.player.stretch && run.player.stretch.tension);
    if (q.key === "kind") return run.player.kinds.length > 1;
    return q.where !== "cell" || Boolean(run.cells && run.cells.has(q.key));
  }
  const offered = quantities.filter((q) => data.playing.some((run) => known(run, q)));

  // Smallest and largest of all cells, times and runs.
  const ranges = new Map();
  function* valuesOf(run, q) {
    if (q.key === "stretch") yield* [run.player.stretch.low, run.player.stretch.high];
    else if (q.key === "tension") yield* run.player.stretch.tension.flat();
    else for (let row = 0; row < run.cells.time.length; ++row) for (let c = 0; c < run.cells.count; ++c) yield run.cells.value(q.key, c, row);
  }
  function range(q) {
    if (!ranges.has(q.key)) {
      let low = Infinity, high = -Infinity;
      for (const run of data.playing) if (known(run, q)) for (const v of valuesOf(run, q)) { if (v < low) low = v; if (v > high) high = v; }
      ranges.set(q.key, high > low ? [low, high] : [low, low + (Math.abs(low) || 1) * 1e-6]);
    }
    return ranges.get(q.key);
  }
  // The step of the map, 0 … 255, that a number stands on.
  function level(q, value) {
    const [low, high] = range(q);
    return Math.min(Math.max(Math.round(255 * (value - low) / (high - low)), 0), 255);
  }
  const ofKind = (kind) => several[kind % several.length];
  const fastest = Math.max(0, ...data.playing.map((run) => run.player.fastest || 0));
  return { map, offered, known, range, level, several, ofKind, fastest, plain: "#c8372d" };
})();
