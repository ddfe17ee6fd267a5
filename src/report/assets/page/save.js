// The picture as a file: PNG of what is shown, WebM of one pass. Made in the page, nothing is sent.

if (player) (() => {
  const png = element("save-png"), webm = element("save-webm"), note = element("save-note");
  const kinds = ["video/webm;codecs=vp8", "video/webm;codecs=vp9", "video/webm"];
  const records = typeof MediaRecorder === "function" && typeof player.canvas.captureStream === "function";
  const kind = records ? kinds.find((k) => MediaRecorder.isTypeSupported(k)) : null;

  function name(ending) {
    const runs = player.state.shown.map((run) => run.label).join("+").replace(/[^A-Za-z0-9._+-]+/g, "-").slice(0, 80);
    return runs + (ending === "png" ? "-" + clock.text().replace(" ", "-") : "") + "." + ending;
  }
  function save(blob, as) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = as;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    note.textContent = as + ", " + Math.ceil(blob.size / 1024) + " kB";
  }

  png.addEventListener("click", () => {
    // Two points of the picture for one of the page, as a paper wants it.
    player.state.sharpness = Math.max(2, window.devicePixelRatio || 1);
    player.draw();
    player.canvas.toBlob((blob) => save(blob, name("png")), "image/png");
    player.state.sharpness = 0;
    player.redraw();
  });

  let recording = false;
  const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
  const bytes = (parts) => parts.reduce((sum, part) => sum + part.size, 0);
  // Until there are more bytes than `from`: an encoder may start late and lag behind. It is fed meanwhile.
  async function encoded(parts, from, limit) {
    for (const start = performance.now(); bytes(parts) <= from && performance.now() - start < limit;) {
      player.draw();
      await pause(40);
    }
  }

  // The longest header alone is shorter than `header`.
  const header = 500;
  async function record() {
    const parts = [], stream = player.canvas.captureStream(30);
    const recorder = new MediaRecorder(stream, { mimeType: kind, videoBitsPerSecond: 6e6 });
    const ended = new Promise((done) => recorder.addEventListener("stop", done));
    recorder.addEventListener("dataavailable", (event) => parts.push(event.data));
    recording = true;
    webm.textContent = "Stop recording";
    note.textContent = "records one pass, " + ((clock.last - clock.first) * clock.slower()).toPrecision(2) + " s";
    player.hold(true);
    clock.stop();
    clock.set(clock.first);
    recorder.start(100);
    await encoded(parts, header, 5000);
    if (recording) await new Promise((done) => clock.play(done));
    await encoded(parts, bytes(parts), 2000);
    recorder.stop();
    await ended;
    stream.getTracks().forEach((track) => track.stop());
    recording = false;
    player.hold(false);
    player.redraw();
    webm.textContent = "Record WebM";
    save(new Blob(parts, { type: "video/webm" }), name("webm"));
  }
  webm.addEventListener("click", () => {
    if (!recording && webm.textContent === "Record WebM") return record();
    recording = false;
    clock.stop();
  });
  if (!kind) {
    webm.disabled = true;
    note.textContent = "This browser cannot record a canvas.";
  }
})();
