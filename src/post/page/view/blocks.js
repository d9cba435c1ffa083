// Draws the blocks of the current frame: fills, outlines, hatching of fixed blocks, the first state,
// numbers and picked blocks.

let pen = model.getContext("2d");  // a picture to save has another pen for a moment (save.js)

function trace(b, from, f = state.frame) {
  const shape = shape_of(b, f), first = 2 * data.first_corner[shape], end = 2 * data.first_corner[shape + 1];
  const {x, y, scale} = state.view;
  const u = model.clientWidth / 2 - x * scale, v = model.clientHeight / 2 + y * scale;
  pen.moveTo(u + from[first] * scale, v - from[first + 1] * scale);
  for (let i = first + 2; i < end; i += 2)
    pen.lineTo(u + from[i] * scale, v - from[i + 1] * scale);
  pen.closePath();
}

/// Paints blocks in groups, because one path of many blocks is much slower than many short paths.
function in_parts(blocks, from, paint, f = state.frame, most = 32) {
  for (let i = 0; i < blocks.length; i += most) {
    pen.beginPath();
    for (const b of blocks.slice(i, i + most)) trace(b, from, f);
    paint();
  }
}

function draw_model() {
  size_canvas(model, pen);
  place_corners(state.frame, corners);
  const visible = visible_blocks(), halves = both_halves(corners);
  if (visible.length > draft_above && hurried()) draw_draft(state.frame, visible, halves);
  else draw_fine(state.frame, visible, halves);
  draw_marks(state.frame, visible, halves);
}

function visible_blocks() {
  const f = state.frame, {x, y, scale} = state.view, visible = [];
  const half_w = model.clientWidth / 2 / scale, half_h = model.clientHeight / 2 / scale;
  for (let b = 0; b < meta.counts[f]; ++b) {
    if (removed(b, f)) continue;
    const [cx, cy] = centre(b, f), r = 1.3 * data.size[shape_of(b, f)];
    const near = Math.abs(cx - x) < half_w + r || (state.mirror && Math.abs(2 * meta.mirror - cx - x) < half_w + r);
    if (near && Math.abs(cy - y) < half_h + r) visible.push(b);
  }
  return visible;
}

/// Returns the width of outlines on the page; they are thin on small blocks.
const edge_width = () => Math.min(1, typical_size() * state.view.scale / 24);

/// Draws the blocks with hatching and outlines, contact forces and arrows.
function draw_fine(f, visible, halves) {
  const groups = halves.flatMap((half) =>
    [...shades(f, visible, half)].map(([shade, group]) => ({shade, group, half})));
  for (const {shade, group, half} of groups) {
    pen.fillStyle = shade;
    in_parts(group, half, () => pen.fill());
  }
  for (const half of halves) hatch_fixed(f, visible, half);
  pen.lineWidth = edge_width();
  pen.lineJoin = "round";
  for (const {shade, group, half} of edge_width() > 0.2 ? groups : []) {
    pen.strokeStyle = outline_on(shade);
    in_parts(group, half, () => pen.stroke());
  }
  if (state.colour === "bond") draw_bonds(halves);
  if (shows_faces()) draw_faces(f, visible, halves);
  if (state.cracks) draw_cracks(f, visible, halves);
  if (state.forces) draw_forces(f, halves);
  if (state.arrows) draw_arrows(f, visible, halves);
}

/// Draws what is on top of blocks and forces.
function draw_marks(f, visible, halves) {
  if (state.original) draw_original();
  if (state.mirror) draw_mirror();
  else (meta.planes ?? []).forEach(draw_plane);
  for (const half of halves) draw_water_table(f, half);
  if (state.labels) draw_labels(f, visible);
  state.picked.forEach((block, i) => exists(block, f) && draw_outline(pen, block, halves, mark_colour(i), 3));
  draw_picked_side(f, halves);
}

/// Returns the colour of the first or second picked block.
const mark_colour = (i) => style(i ? "--second" : "--mark");

/// Draws the outline of a block with a rim, so that it is visible on every colour.
function draw_outline(its_pen, block, halves, colour, width) {
  const own = pen;
  pen = its_pen;
  pen.beginPath();
  for (const half of halves) trace(block, half);
  pen.lineJoin = "round";
  pen.strokeStyle = style("--sheet"); pen.lineWidth = width + 2.5; pen.stroke();
  pen.strokeStyle = colour; pen.lineWidth = width; pen.stroke();
  pen = own;
}

/// Draws a symmetry plane, with short strokes on the right: the blocks are on the left.
function draw_plane([ax, ay, bx, by]) {
  const [px, py] = to_screen(ax, ay), [qx, qy] = to_screen(bx, by), length = Math.hypot(qx - px, qy - py);
  const [tx, ty] = [(qx - px) / length, (qy - py) / length];
  const half = model.clientWidth + model.clientHeight;
  const middle = tx * (model.clientWidth / 2 - px) + ty * (model.clientHeight / 2 - py);
  const at = (s) => [px + tx * (middle + s), py + ty * (middle + s)];
  pen.save();
  pen.strokeStyle = style("--ink"); pen.lineWidth = 1.4;
  pen.beginPath(); pen.moveTo(...at(-half)); pen.lineTo(...at(half)); pen.stroke();
  pen.lineWidth = 0.8;
  pen.beginPath();
  for (let s = -half; s < half; s += 9) {
    const [x, y] = at(s);
    pen.moveTo(x, y); pen.lineTo(x - 6 * (tx + ty), y + 6 * (tx - ty));
  }
  pen.stroke();
  pen.restore();
}

