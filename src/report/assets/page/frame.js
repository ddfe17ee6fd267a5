// What stands around a panel: axes, scale bar, flow arrow; and above and below all of them, the time and the colour bars.

const frame = (() => {
  const text = (context, words, x, y, align, size = 12.5, weight = "") => {
    context.font = theme.font(size, weight);
    context.textAlign = align;
    context.textBaseline = "middle";
    context.fillText(words, x, y);
  };
  // A step of 1, 2 or 5 times a power of ten that leaves at least `least` pixels between ticks.
  function tickStep(perMicron, least) {
    const power = 10 ** Math.floor(Math.log10(least / perMicron));
    return [1, 2, 5, 10].map((d) => d * power).find((s) => s * perMicron >= least - 1e-9) || 10 * power;
  }
  const number = (v) => String(+v.toPrecision(6));

  function axes(context, panel) {
    const perMicron = panel.perMetre * 1e-6, { x, y, width, height } = panel, bottom = y + height;
    const [left, low] = panel.run.player.origin.map((metres) => metres * 1e6);
    const across = tickStep(perMicron, 58), up = tickStep(perMicron, Math.min(Math.max(height / 2, 24), 40));
    context.strokeStyle = context.fillStyle = theme.now().ink;
    context.lineWidth = 1;
    context.strokeRect(x, y, width, height);
    context.beginPath();
    for (let v = Math.ceil(left / across) * across; (v - left) * perMicron <= width + 0.5; v += across) {
      const at = x + (v - left) * perMicron;
      context.moveTo(at, bottom);
      context.lineTo(at, bottom + 5);
      text(context, number(v), at, bottom + 13, "center");
    }
    for (let v = Math.ceil(low / up) * up; (v - low) * perMicron <= height + 0.5; v += up) {
      const at = bottom - (v - low) * perMicron;
      context.moveTo(x, at);
      context.lineTo(x - 5, at);
      text(context, number(v), x - 8, at, "right");
    }
    context.stroke();
    text(context, "x [µm]", x + width / 2, bottom + 29, "center");
    context.save();
    context.translate(x - 38, y + height / 2);
    context.rotate(-Math.PI / 2);
    text(context, "y [µm]", 0, 0, "center");
    context.restore();
    if (!panel.run.player.walled) return;
    context.fillStyle = theme.now().wall;
    context.fillRect(x, y - 4, width, 4);
    context.fillRect(x, bottom, width, 4);
  }

  function arrow(context, x, y, length) {
    const tip = x + length, back = Math.sign(length) * 7;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(tip, y);
    context.moveTo(tip - back, y - 4);
    context.lineTo(tip, y);
    context.lineTo(tip - back, y + 4);
    context.lineWidth = 2;
    context.stroke();
  }

  // Right of the line above a panel: which way the flow goes, in shear which way the walls move.
  function direction(context, panel, right, y) {
    const { drive, sign } = panel.run.player.flow, from = sign > 0 ? right - 34 : right;
    context.strokeStyle = context.fillStyle = theme.now().ink;
    if (drive === "none") return right;
    if (drive === "channel") arrow(context, from, y, 34 * sign);
    else {
      arrow(context, from, y - 5, 34 * sign);
      arrow(context, sign > 0 ? right : right - 34, y + 6, -34 * sign);
    }
    const words = drive === "channel" ? "flow" : "walls";
    text(context, words, right - 40, y, "right");
    return right - 56 - context.measureText(words).width;
  }

  function scaleBar(context, panel, right, y) {
    const step = tickStep(panel.perMetre * 1e-6, 44), long = step * panel.perMetre * 1e-6, words = number(step) + " µm";
    context.fillStyle = theme.now().ink;
    text(context, words, right, y, "right");
    context.fillRect(right - context.measureText(words).width - 6 - long, y - 2, long, 4);
    return right - context.measureText(words).width - 12 - long;
  }

  // A lone panel has its line in the head, beside the time.
  function above(context, panel, single, time) {
    const free = scaleBar(context, panel, direction(context, panel, panel.right, single ? 13 : panel.y - 14), single ? 13 : panel.y - 14);
    if (single) return;
    const over = time > panel.run.player.last * (1 + 1e-9) ? ", ended at " + clock.text(panel.run.player.last) : "";
    const oneLine = panel.y - panel.top < 40;
    context.fillStyle = theme.now().ink;
    context.save();
    context.beginPath();
    context.rect(panel.left, panel.top, (oneLine ? free : panel.right) - panel.left, 28);
    context.clip();
    text(context, panel.run.label + over, panel.left, panel.top + (oneLine ? 16 : 14), "left", 13, "600");
    context.restore();
  }

  // Numbers that tell the ends of a range apart.
  function inRange(value, low, high) {
    if (Math.max(Math.abs(low), Math.abs(high)) >= 1e5) return value.toExponential(2);
    return String(+value.toFixed(Math.min(Math.max(Math.ceil(-Math.log10(high - low)) + 2, 0), 12))).replace("-", "−");
  }

  function bar(context, name, map, [low, high], unit, x, y, width) {
    const [factor, shown] = data.convert(unit);
    context.fillStyle = theme.now().ink;
    context.font = theme.font(12.5);
    context.textAlign = "left";
    context.fillText(name + (shown ? " [" + shown + "]" : ""), x, y + 6, width + 12);
    for (let k = 0; k < width; ++k) {
      context.fillStyle = "rgb(" + map[Math.round(255 * k / Math.max(width - 1, 1))] + ")";
      context.fillRect(x + k, y + 16, 1.5, 11);
    }
    context.strokeStyle = context.fillStyle = theme.now().ink;
    context.lineWidth = 1;
    context.strokeRect(x, y + 16, width, 11);
    for (const [share, align] of [[0, "left"], [0.5, "center"], [1, "right"]])
      text(context, inRange((low + share * (high - low)) * factor, low * factor, high * factor), x + share * width, y + 36, align);
  }

  // Colours that stand for names, in the place of a bar.
  function swatches(context, name, entries, x, y, width) {
    context.fillStyle = theme.now().ink;
    context.font = theme.font(12.5);
    context.textAlign = "left";
    context.fillText(name, x, y + 6, width);
    const slot = width / entries.length;
    entries.forEach(([entry, colour], k) => {
      context.fillStyle = colour;
      context.fillRect(x + k * slot, y + 16, 11, 11);
      context.fillStyle = theme.now().ink;
      context.fillText(entry, x + k * slot + 16, y + 22, slot - 20);
    });
  }

  return { axes, above, bar, swatches, text };
})();
