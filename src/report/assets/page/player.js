// The picture: draws the runs shown at the time of the clock, and knows what is where on it.

const player = (() => {
  const canvas = element("picture");
  if (!canvas || !data.playing.length) return null;
  const context = canvas.getContext("2d");
  const state = { shown: data.playing.slice(0, 6), quantity: colours.offered[0], background: true, cell: null, fixed: null, sharpness: 0 };
  let panels = [], size = { width: 0, height: 0 }, waiting = false;

  // As wide as the page, and so high that the controls stay in the window with it.
  function arrange() {
    const controls = element("controls").offsetHeight, width = canvas.parentElement.clientWidth;
    const found = state.fixed || layout.of(state.shown, width, window.innerHeight - controls - 24);
    const ratio = state.fixed ? canvas.width / found.width : state.sharpness || window.devicePixelRatio || 1;
    panels = found.panels;
    size = found;
    if (state.fixed) return ratio;
    canvas.style.height = found.height + "px";
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(found.height * ratio);
    return ratio;
  }

  function drawPanel(panel) {
    const time = clock.time(), k = panel.run.player.frame(time);
    context.save();
    context.beginPath();
    context.rect(panel.x, panel.y, panel.width, panel.height);
    context.clip();
    if (state.background) field.speed(context, panel, k);
    field.walls(context, panel);
    const mine = state.cell && state.cell.run === panel.run;
    cells.draw(context, panel, k, panel.run.player.times[k], state.quantity, mine ? state.cell.number : -1);
    field.places(context, panel);
    context.restore();
    frame.axes(context, panel);
    frame.above(context, panel, panels.length === 1, time);
  }

  // The bar of the flow tells the time of its field where that is not the time of the cells.
  function flowName() {
    const held = panels.map(({ run: { player: p } }) => {
      const k = p.frame(clock.time()), found = field.latest(p, k);
      return { found, late: found !== k, time: p.times[found] };
    });
    if (held.every((h) => h.found === null)) return "speed of the flow, none yet";
    if (!held.some((h) => h.late)) return "speed of the flow";
    return "speed of the flow" + (held.length === 1 ? " at " + clock.text(held[0].time) : ", latest");
  }

  // Between which ends head and foot stand.
  const ends = () => ({ left: Math.min(...panels.map((p) => p.left)), right: Math.max(...panels.map((p) => p.right)) });

  // Names and colours, of the run that has most.
  function kindsShown() {
    const most = panels.map(({ run }) => run.player.kinds).reduce((a, b) => (b.length > a.length ? b : a));
    return most.map((name, kind) => [name, colours.ofKind(kind)]);
  }

  function drawBars() {
    const q = state.quantity, bars = [];
    const bar = (...what) => bars.push((x, wide) => frame.bar(context, ...what, x, size.foot, wide));
    if (["cell", "piece"].includes(q.where)) bar(q.name, colours.map("cell"), colours.range(q), q.unit);
    if (q.where === "kind") bars.push((x, wide) => frame.swatches(context, q.name, kindsShown(), x, size.foot, wide));
    if (state.background && colours.fastest > 0) bar(flowName(), colours.map("flow"), [0, colours.fastest], "m/s");
    const { left, right } = ends();
    const wide = Math.min((right - left - 24 * (bars.length - 1)) / Math.max(bars.length, 1), 360);
    bars.forEach((draw, k) => draw(left + k * (wide + 24), wide));
  }

  function drawHead() {
    const { left, right } = ends();
    context.fillStyle = theme.now().ink;
    frame.text(context, "t = " + clock.text(), left, 13, "left", 14, "600");
    context.fillStyle = theme.now().soft;
    if (right - left > 600) frame.text(context, "pace " + paceText(clock.slower()), left + 130, 13, "left", 12.5);
  }

  function draw() {
    waiting = false;
    const ratio = arrange(), now = theme.now();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = now.back;
    context.fillRect(0, 0, size.width, size.height);
    panels.forEach(drawPanel);
    drawBars();
    drawHead();
    const words = "t = " + clock.text() + ", " + paceText(clock.slower());
    canvas.setAttribute("aria-label", state.shown.map((run) => run.label).join(", ") + ": cells at " + words);
  }

  // At most once between two pictures of the screen.
  function redraw() {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(draw);
  }

  // The run and cell at a point of the page, or null.
  function under(event) {
    const box = canvas.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
    const panel = panels.find((p) => x >= p.x && x <= p.x + p.width && y >= p.y && y <= p.y + p.height);
    if (!panel) return null;
    const cell = cells.at(context, panel, panel.run.player.frame(clock.time()), x, y);
    return cell < 0 ? null : { run: panel.run, number: cell };
  }

  // Keeps the size, for as long as a recording goes on.
  function hold(on) { state.fixed = on ? size : null; }

  clock.onChange(redraw);
  theme.onChange(redraw);
  window.addEventListener("resize", redraw);
  return { canvas, state, redraw, draw, under, hold, panels: () => panels };
})();
