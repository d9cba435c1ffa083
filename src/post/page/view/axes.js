// The axes to the left of and below the model, and the scale bar.

const axes = $("axes"), axes_pen = axes.getContext("2d");
/// Draws the axes on the page, whose canvas lies behind that of the model.
function draw_axes() {
  size_canvas(axes, axes_pen);
  put_axes(axes_pen, model.offsetLeft, model.offsetTop);
  const {width, text} = scale_bar();
  $("bar").style.width = `${width}px`;
  $("bar_length").textContent = text;
}

/// Draws the axes of a model whose upper left corner is at (left, top).
function put_axes(p, left, top) {
  const w = model.clientWidth, h = model.clientHeight, bottom = top + h;
  const [x0, y1] = to_model(0, 0), [x1, y0] = to_model(w, h);
  const across = label_ticks(x0, x1, Math.max(2, w / 110), "x", meta.length_unit);
  const up = label_ticks(y0, y1, Math.max(2, h / 80), "y", meta.length_unit);
  p.strokeStyle = style("--axis"); p.fillStyle = style("--muted"); p.lineWidth = 1;
  p.font = font(11);
  p.beginPath();
  p.rect(left - 0.5, top - 0.5, w + 1, h + 1);
  p.textAlign = "center"; p.textBaseline = "top";
  for (const [x, text] of across.ticks) {
    const at = left + to_screen(x, 0)[0];
    p.moveTo(at, bottom); p.lineTo(at, bottom + 5);
    const half = p.measureText(text).width / 2;
    p.fillText(text, Math.max(half, Math.min(at, left + w - half + 6)), bottom + 7);
  }
  p.textAlign = "right"; p.textBaseline = "middle";
  for (const [y, text] of up.ticks) {
    const at = top + to_screen(0, y)[1];
    p.moveTo(left, at); p.lineTo(left - 5, at);
    p.fillText(text, left - 8, Math.max(top + 6, Math.min(at, bottom - 4)));
  }
  p.stroke();
  p.textAlign = "center"; p.textBaseline = "top";
  p.fillText(across.title, left + w / 2, bottom + 21);
  p.save();
  p.translate(left - 54, top + h / 2); p.rotate(-Math.PI / 2);
  p.fillText(up.title, 0, 0);
  p.restore();
}

/// Returns a round length that is at most 140 pixels long, its width on the page, and its text.
function scale_bar() {
  const most = 140 / state.view.scale, power = 10 ** Math.floor(Math.log10(most)), digit = most / power;
  const length = power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
  return {length, width: length * state.view.scale, text: measured(tick_text(length), meta.length_unit)};
}
