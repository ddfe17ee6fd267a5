"use strict";
// Numbers as people read them, and elements of the page.
const minus = (text) => text.replace(/-/g, "−");
const raised = (power) => [...String(power)].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])).join("");

function plain(value, digits = 4) {
  if (value === null || !isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) return minus(String(+value.toPrecision(digits)));
  const [mantissa, power] = value.toExponential(digits - 1).split("e");
  return minus(+mantissa + "·10") + raised(+power);
}

// Both to the second digit of the error.
function withError(mean, error) {
  if (mean === null) return "–";
  if (error === null || !(error > 0)) return plain(mean);
  const power = Math.floor(Math.log10(Math.max(Math.abs(mean), error)));
  const unit = power >= -3 && power < 5 ? 1 : 10 ** power;
  const decimals = Math.max(1 - Math.floor(Math.log10(error / unit)), 0);
  if (decimals > 8) return plain(mean);
  const text = minus((mean / unit).toFixed(decimals)) + " ± " + (error / unit).toFixed(decimals);
  return unit === 1 ? text : "(" + text + ")·10" + raised(power);
}

const withUnit = (text, unit) => (unit ? text + " [" + unit + "]" : text);
const element = (id) => document.getElementById(id);

function filled(node, attributes, text) {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  if (text !== undefined) node.textContent = text;
  return node;
}
const make = (tag, attributes = {}, text) => filled(document.createElement(tag), attributes, text);
const svg = (tag, attributes = {}, text) =>
  filled(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, text);

function select(id, title, options, chosen, act) {
  const box = make("label", {}, title + " "), list = make("select", { id });
  for (const [value, name] of options) list.add(new Option(name, value, false, value === chosen));
  list.addEventListener("change", () => act(Number(list.value)));
  box.append(list);
  return box;
}
