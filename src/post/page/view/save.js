// Saves the picture, the numbers of the current frame, and histories as files.

function save(name, content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  $("saved").textContent = `${name} is in the folder of downloads.`;
}
/// Returns the name of a file about this run: "wall_displacement_t0.3.csv".
const name_of = (ending, ...parts) =>
  [meta.file.split("/").at(-1).replace(/\.[^.]*$/, ""), ...parts].join("_") + ending;
const time_part = () => `t${Number(meta.times[state.frame].toPrecision(4))}`;

const picture_scale = 2;  // pixels of the picture per pixel of the screen
/// Returns the picture of the model with axes, legend, title, time and scale bar.
function picture_canvas() {
  const left = 66, top = 40, key_width = 150, foot = 44, w = model.clientWidth, h = model.clientHeight;
  const sheet = document.createElement("canvas"), p = sheet.getContext("2d"), parts = legend_parts(true);
  const width = left + w + 24 + key_width;
  const height = Math.max(top + h + foot + 34, top + legend_height(p, parts, key_width) + 10);
  const ratio = picture_scale * (window.devicePixelRatio || 1);
  [sheet.width, sheet.height] = [Math.round(width * ratio), Math.round(height * ratio)];
  p.setTransform(ratio, 0, 0, ratio, 0, 0);
  p.fillStyle = style("--sheet"); p.fillRect(0, 0, width, height);
  p.save();
  p.translate(left, top);
  p.beginPath(); p.rect(0, 0, w, h); p.clip();
  put_model(p);
  p.restore();
  put_axes(p, left, top);
  put_legend(p, parts, left + w + 24, top, key_width);
  p.fillStyle = style("--ink"); p.textBaseline = "middle";
  p.textAlign = "left"; p.font = font(14, "600"); p.fillText(document.title, left, 20, w - 150);
  p.textAlign = "right"; p.font = font(13); p.fillText(shown(time_text()), left + w, 20);
  put_scale_bar(p, left, top + h + foot);
  return sheet;
}

function put_model(p) {
  place_corners(state.frame, corners);  // keys may have changed the frame since it was drawn
  const own = pen, halves = both_halves(corners), visible = visible_blocks();
  pen = p;
  draw_fine(state.frame, visible, halves);
  draw_marks(state.frame, visible, halves);
  pen = own;
}

function put_scale_bar(p, x, y) {
  const {width, text} = scale_bar();
  p.strokeStyle = p.fillStyle = style("--ink"); p.lineWidth = 1.5;
  p.beginPath(); p.moveTo(x, y); p.lineTo(x, y + 7); p.lineTo(x + width, y + 7); p.lineTo(x + width, y); p.stroke();
  p.font = font(12); p.textAlign = "left"; p.textBaseline = "middle";
  p.fillText(text, x + width + 8, y + 4);
}

const save_picture = () => picture_canvas().toBlob((blob) => save(name_of(".png", time_part()), blob));

const csv = (lines) => new Blob([lines.map((cells) => cells.join(",") + "\n").join("")], {type: "text/csv"});
/// Returns the blocks of the current frame with the value of the chosen quantity.
function frame_lines() {
  const f = state.frame, {name} = chosen(), columns = ["x", "y", ...(is_place(name) ? [] : [name])];
  const there = [...Array(meta.counts[f]).keys()].filter((b) => exists(b, f));
  return [["block", "material", ...columns],
    ...there.map((b) => [b + 1, meta.material[b], ...columns.map((column) => text_of(column, b, f))])];
}
const save_frame = () => save(name_of(".csv", chosen().name, time_part()), csv(frame_lines()));

/// Returns all quantities of the picked blocks in time, or those of the whole model. The columns
/// have the names of `blocks history`.
function history_lines() {
  const {picked} = state, curves = picked.flatMap((b) => meta.quantities.map(({name}) => ({
    name: `${name}:${b + 1}`, text: (f) => exists(b, f) ? text_of(name, b, f) : "nan"})));
  const all = picked.length ? curves : model_rows().map(({name, all}) => ({name, text: (f) => digits(all[f])}));
  return [["time", "step", ...all.map(({name}) => name)],
    ...meta.times.map((time, f) => [time, meta.steps[f], ...all.map(({text}) => text(f))])];
}
const save_history = () =>
  save(name_of(".csv", "history", ...state.picked.map((b) => `block${b + 1}`)), csv(history_lines()));

$("save_picture").onclick = save_picture;
$("save_frame").onclick = save_frame;
$("save_history").onclick = save_history;
