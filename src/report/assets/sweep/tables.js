// Differences between two points, and all runs.
function differenceTable(one, two) {
  const table = make("table"), head = make("tr"), body = make("tbody"), top = make("thead");
  const titles = ["A", "B", "B − A", "over its error"];
  for (const title of ["quantity", "unit", ...titles])
    head.append(make("th", { scope: "col", class: titles.includes(title) ? "number" : "" }, title));
  for (const q of lively) {
    const a = over(one.runs, q), b = over(two.runs, q);
    if (!a || !b) continue;
    const error = a.error === null || b.error === null ? null : Math.hypot(a.error, b.error), change = b.mean - a.mean;
    const cells = [withError(a.mean, a.error), withError(b.mean, b.error), withError(change, error), error > 0 ? plain(change / error, 2) : "–"];
    const row = make("tr");
    row.append(make("th", { scope: "row" }, quantities[q].name), make("td", { "data-label": "unit" }, quantities[q].unit));
    titles.forEach((title, k) => row.append(make("td", { class: "number", "data-label": title }, cells[k])));
    body.append(row);
  }
  top.append(head);
  table.append(top, body);
  return table;
}

function showDifferences() {
  const key = keys[choice.key];
  const measured = (point) => lively.some((q) => over(point.runs, q));
  const points = curvesNow().flatMap((curve) => curve.points.filter(measured).map((point) => ({ ...point, curve: curve.label })));
  const names = points.map((p, k) => [k, [p.curve, key.short + " = " + p.label].filter(Boolean).join(", ")]);
  const pair = { a: 0, b: points.length - 1 };
  const show = () => element("differences").replaceChildren(differenceTable(points[pair.a], points[pair.b]));
  if (points.length < 2) {
    element("pair").replaceChildren();
    return element("differences").replaceChildren(make("p", {}, "There are no two points to compare."));
  }
  const choose = (end) => (k) => { pair[end] = k; show(); };
  element("pair").replaceChildren(select("first", "A:", names, pair.a, choose("a")), select("second", "B:", names, pair.b, choose("b")));
  show();
}

// {title, kind, value: to sort by, cell: to show}
function columnsOfRuns() {
  const ofKey = (key) => {
    const value = (run) => (key.numbers || key.values)[run.places[key.axis]];
    const cell = (run) => (key.numbers ? plain(value(run), 6) : value(run));
    return { title: withUnit(key.short, key.unit), kind: key.numbers ? "number" : "", value, cell };
  };
  const ofQuantity = (q) => ({
    title: withUnit(quantities[q].name, quantities[q].unit), kind: "number",
    value: (run) => (run.means[q] ? run.means[q][0] : null), cell: (run) => (run.means[q] ? withError(...run.means[q]) : "–"),
  });
  return [
    { title: "#", kind: "number", value: (run) => run.number, cell: (run) => make("a", { href: run.link, title: run.name }, String(run.number)) },
    ...keys.map(ofKey),
    { title: "ending", kind: "", value: (run) => run.ending, cell: (run) => make("span", { class: run.ending }, run.ending) },
    { title: "checks", kind: "", value: (run) => run.checks, cell: (run) => run.checks || (run.ending === "done" ? "ok" : "–") },
    ...indices.filter((q) => known[q].length > 0).map(ofQuantity),
  ];
}

// Empty ones last.
function compare(a, b, sign) {
  if (a === null || b === null) return (a === null) - (b === null);
  return sign * (typeof a === "number" ? a - b : String(a).localeCompare(String(b)));
}

function showRuns() {
  const columns = columnsOfRuns(), table = make("table"), top = make("thead"), head = make("tr"), body = make("tbody");
  const rows = runs.map((run) => {
    const row = make("tr");
    columns.forEach((column, c) => {
      const cell = make(c === 0 ? "th" : "td", { class: column.kind });
      cell.append(column.cell(run));
      row.append(cell);
    });
    return { run, row };
  });
  for (const column of columns) {
    const title = make("th", { scope: "col", class: column.kind }), button = make("button", { type: "button" }, column.title);
    button.addEventListener("click", () => {
      const order = title.getAttribute("aria-sort") === "ascending" ? "descending" : "ascending";
      for (const other of head.children) other.removeAttribute("aria-sort");
      title.setAttribute("aria-sort", order);
      rows.sort((a, b) => compare(column.value(a.run), column.value(b.run), order === "ascending" ? 1 : -1));
      body.append(...rows.map(({ row }) => row));
    });
    title.append(button);
    head.append(title);
  }
  top.append(head);
  body.append(...rows.map(({ row }) => row));
  table.append(top, body);
  element("runs").replaceChildren(table);
}
