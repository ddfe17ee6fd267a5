// What lies behind the cells in a panel: speed of the flow, and walls.

const field = (() => {
  const buffer = document.createElement("canvas");

  // Of the frames that hold speeds, the latest not after this one; null before the first.
  function latest(player, frame) {
    for (let k = frame; k >= 0; --k) if (player.fields[k] !== null) return k;
    return null;
  }

  function speed(context, panel, frame) {
    const player = panel.run.player, held = latest(player, frame);
    if (held === null || colours.fastest === 0) return;
    const { columns, rows, speedBytes } = player, map = colours.map("flow"), scale = player.fastest / colours.fastest;
    const pixels = new ImageData(columns, rows), start = player.fields[held] * columns * rows;
    for (let j = 0; j < rows; ++j)
      for (let i = 0; i < columns; ++i) {
        const colour = map[Math.round(scale * speedBytes[start + (rows - 1 - j) * columns + i])], at = 4 * (j * columns + i);
        pixels.data[at] = colour[0];
        pixels.data[at + 1] = colour[1];
        pixels.data[at + 2] = colour[2];
        pixels.data[at + 3] = 255;
      }
    buffer.width = columns;
    buffer.height = rows;
    buffer.getContext("2d").putImageData(pixels, 0, 0);
    context.drawImage(buffer, panel.x, panel.y, panel.width, panel.height);
  }

  // Solid is what an odd number of loops goes around.
  function walls(context, panel) {
    const player = panel.run.player;
    context.beginPath();
    for (let w = 0; w + 1 < player.wall_first.length; ++w) {
      for (let k = player.wall_first[w]; k < player.wall_first[w + 1]; ++k) {
        const x = panel.x + player.walls[2 * k] * panel.perMetre, y = panel.y + panel.height - player.walls[2 * k + 1] * panel.perMetre;
        if (k === player.wall_first[w]) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
      context.closePath();
    }
    context.fillStyle = theme.now().wall;
    context.strokeStyle = theme.now().ink;
    context.lineWidth = 1;
    context.fill("evenodd");
    context.stroke();
  }
  // Ports and sections, each with its name.
  function places(context, panel) {
    const at = ([x, y]) => [panel.x + x * panel.perMetre, panel.y + panel.height - y * panel.perMetre];
    context.font = "11px sans-serif";
    for (const { name, port, from, to } of panel.run.player.places) {
      const [x0, y0] = at(from), [x1, y1] = at(to), upright = Math.abs(x1 - x0) < Math.abs(y1 - y0);
      context.strokeStyle = context.fillStyle = theme.now().ink;
      context.lineWidth = port ? 3 : 1;
      context.setLineDash(port ? [] : [4, 3]);
      context.beginPath();
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
      context.stroke();
      const half = context.measureText(name).width / 2, inside = (x) => Math.min(Math.max(x, panel.x + half + 3), panel.x + panel.width - half - 3);
      context.textAlign = "center";
      context.fillText(name, inside(upright ? x0 : (x0 + x1) / 2), Math.max(Math.min(y0, y1) - 4, panel.y + 11));
    }
    context.setLineDash([]);
  }
  return { speed, walls, places, latest };
})();
