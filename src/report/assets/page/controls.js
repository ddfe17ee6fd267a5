// What the reader sets: play, time, pace, colours, runs shown; and the keys.

if (player) (() => {
  const [play, scrub, clockText, pace, colour, background, which] =
    ["play", "scrub", "clock", "pace", "colour", "background", "which"].map(element);
  const keysOfPlayer = { " ": clock.toggle, ArrowLeft: () => clock.step(-1), ArrowRight: () => clock.step(1),
    Home: () => clock.set(clock.first), End: () => clock.set(clock.last) };
  const keysOfCells = { ArrowDown: () => selection.step(1), ArrowUp: () => selection.step(-1), Escape: () => selection.choose(null) };

  function fillPaces() {
    const ratios = [0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10].map((share) => clock.round(clock.usual * share));
    const all = [...new Set([1, ...ratios])].sort((a, b) => a - b);
    for (const ratio of all) pace.add(new Option(paceText(ratio), ratio, ratio === clock.usual, ratio === clock.usual));
    clock.pace(clock.usual);
  }

  function fillRuns() {
    which.hidden = data.playing.length < 2;
    data.playing.forEach((run, k) => {
      const label = document.createElement("label"), box = document.createElement("input");
      box.type = "checkbox";
      box.checked = player.state.shown.includes(run);
      box.value = k;
      box.addEventListener("change", showRuns);
      label.append(box, " " + run.label);
      which.append(label);
    });
  }
  // One at least stays.
  function showRuns(event) {
    const boxes = [...which.querySelectorAll("input")];
    if (!boxes.some((box) => box.checked)) event.target.checked = true;
    player.state.shown = boxes.filter((box) => box.checked).map((box) => data.playing[Number(box.value)]);
    selection.refresh();
    player.redraw();
  }

  // Controls keep their own keys; space on a button presses it.
  function onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const act = keysOfPlayer[event.key] || (event.target === player.canvas && keysOfCells[event.key]);
    if (!act || ![player.canvas, scrub].includes(event.target)) return;
    event.preventDefault();
    if (event.key !== " " && keysOfPlayer[event.key]) clock.stop();
    act();
  }

  function tell() {
    play.textContent = clock.playing() ? "Pause" : "Play";
    clockText.textContent = "t = " + clock.text();
    scrub.value = clock.time();
    scrub.setAttribute("aria-valuetext", clockText.textContent);
  }

  colours.offered.forEach((q, k) => colour.add(new Option(q.name, k)));
  fillPaces();
  fillRuns();
  [scrub.min, scrub.max, scrub.step] = [clock.first, clock.last, "any"];
  play.addEventListener("click", () => clock.toggle());
  scrub.addEventListener("input", () => {
    const to = Number(scrub.value);
    clock.stop();
    clock.set(to);
  });
  pace.addEventListener("change", () => clock.pace(Number(pace.value)));
  colour.addEventListener("change", () => { player.state.quantity = colours.offered[Number(colour.value)]; player.redraw(); });
  background.addEventListener("change", () => { player.state.background = background.checked; player.redraw(); });
  element("player").addEventListener("keydown", onKey);
  clock.onChange(tell);
  clock.set(clock.last);
  player.draw();
})();
