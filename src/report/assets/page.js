"use strict";
// Charts of the time series and the player of the cells. Data stands in the page: nothing is fetched.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const colours = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"];
  const dashes = [[], [8, 4], [2, 3]];
  // Units that make numbers of this field readable.
  const shown = { m: [1e6, "µm"], s: [1e3, "ms"], "m/s": [1e3, "mm/s"], "Pa s": [1e3, "mPa s"] };
  const convert = (unit) => shown[unit] || [1, unit];

  function seriesOf(run, key) { return run.columns.find((c) => c.key === key); }

  // One time axis for several runs: the union of their times, gaps as null.
  function aligned(tables) { return tables.length === 1 ? tables[0] : uPlot.join(tables); }

  function chartInput(key) {
    const tables = [], series = [{ label: "time [ms]" }];
    let title = key;
    const single = data.runs.length === 1;
    data.runs.forEach((run, r) => {
      const time = seriesOf(run, "time"), column = seriesOf(run, key);
      if (!time || !column) return;
      const [factor, unit] = convert(column.unit);
      title = key + (unit ? " [" + unit + "]" : "");
      const t = time.values.map((v) => v * 1e3);
      if (single && key === "lambda_C" && run.cells) {
        tables.push([run.cells.time.map((v) => v * 1e3), ...run.cells.values]);
        run.cells.values.forEach((_, c) => series.push({ label: "cell " + c, stroke: "#a6a6a6", width: 0.7, spanGaps: true, points: { show: false } }));
      }
      tables.push([t, column.values.map((v) => (v === null ? null : v * factor))]);
      series.push({ label: single ? "mean" : run.label, stroke: colours[r % colours.length], width: 2,
        dash: dashes[Math.floor(r / colours.length) % dashes.length], spanGaps: true, points: { show: false },
        value: (_, v) => (v == null ? "–" : v.toPrecision(4)) });
    });
    return { title, series, single, table: tables.length ? aligned(tables) : null };
  }

  function makeChart(box, initial) {
    const select = box.querySelector("select"), place = box.querySelector(".place"), note = box.querySelector(".meaning-note");
    const keys = [...new Set(data.runs.flatMap((run) => run.columns.map((c) => c.key)))].filter((k) => k !== "time" && k !== "step");
    for (const key of keys) select.add(new Option(key, key, key === initial, key === initial));
    let plot = null;
    function draw() {
      const { title, series, table, single } = chartInput(select.value);
      if (plot) plot.destroy();
      plot = null;
      if (!table) return;
      const first = data.runs.map((run) => seriesOf(run, select.value)).find(Boolean);
      note.textContent = first ? first.meaning : "";
      const font = "13px system-ui, sans-serif";
      plot = new uPlot({
        width: place.clientWidth, height: 260, series,
        scales: { x: { time: false } },
        legend: { show: !single || series.length <= 10 },
        axes: [{ label: "time [ms]", font, labelFont: font, stroke: "#1a1a1a", grid: { show: false }, ticks: { stroke: "#8c8c8c" } },
               { label: title, font, labelFont: font, stroke: "#1a1a1a", size: 66, grid: { stroke: "#ececec" }, ticks: { stroke: "#8c8c8c" },
                 values: (_, ticks) => ticks.map((v) => (v === 0 ? "0" : Math.abs(v) < 1e-3 || Math.abs(v) >= 1e5 ? v.toExponential(1) : String(+v.toPrecision(6)))) }],
      }, table, place);
    }
    select.addEventListener("change", draw);
    new ResizeObserver(() => { if (plot) plot.setSize({ width: place.clientWidth, height: 260 }); }).observe(place);
    draw();
  }

  document.querySelectorAll(".chart").forEach((box) => makeChart(box, box.dataset.key));

  // ---- player ----
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const players = data.players;
  const canvas = document.getElementById("picture");
  if (!canvas || !players.length) return;
  for (const p of players) {
    p.position = new Int16Array(bytes(p.nodes).buffer);
    p.speedBytes = bytes(p.speed);
  }
  const element = (id) => document.getElementById(id);
  const [play, scrub, pace, speed, clock, which, scale] = ["play", "scrub", "pace", "background", "clock", "which", "scale"].map(element);
  const context = canvas.getContext("2d");
  const buffer = document.createElement("canvas");

  function mix(stops, s) {
    const at = Math.min(Math.max(s, 0), 1) * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
    return stops[k].map((v, i) => Math.round(v + (stops[k + 1][i] - v) * (at - k)));
  }
  const blues = [[247, 251, 255], [198, 219, 239], [107, 174, 214], [45, 125, 187], [11, 74, 143]];
  const reds = [[255, 240, 178], [254, 192, 90], [250, 128, 60], [212, 40, 32], [110, 0, 30]];

  const all = players.flatMap((p) => p.stretches.flat()).filter((v) => v !== null);
  const range = all.length ? [Math.min(...all.map((v) => v)), Math.max(...all)] : null;
  if (range && range[1] - range[0] < 1e-6) range[1] = range[0] + 1e-6;
  const colourOf = (stretch) => (range && stretch != null ? mix(reds, (stretch - range[0]) / (range[1] - range[0])) : [200, 55, 45]);
  if (range) {
    const strip = scale.getContext("2d");
    for (let x = 0; x < scale.width; ++x) {
      strip.fillStyle = "rgb(" + mix(reds, x / (scale.width - 1)) + ")";
      strip.fillRect(x, 0, 1, scale.height);
    }
    element("low").textContent = range[0].toFixed(3);
    element("high").textContent = range[1].toFixed(3);
  } else {
    element("legend").hidden = true;
  }

  // Frames stand at the times at which they were recorded; the clock runs evenly between them.
  let player = players[0], frame = 0, timer = 0, time = 0;
  const last = Math.max(...players.map((p) => p.times[p.times.length - 1]));
  const most = Math.max(...players.map((p) => p.times.length));
  players.forEach((p, k) => which.add(new Option(p.label, k)));
  element("which-label").hidden = players.length < 2;

  function drawSpeed() {
    const field = player.fields[frame];  // null: recorded without
    if (field === null) return;
    buffer.width = player.columns;
    buffer.height = player.rows;
    const pixels = new ImageData(player.columns, player.rows), size = player.columns * player.rows;
    for (let j = 0; j < player.rows; ++j)
      for (let i = 0; i < player.columns; ++i) {
        const value = player.speedBytes[field * size + (player.rows - 1 - j) * player.columns + i] / 255;
        pixels.data.set([...mix(blues, value), 255], 4 * (j * player.columns + i));
      }
    buffer.getContext("2d").putImageData(pixels, 0, 0);
    context.drawImage(buffer, 0, 0, canvas.width, canvas.height);
  }

  // Solid is what an odd number of loops goes around.
  function drawWalls() {
    const perMetre = canvas.width / player.length;
    context.beginPath();
    for (let w = 0; w + 1 < player.wall_first.length; ++w) {
      for (let k = player.wall_first[w]; k < player.wall_first[w + 1]; ++k) {
        const x = player.walls[2 * k] * perMetre, y = canvas.height - player.walls[2 * k + 1] * perMetre;
        if (k === player.wall_first[w]) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
      context.closePath();
    }
    context.fillStyle = "#8a8a8a";
    context.strokeStyle = "#4a4a4a";
    context.lineWidth = Math.max(1, canvas.width / 900);
    context.fill("evenodd");
    context.stroke();
  }

  function drawCells() {
    const perMetre = canvas.width / player.length, count = player.first[player.first.length - 1];
    const images = [];
    for (const along of [-player.length, 0, player.length])
      for (const up of [-player.width, 0, player.width]) images.push([along, up]);
    for (let c = 0; c + 1 < player.first.length; ++c) {
      const colour = colourOf(player.stretches[frame][c]);
      for (const [shift, up] of images) {
        context.beginPath();
        for (let k = player.first[c]; k < player.first[c + 1]; ++k) {
          const at = 2 * (frame * count + k);
          const x = player.position[at] * player.quantum + shift, y = player.position[at + 1] * player.quantum + up;
          context.lineTo(x * perMetre, canvas.height - y * perMetre);
        }
        context.closePath();
        context.fillStyle = "rgba(" + colour + ",0.92)";
        context.strokeStyle = "#4d0c0c";
        context.lineWidth = Math.max(1, canvas.width / 900);
        context.fill();
        context.stroke();
      }
    }
  }

  // As wide as the page, but no higher than leaves the controls in view.
  function fit() {
    const aspect = player.length / player.width, room = canvas.parentElement.clientWidth;
    const wide = Math.max(1, Math.floor(Math.min(room, 0.7 * window.innerHeight * aspect)));
    canvas.style.width = wide + "px";
    canvas.style.height = Math.max(1, Math.round(wide / aspect)) + "px";
    return wide * (window.devicePixelRatio || 1);
  }

  function draw() {
    const across = fit();
    canvas.width = Math.max(1, Math.round(across));
    canvas.height = Math.max(1, Math.round(across * player.width / player.length));
    context.fillStyle = "#fff";
    context.fillRect(0, 0, canvas.width, canvas.height);
    if (speed.checked) drawSpeed();
    drawWalls();
    drawCells();
    clock.textContent = "t = " + (player.times[frame] * 1e3).toPrecision(4) + " ms";
    scrub.value = time;
    scrub.setAttribute("aria-valuetext", clock.textContent);
  }

  function stop() {
    cancelAnimationFrame(timer);
    timer = 0;
    play.textContent = "Play";
  }
  // The latest frame not after `to`.
  function go(to) {
    time = to;
    frame = player.times.findLastIndex((t) => t <= to * (1 + 1e-9));
    frame = Math.max(frame, 0);
    draw();
  }
  // At pace 1 the whole run takes a tenth of a second a frame.
  let before = 0;
  function tick(now) {
    const end = player.times[player.times.length - 1], passed = Math.min(now - before, 500);
    const to = time + passed * Number(pace.value) * last / (100 * most);
    before = now;
    go(time >= end ? 0 : Math.min(to, end));
    timer = requestAnimationFrame(tick);
  }
  play.addEventListener("click", () => {
    if (timer) return stop();
    play.textContent = "Pause";
    before = performance.now();
    timer = requestAnimationFrame(tick);
  });
  scrub.addEventListener("input", () => { stop(); go(Number(scrub.value)); });
  speed.addEventListener("change", draw);
  which.addEventListener("change", () => {
    player = players[Number(which.value)];
    go(time);
  });
  window.addEventListener("resize", draw);
  scrub.max = last;
  scrub.step = last / 1000 || 1;
  go(last);
})();
