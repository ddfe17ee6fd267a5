// Light or dark, as the reader's system has it: colours of the style sheet for what is drawn.

const theme = (() => {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const listeners = [];
  let colours;
  function read() {
    const style = getComputedStyle(document.documentElement);
    colours = {};
    for (const name of ["ink", "soft", "faint", "line", "back", "wall", "edge", "body"]) colours[name] = style.getPropertyValue("--" + name).trim();
    colours.dark = dark.matches;
  }
  read();
  dark.addEventListener("change", () => { read(); listeners.forEach((f) => f()); });
  const font = (size, weight = "") => `${weight} ${size}px system-ui, "DejaVu Sans", sans-serif`;
  return { now: () => colours, onChange: (f) => listeners.push(f), font };
})();
