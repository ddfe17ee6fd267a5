// The chosen cell: chosen with the pointer, the list or the arrow keys; its numbers and its curves.

const selection = (() => {
  if (!player) return null;
  const list = element("cell"), panel = element("cell-panel"), body = element("cell-numbers");
  const listeners = [];
  const choices = [null];
  let rows = [], shownRow = -1;

  function fillList() {
    choices.length = 1;
    list.length = 0;
    list.add(new Option("none", 0));
    for (const run of player.state.shown)
      for (let number = 0; number < run.player.cellCount; ++number) {
        choices.push({ run, number });
        list.add(new Option((data.single ? "" : run.label + ", ") + "cell " + number + kindText({ run, number }), choices.length - 1));
      }
  }
  function kindText({ run, number }) {
    const { kind, kinds } = run.player;
    return kinds.length > 1 ? ", " + kinds[kind[number]] : "";
  }
  const indexOf = (cell) => Math.max(choices.findIndex((c) => c && cell && c.run === cell.run && c.number === cell.number), 0);

  function makeTable({ run }) {
    body.replaceChildren();
    rows = [];
    if (!run.cells) return;
    for (const column of run.cells.keys) {
      const row = body.insertRow(), head = document.createElement("th"), [factor, unit] = data.convert(column.unit);
      head.scope = "row";
      head.textContent = column.key + (unit ? " [" + unit + "]" : "");
      head.title = column.meaning;
      row.append(head);
      const value = row.insertCell();
      value.className = "number";
      rows.push({ key: column.key, factor, value });
    }
  }

  function shownText(v) {
    if (Number.isNaN(v)) return "–";
    const plain = v === 0 || (Math.abs(v) >= 1e-3 && Math.abs(v) < 1e5);
    return plain ? String(+v.toPrecision(4)) : v.toExponential(3);
  }

  function showNumbers() {
    const cell = player.state.cell;
    if (!cell || !cell.run.cells) return;
    const row = cell.run.cells.row(clock.time());
    if (row === shownRow) return;
    shownRow = row;
    element("cell-time").textContent = "at " + clock.text(cell.run.cells.time[row]);
    for (const { key, factor, value } of rows) value.textContent = shownText(factor * cell.run.cells.value(key, cell.number, row));
  }

  function choose(cell) {
    player.state.cell = cell;
    list.value = indexOf(cell);
    panel.hidden = !cell;
    shownRow = -1;
    if (cell) {
      element("cell-name").textContent = (data.single ? "Cell " : cell.run.label + ", cell ") + cell.number + kindText(cell);
      makeTable(cell);
      showNumbers();
    }
    player.redraw();
    listeners.forEach((f) => f());
  }
  // `by` cells further in the list; none comes before the first.
  function step(by) {
    const count = choices.length;
    choose(choices[(indexOf(player.state.cell) + by + count) % count]);
  }

  fillList();
  list.addEventListener("change", () => choose(choices[Number(list.value)]));
  player.canvas.addEventListener("click", (event) => choose(player.under(event)));
  clock.onChange(showNumbers);
  return { choose, step, onChange: (f) => listeners.push(f), refresh: () => {
    if (player.state.cell && !player.state.shown.includes(player.state.cell.run)) choose(null);
    fillList();
    list.value = indexOf(player.state.cell);
  } };
})();
