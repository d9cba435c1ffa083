// The history of a quantity over time, of one block, of two blocks, or of the whole model.

const chart = $("chart"), chart_pen = chart.getContext("2d");
let chart_time = null;  // maps a pointer position to a frame

/// Draws curves {all, colour, dashes}, where `all` has a number for each frame.
function draw_chart({label, unit}, curves) {
  size_canvas(chart, chart_pen);
  const p = chart_pen, w = chart.clientWidth, h = chart.clientHeight;
  const left = 58, right = w - 10, top = 10, bottom = h - 34;
  let low = Infinity, high = -Infinity;
  for (const {all} of curves) for (const v of all) if (v === v) { low = Math.min(low, v); high = Math.max(high, v); }
  if (!(low <= high)) { low = 0; high = 1; }
  const margin = high > low ? 0.06 * (high - low) : 0.1 * Math.abs(high) || 1;
  low -= margin; high += margin;
  const {ticks, title} = label_ticks(low, high, 4, label, unit);
  $("chart_name").textContent = title;
  const t0 = meta.times[0], t1 = meta.times[frames - 1] > t0 ? meta.times[frames - 1] : t0 + 1;
  const px = (t) => left + (t - t0) / (t1 - t0) * (right - left);
  const py = (v) => bottom - (v - low) / (high - low) * (bottom - top);
  p.font = "11px system-ui, sans-serif";
  p.lineWidth = 1;
  p.fillStyle = style("--muted");
  p.textAlign = "right"; p.textBaseline = "middle";
  for (const [v, text] of ticks) {
    p.strokeStyle = style("--line");
    p.beginPath(); p.moveTo(left, py(v)); p.lineTo(right, py(v)); p.stroke();
    p.fillText(text, left - 6, py(v));
  }
  p.textAlign = "center"; p.textBaseline = "top";
  for (const t of nice_ticks(t0, t1, 4)) {
    const text = tick_text(t);
    p.fillText(text, Math.min(px(t), w - 1 - p.measureText(text).width / 2), bottom + 5);
  }
  p.fillText(with_unit("time", meta.time_unit), (left + right) / 2, bottom + 19);
  const now = px(meta.times[state.frame]);
  p.strokeStyle = style("--muted"); p.lineWidth = 1;
  p.beginPath(); p.moveTo(now, top); p.lineTo(now, bottom); p.stroke();
  for (const {all, colour, dashes} of curves) {
    p.beginPath();
    let drawing = false;
    all.forEach((v, i) => {
      if (v !== v) { drawing = false; return; }
      drawing ? p.lineTo(px(meta.times[i]), py(v)) : p.moveTo(px(meta.times[i]), py(v));
      drawing = true;
    });
    p.strokeStyle = p.fillStyle = colour; p.lineWidth = 1.8; p.lineJoin = "round";
    p.setLineDash(dashes); p.stroke(); p.setLineDash([]);
    const v = all[state.frame];
    if (v !== v) continue;
    p.beginPath(); p.arc(now, py(v), 4, 0, 2 * Math.PI); p.fill();
  }
  chart_time = (x) => nearest(t0 + (x - left) / (right - left) * (t1 - t0));
}

const scrub_chart = (event) => { if (event.buttons) show(chart_time(event.offsetX)); };
chart.addEventListener("pointerdown", scrub_chart);
chart.addEventListener("pointermove", scrub_chart);
