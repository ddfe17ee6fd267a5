// Where things stand on the canvas: a head with the time, a panel a run in rows, a foot with the colour bars.

const layout = (() => {
  const margin = { left: 48, right: 14, bottom: 40 };
  const head = 26, foot = 54;
  // Above a panel: its name, scale bar and arrow, in one line or, where it is narrow, in two. A lone panel has them in the head.
  const top = (runs, slot) => (runs.length === 1 ? 8 : slot >= 520 ? 30 : 46);

  // Panels of that many columns in a canvas that wide; `room` is the height they may take.
  function arranged(runs, columns, width, room) {
    const rows = Math.ceil(runs.length / columns), above = top(runs, width / columns);
    const wide = width / columns - margin.left - margin.right, high = room / rows - above - margin.bottom;
    const perMetre = runs.map(({ player: p }) => Math.max(Math.min(wide / p.length, high / p.width), 40 / Math.max(p.length, p.width)));
    const size = Math.min(...runs.map(({ player: p }, r) => perMetre[r] * p.length * perMetre[r] * p.width));
    return { columns, rows, perMetre, size };
  }

  function place(runs, found, width) {
    const panels = [], slot = width / found.columns, above = top(runs, slot);
    let y = head;
    for (let row = 0; row < found.rows; ++row) {
      const inRow = runs.slice(row * found.columns, (row + 1) * found.columns);
      let high = 0;
      inRow.forEach((run, k) => {
        const perMetre = found.perMetre[row * found.columns + k];
        const wide = perMetre * run.player.length, tall = perMetre * run.player.width;
        const x = k * slot + margin.left + (slot - margin.left - margin.right - wide) / 2;
        const line = Math.max(wide, Math.min(slot - 28, 420)), left = Math.max(x + wide / 2 - line / 2, k * slot + 14);
        panels.push({ run, x, y: y + above, width: wide, height: tall, perMetre, left, right: Math.min(left + line, (k + 1) * slot - 14), top: y });
        high = Math.max(high, tall);
      });
      y += above + high + margin.bottom;
    }
    return { panels, width, height: Math.ceil(y + foot), foot: y };
  }

  // The arrangement that shows the smallest run largest.
  function of(runs, width, height) {
    const room = Math.max(height - head - foot, 120);
    let best = null;
    for (let columns = 1; columns <= runs.length; ++columns) {
      const found = arranged(runs, columns, width, room);
      if (!best || found.size > best.size * 1.02) best = found;
    }
    return place(runs, best, width);
  }
  return { of };
})();