/// Draws the water table, with its sign at a twentieth of the width.
function draw_water_table(f, half) {
  const flat = meta.water_lines?.[f] ?? [], places = [];
  let line = flat.flatMap((x, i) => i % 2 ? [] : [[x, flat[i + 1]]]);
  if (state.mirror) {  // what is on the side of the model
    let sum = 0;  // tells on which side that is, as in scene_drawing.cpp
    for (let i = 0; i < corners.length; i += 2) sum += corners[i] - meta.mirror;
    const here = ([x]) => (x - meta.mirror) * sum >= 0;
    line = line.flatMap((p, k) => {
      const q = line[k - 1], cut = q && here(p) !== here(q)
        ? [[meta.mirror, q[1] + (meta.mirror - q[0]) / (p[0] - q[0]) * (p[1] - q[1])]] : [];
      return here(p) ? [...cut, p] : cut;
    });
  }
  for (const [x, y] of line) places.push(to_screen(half === corners ? x : 2 * meta.mirror - x, y));
  if (places.length < 2) return;
  const stroke = (colour, width) => {
    pen.strokeStyle = colour; pen.lineWidth = width;
    pen.beginPath();
    places.forEach((at, i) => i ? pen.lineTo(...at) : pen.moveTo(...at));
    pen.stroke();
  };
  pen.save();
  stroke("rgba(255, 255, 255, .8)", 4);
  stroke(meta.water_colour, 2);
  const x = 0.05 * model.clientWidth;
  for (let i = 0; i + 1 < places.length; ++i) {
    const [[x0, y0], [x1, y1]] = [places[i], places[i + 1]];
    if (Math.min(x0, x1) > x || Math.max(x0, x1) <= x) continue;
    const y = y0 + (x - x0) / (x1 - x0) * (y1 - y0);
    pen.beginPath();
    pen.moveTo(x, y); pen.lineTo(x - 6, y - 10); pen.lineTo(x + 6, y - 10); pen.closePath();
    pen.fillStyle = "#fff"; pen.fill();
    for (const [wide, down] of [[5, 5], [2.5, 8]]) { pen.moveTo(x - wide, y + down); pen.lineTo(x + wide, y + down); }
    pen.lineWidth = 1.5;
    pen.stroke();
  }
  pen.restore();
}

function draw_mirror() {
  const [px] = to_screen(meta.mirror, 0);
  pen.save();
  pen.setLineDash([14, 4, 3, 4]);
  pen.strokeStyle = style("--muted"); pen.lineWidth = 1;
  pen.beginPath(); pen.moveTo(px, 0); pen.lineTo(px, model.clientHeight); pen.stroke();
  pen.restore();
}

function hatch_fixed(f, visible, half) {
  const fixed = visible.filter((b) => data.fixed[f * meta.blocks + b] === 1), shade_of = shades_at(f, half);
  const dark = (b) => is_dark(shade_of(b));
  hatch(fixed.filter((b) => !dark(b)), half, "#1a1c20");
  hatch(fixed.filter(dark), half, "#fff");
}

function hatch(fixed, half, colour) {
  if (!fixed.length) return;
  pen.save();
  pen.beginPath();
  for (const b of fixed) trace(b, half);
  pen.clip();
  pen.beginPath();
  const w = model.clientWidth, h = model.clientHeight;
  for (let s = -h; s < w; s += 8) { pen.moveTo(s, h); pen.lineTo(s + h, 0); }
  pen.strokeStyle = colour; pen.globalAlpha = 0.45; pen.lineWidth = 1;
  pen.stroke();
  pen.restore();
}

let first_corners = null;
function draw_original() {
  first_corners ??= place_corners(0, new Float64Array(corners.length));
  const all = [...Array(meta.counts[0]).keys()].filter((b) => exists(b, 0));
  const paint = (colour, width, dashes) => {
    pen.strokeStyle = colour; pen.lineWidth = width * Math.max(0.4, edge_width());
    pen.setLineDash(dashes);
    for (const half of both_halves(first_corners)) in_parts(all, half, () => pen.stroke(), 0);
  };
  pen.save();
  paint("rgba(255, 255, 255, .55)", 2, []);
  paint("#33363d", 0.9, [4, 3]);
  pen.restore();
}

function draw_labels(f, visible) {
  pen.textAlign = "center"; pen.textBaseline = "middle"; pen.lineJoin = "round";
  for (const b of visible) {
    const room = data.size[shape_of(b, f)] * state.view.scale;
    if (room < 12) continue;
    pen.font = `${Math.min(13, Math.max(8, 0.45 * room))}px system-ui, sans-serif`;
    const [px, py] = to_screen(...centre(b, f));
    pen.strokeStyle = "rgba(255, 255, 255, .8)"; pen.lineWidth = 3;
    pen.strokeText(b + 1, px, py);
    pen.fillStyle = "#1a1c20";
    pen.fillText(b + 1, px, py);
  }
}
