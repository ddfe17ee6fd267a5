// Charts over time, of the series of the runs and of every cell; a line marks the time of the clock, a click sets it.

const charts = (() => {
  const light = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#8a6d00"];
  const dark = ["#4fb0f0", "#f08040", "#2fc49a", "#e09ac4", "#f0b840", "#9ad4ff", "#c8b060"];
  const colourOf = (r) => (theme.now().dark ? dark : light)[r % 7];
  const dashes = [[], [8, 4], [2, 3]];
  const made = [];

  const meaningOf = (key) => {
    for (const run of data.runs) {
      const column = run.column(key) || (run.cells && run.cells.has(key) && run.cells.column(key));
      if (column) return column;
    }
    return { key, unit: "", meaning: "" };
  };
  const milliseconds = (times) => times.map((t) => t * 1e3);
  const scaled = (values, factor) => values.map((v) => (v === null || Number.isNaN(v) ? null : v * factor));

  // Curves as {label, times [ms], values, and how they look}: cells thin, means thick, the chosen cell last. The legend leaves out the quiet
  // ones; of several runs it names the cells of each once, without a value.
  function curvesOf(key, factor, chosen) {
    const curves = [];
    data.runs.forEach((run, r) => {
      const column = run.column(key), each = run.cells && run.cells.has(key) && (data.single || !column);
      const times = run.cells ? milliseconds(run.cells.time) : [];
      for (let c = 0; each && c < run.cells.count; ++c)
        curves.push({ label: run.label + ", each cell", times, values: scaled(run.cells.curve(key, c), factor),
          stroke: data.single ? theme.now().faint : colourOf(r), width: 0.8, quiet: data.single || c > 0, mute: true });
      if (column && run.column("time"))
        curves.push({ label: data.single ? (each ? "mean" : key) : run.label, times: milliseconds(run.column("time").values),
          values: scaled(column.values, factor), stroke: colourOf(r), width: 2, dash: dashes[Math.floor(r / 7) % dashes.length] });
    });
    if (chosen && chosen.run.cells && chosen.run.cells.has(key))
      curves.push({ label: (data.single ? "" : chosen.run.label + " ") + "cell " + chosen.number, times: milliseconds(chosen.run.cells.time),
        values: scaled(chosen.run.cells.curve(key, chosen.number), factor), stroke: theme.now().ink, width: 2.5 });
    return curves;
  }

  // One time axis for all: those of the same times share a table, tables are joined, gaps are null.
  function joined(curves) {
    const tables = new Map();
    for (const curve of curves) {
      const name = curve.times.length + " " + curve.times[0] + " " + curve.times[1];
      if (!tables.has(name)) tables.set(name, { data: [curve.times], curves: [] });
      tables.get(name).data.push(curve.values);
      tables.get(name).curves.push(curve);
    }
    const list = [...tables.values()];
    return { table: list.length === 1 ? list[0].data : uPlot.join(list.map((t) => t.data)), curves: list.flatMap((t) => t.curves) };
  }

  const tick = (v) => (v === 0 ? "0" : Math.abs(v) < 1e-3 || Math.abs(v) >= 1e5 ? v.toExponential(1) : String(+v.toPrecision(6)));

  function options(key, curves, place, drawn) {
    const [factor, unit] = data.convert(meaningOf(key).unit), now = theme.now(), font = theme.font(13), line = { stroke: now.line };
    return {
      width: place.clientWidth, height: 250,
      series: [{ label: "time [ms]" }, ...curves.map((c) => ({ label: c.label, stroke: c.stroke, width: c.width, dash: c.dash, spanGaps: true,
        points: { show: false }, value: (_, v) => (c.mute ? "" : v == null ? "–" : v.toPrecision(4)) }))],
      scales: { x: { time: false } },
      hooks: { draw: [drawn] },
      axes: [{ label: "time [ms]", font, labelFont: font, stroke: now.ink, grid: { show: false }, ticks: line },
        { label: key + (unit ? " [" + unit + "]" : ""), font, labelFont: font, stroke: now.ink, size: 64, grid: line, ticks: line,
          values: (_, ticks) => ticks.map(tick) }],
    };
  }

  // The line at the time of the clock, and a click that sets it. (A drag looks closer.)
  function followClock(plot) {
    const mark = document.createElement("div");
    mark.className = "now";
    plot.over.append(mark);
    let pressed = 0;
    plot.over.addEventListener("mousedown", (event) => { pressed = event.clientX; });
    plot.over.addEventListener("click", (event) => {
      const at = event.clientX - plot.over.getBoundingClientRect().left;
      if (data.playing.length && Math.abs(event.clientX - pressed) < 4) clock.set(plot.posToVal(at, "x") * 1e-3);
    });
    return () => {
      const at = plot.valToPos(clock.time() * 1e3, "x");
      mark.hidden = !data.playing.length || !(at >= 0 && at <= plot.over.clientWidth);
      mark.style.transform = "translateX(" + at + "px)";
    };
  }

  // Cells of more than a few runs in one chart could not be told apart.
  function keysOf(onlyCells) {
    const keys = new Set(), few = data.runs.length <= 6;
    for (const run of data.runs) {
      if (!onlyCells) run.columns.forEach((c) => c.values.some((v) => v !== null) && keys.add(c.key));
      if (run.cells && (few || onlyCells)) run.cells.keys.forEach((k) => keys.add(k.key));
    }
    keys.delete("time");
    keys.delete("step");
    return [...keys];
  }

  // `chosen` gives the cell to mark.
  function make(box, chosen) {
    const select = box.querySelector("select"), place = box.querySelector(".place"), note = box.querySelector(".meaning-note");
    const keys = keysOf(box.dataset.of === "cell"), wanted = box.dataset.keys.split(" ").find((k) => keys.includes(k)) || keys[0];
    for (const key of keys) select.add(new Option(key, key, key === wanted, key === wanted));
    let plot = null, follow = () => {};
    function draw() {
      if (plot) plot.destroy();
      plot = null;
      follow = () => {};
      if (!select.value || !place.clientWidth) return;
      const info = meaningOf(select.value), found = curvesOf(select.value, data.convert(info.unit)[0], chosen());
      if (!found.length) return;
      const { table, curves } = joined(found);
      note.textContent = info.meaning;
      plot = new uPlot(options(select.value, curves, place, () => follow()), table, place);
      plot.root.querySelectorAll(".u-legend .u-series").forEach((row, k) => { row.hidden = k > 0 && curves[k - 1].quiet; });
      follow = followClock(plot);
    }
    select.addEventListener("change", draw);
    new ResizeObserver(() => {
      if (!plot) return draw();
      plot.setSize({ width: place.clientWidth, height: 250 });
      follow();
    }).observe(place);
    clock.onChange(() => follow());
    theme.onChange(draw);
    made.push({ draw });
    draw();
  }

  document.querySelectorAll(".chart").forEach((box) => make(box, () => (player ? player.state.cell : null)));
  if (selection) selection.onChange(() => made.forEach((chart) => chart.draw()));
  return { made };
})();
