// The picture as a file: PNG of what is shown, WebM of one pass. Made in the page, nothing is sent.

if (player) (() => {
  const png = element("save-png"), webm = element("save-webm"), note = element("save-note");
  const kinds = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];
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
    player.draw();
    player.canvas.toBlob((blob) => save(blob, name("png")), "image/png");
  });

  function record() {
    const parts = [], stream = player.canvas.captureStream(30);
    const recorder = new MediaRecorder(stream, { mimeType: kind, videoBitsPerSecond: 6e6 });
    recorder.addEventListener("dataavailable", (event) => parts.push(event.data));
    recorder.addEventListener("stop", () => {
      stream.getTracks().forEach((track) => track.stop());
      player.hold(false);
      player.redraw();
      webm.textContent = "Record WebM";
      save(new Blob(parts, { type: "video/webm" }), name("webm"));
    });
    player.hold(true);
    clock.stop();
    clock.set(clock.first);
    recorder.start();
    webm.textContent = "Stop recording";
    note.textContent = "records one pass, " + ((clock.last - clock.first) * clock.slower()).toPrecision(2) + " s";
    // The last picture stays for a moment.
    clock.play(() => setTimeout(() => recorder.stop(), 250));
  }
  webm.addEventListener("click", () => (webm.textContent === "Record WebM" ? record() : clock.stop()));
  if (!kind) {
    webm.disabled = true;
    note.textContent = "This browser cannot record a canvas.";
  }
})();
