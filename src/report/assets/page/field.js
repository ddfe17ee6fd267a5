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
  return { speed, walls, latest };
})();
