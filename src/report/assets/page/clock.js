// The one time of the page [s]: it stands, steps from frame to frame, or runs at a told pace.

const clock = (() => {
  const listeners = [];
  let time = 0, timer = 0, before = 0, slower = 1, whenEnded = null;
  // Times of the frames of all runs, each once.
  const times = [...new Set(data.playing.flatMap((run) => run.player.times))].sort((a, b) => a - b);
  const first = times[0] || 0, last = times[times.length - 1] || 0;

  // What lies so near to 10 s for the whole run that it is 1, 2 or 5 times a power of ten.
  function round(ratio) {
    const power = 10 ** Math.floor(Math.log10(ratio) + 1e-9), digit = ratio / power;
    return (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10) * power;
  }
  const usual = last > first ? round(10 / (last - first)) : 1;

  const tell = () => listeners.forEach((f) => f());
  function set(to) {
    time = Math.min(Math.max(to, first), last);
    tell();
  }
  function stop() {
    cancelAnimationFrame(timer);
    timer = 0;
    const ended = whenEnded;
    whenEnded = null;
    tell();
    if (ended) ended();
  }
  function tick(now) {
    const passed = Math.min(Math.max(now - before, 0), 500) * 1e-3;
    before = now;
    if (time >= last) {
      if (whenEnded) return stop();
      time = first;
    } else {
      time = Math.min(time + passed / slower, last);
    }
    tell();
    timer = requestAnimationFrame(tick);
  }
  // Round and round, or, with a function to call then, once to the end.
  function play(ended = null) {
    cancelAnimationFrame(timer);
    whenEnded = ended;
    before = performance.now();
    timer = requestAnimationFrame(tick);
    tell();
  }
  // To the frame `by` frames away.
  function step(by) {
    const k = data.nearest(times, time);
    const at = times[k] > time * (1 + 1e-9) && by > 0 ? k - 1 : times[k] < time * (1 - 1e-9) && by < 0 ? k + 1 : k;
    set(times[Math.min(Math.max(at + by, 0), times.length - 1)]);
  }
  // Digits that tell one frame from the next.
  const spacing = times.length > 1 ? (last - first) / (times.length - 1) * 1e3 : 1;
  const digits = Math.min(Math.max(Math.ceil(-Math.log10(spacing)), 0) + 1, 5);

  return { time: () => time, set, step, play, stop, first, last, usual, round,
    playing: () => timer !== 0, toggle: () => (timer ? stop() : play()),
    slower: () => slower, pace: (ratio) => { slower = ratio; tell(); },
    text: (t = time) => (t * 1e3).toFixed(digits) + " ms", onChange: (f) => listeners.push(f) };
})();

// A pace in words: how much slower than life.
function paceText(slower) {
  const number = (v) => String(+v.toPrecision(3)).replace(/\B(?=(\d{3})+(?!\d))/g, "\u2009");
  if (Math.abs(slower - 1) < 1e-9) return "true pace, 1 : 1";
  return slower > 1 ? "1 : " + number(slower) + ", slower" : number(1 / slower) + " : 1, faster";
}
