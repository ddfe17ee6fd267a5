// Outlines of the cells of a frame: drawn with their images across the ends of the box, and found under a point.

const cells = (() => {
  // The outline of a cell on the canvas, as x, y, x, y, …
  function outline(panel, frame, cell) {
    const p = panel.run.player, points = [];
    for (let k = p.first[cell]; k < p.first[cell + 1]; ++k) {
      const at = 2 * (frame * p.nodeCount + k);
      points.push(panel.x + p.position[at] * p.quantum * panel.perMetre, panel.y + panel.height - p.position[at + 1] * p.quantum * panel.perMetre);
    }
    return points;
  }

  // The cell itself and its images that reach into the box.
  function images(panel, points) {
    let left = Infinity, right = -Infinity, low = Infinity, high = -Infinity;
    for (let k = 0; k < points.length; k += 2) {
      left = Math.min(left, points[k]);
      right = Math.max(right, points[k]);
      low = Math.min(low, points[k + 1]);
      high = Math.max(high, points[k + 1]);
    }
    const list = [];
    for (const x of [0, -panel.width, panel.width])
      for (const y of [0, -panel.height, panel.height])
        if (right + x > panel.x && left + x < panel.x + panel.width && high + y > panel.y && low + y < panel.y + panel.height) list.push([x, y]);
    return list;
  }

  function trace(context, points, x, y) {
    context.moveTo(points[0] + x, points[1] + y);
    for (let k = 2; k < points.length; k += 2) context.lineTo(points[k] + x, points[k + 1] + y);
    context.closePath();
  }

  function fillOf(run, q, cell, row) {
    if (q.where === "none") return colours.plain;
    if (q.where === "kind") return colours.ofKind(run.player.kind[cell]);
    if (q.where === "number") return colours.several[cell % colours.several.length];
    if (q.where === "piece" || !colours.known(run, q)) return theme.now().body;
    const value = run.cells.value(q.key, cell, row);
    return Number.isNaN(value) ? theme.now().body : "rgb(" + colours.map("cell")[colours.level(q, value)] + ")";
  }

  // Pieces of membrane, those of one colour in one stroke.
  function strokePieces(context, panel, frame, q, drawn) {
    const p = panel.run.player, map = colours.map("cell"), { low, high, level, tension } = p.stretch, paths = new Map();
    const steps = p.kinds.map((_, kind) => Uint8Array.from({ length: 256 }, (_, b) =>
      colours.level(q, q.key === "tension" ? tension[kind][b] : low + (high - low) * b / 255) & 0xf8));
    for (const { cell, points, shifts } of drawn)
      for (const [x, y] of shifts)
        for (let k = 0; k < points.length; k += 2) {
          const next = (k + 2) % points.length, colour = steps[p.kind[cell] || 0][level[frame * p.nodeCount + p.first[cell] + k / 2]];
          if (!paths.has(colour)) paths.set(colour, new Path2D());
          paths.get(colour).moveTo(points[k] + x, points[k + 1] + y);
          paths.get(colour).lineTo(points[next] + x, points[next + 1] + y);
        }
    context.lineCap = "round";
    context.lineWidth = Math.min(Math.max(0.35e-6 * panel.perMetre, 2), 5);
    for (const [colour, path] of paths) {
      context.strokeStyle = "rgb(" + map[colour] + ")";
      context.stroke(path);
    }
  }

  function writeNumber(context, panel, { cell, points, shifts }) {
    let x = 0, y = 0;
    for (let k = 0; k < points.length; k += 2) {
      x += 2 * points[k] / points.length;
      y += 2 * points[k + 1] / points.length;
    }
    context.font = theme.font(12, "600");
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (const [dx, dy] of shifts) {
      context.lineWidth = 3;
      context.strokeStyle = "#fff";
      context.strokeText(cell, x + dx, y + dy);
      context.fillStyle = "#111";
      context.fillText(cell, x + dx, y + dy);
    }
  }

  // `chosen`: the cell to mark, or -1.
  function draw(context, panel, frame, time, q, chosen) {
    const { run } = panel, row = run.cells ? run.cells.row(time) : 0, drawn = [];
    context.lineJoin = "round";
    for (let cell = 0; cell < run.player.cellCount; ++cell) {
      const points = outline(panel, frame, cell), shifts = images(panel, points);
      drawn.push({ cell, points, shifts });
      context.beginPath();
      for (const [x, y] of shifts) trace(context, points, x, y);
      context.fillStyle = fillOf(run, q, cell, row);
      context.fill();
    }
    // All outlines over all insides: where cells overlap, it is seen.
    context.beginPath();
    for (const { points, shifts } of drawn) for (const [x, y] of shifts) trace(context, points, x, y);
    context.strokeStyle = theme.now().edge;
    context.lineWidth = 1;
    context.stroke();
    if (q.where === "piece" && colours.known(run, q)) strokePieces(context, panel, frame, q, drawn);
    if (q.where === "number" && 8e-6 * panel.perMetre > 16) drawn.forEach((d) => writeNumber(context, panel, d));
    if (chosen < 0 || !drawn[chosen]) return;
    context.beginPath();
    for (const [x, y] of drawn[chosen].shifts) trace(context, drawn[chosen].points, x, y);
    for (const [colour, width] of [[theme.now().back, 6], [theme.now().ink, 3]]) {
      context.strokeStyle = colour;
      context.lineWidth = width;
      context.stroke();
    }
    writeNumber(context, panel, drawn[chosen]);
  }

  // The cell under a point of the canvas, or -1.
  function at(context, panel, frame, x, y) {
    for (let cell = panel.run.player.cellCount - 1; cell >= 0; --cell) {
      const points = outline(panel, frame, cell), path = new Path2D();
      for (const [dx, dy] of images(panel, points)) trace(path, points, dx, dy);
      context.save();
      context.setTransform(1, 0, 0, 1, 0, 0);
      const inside = context.isPointInPath(path, x, y);
      context.restore();
      if (inside) return cell;
    }
    return -1;
  }
  return { draw, at, outline };
})();
