// The page of `blocks view`. The state is one object. Every function that changes it calls
// redraw(), which draws once before the next animation frame.
"use strict";

const $ = (id) => document.getElementById(id);
const meta = JSON.parse($("meta").textContent);
const frames = meta.times.length;
const state = {
  frame: frames - 1, playing: false, pace: 1, colour: "material", followed: "speed",
  block: -1, original: false, forces: false, labels: false, mirror: meta.mirror !== null, ready: false,
  view: {x: 0, y: 0, scale: 1},  // model point in the middle of the canvas; pixels per model length
};
let data = {};  // arrays by name
let ranges = {};  // [low, high] of each quantity over all frames

// ---- data ----------------------------------------------------------------------------

async function unpack() {
  if (!("DecompressionStream" in window))
    throw new Error("This browser is too old for the page: it needs DecompressionStream "
      + "(Chromium 80, Firefox 113, Safari 16.4 or newer).");
  const packed = bytes_of($("data").textContent, meta.packed);
  $("data").remove();
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const kinds = {f64: Float64Array, f32: Float32Array, u16: Uint16Array, u8: Uint8Array};
  const size = {digits: 4, whole: 4, frames: 1};
  let at = 0;
  for (const note of meta.arrays) {
    const {name, type, count, rows} = note;
    const part = bytes.subarray(at, at += count * (size[type] ?? kinds[type].BYTES_PER_ELEMENT));
    data[name] = type === "digits" ? read_digits(part, note)
      : type === "whole" ? on_top(unfold(planes(part, count, 4)), rows)
      : type === "frames" ? part.map((byte, i) => i < rows ? byte : part[i] ^= part[i - rows])
      : new kinds[type](part.slice().buffer);
  }
  data.first_corner = new Uint32Array(meta.blocks + 1);
  for (let b = 0; b < meta.blocks; ++b)
    data.first_corner[b + 1] = data.first_corner[b] + data.corners[b];
  [data.told_x, data.told_y] = [data.x, data.y];
  data.x = places("x", "dx", 0);
  data.y = places("y", "dy", 1);
  data.forces = read_forces();
  data.size = new Float32Array(meta.blocks);  // longest arm of each block, for picking and zoom
  for (let b = 0; b < meta.blocks; ++b)
    for (let c = data.first_corner[b]; c < data.first_corner[b + 1]; ++c)
      data.size[b] = Math.max(data.size[b], Math.hypot(data.arm[2 * c], data.arm[2 * c + 1]));
}

/// Returns the coordinates of all blocks. Six digits are too few for national coordinates. So the
/// exact coordinate in the first frame is added to the displacement, unless the displacement is
/// larger than the coordinate. A block made after the first frame has no such coordinate.
function places(name, way, axis) {
  const all = Float64Array.from(data[name]);
  for (let i = 0; i < all.length; ++i) {
    const moved = data[way][i], place = data.origin[2 * (i % meta.blocks) + axis] + moved;
    if (place === place && Math.abs(moved) < Math.abs(all[i])) all[i] = place;
  }
  return all;
}

/// Decodes the text: two letters of an alphabet of 91 hold 13 bits.
function bytes_of(text, count) {
  const digit = new Uint8Array(128);
  let known = 0;
  for (let c = 33; c < 127; ++c)
    if (!"&<>".includes(String.fromCharCode(c))) digit[c] = known++;
  const bytes = new Uint8Array(count);  // surplus bits of the last letters are dropped
  for (let i = 0, n = 0, held = 0, bits = 0; i + 1 < text.length; i += 2) {
    held |= (digit[text.charCodeAt(i)] + 91 * digit[text.charCodeAt(i + 1)]) << bits;
    for (bits += 13; bits > 7; bits -= 8, held >>>= 8) bytes[n++] = held & 255;
  }
  return bytes;
}

/// Reads numbers stored as the lowest bytes of all numbers, then the next bytes, and so on.
function planes(part, count, number) {
  const whole = new Uint32Array(count);
  for (let k = number - 1; k >= 0; --k)
    for (let i = 0, from = k * count; i < count; ++i) whole[i] = whole[i] << 8 | part[from + i];
  return whole;
}
/// Maps 0, 1, 2, 3 to 0, -1, 1, -2.
function unfold(told) {
  for (let i = 0; i < told.length; ++i) told[i] = told[i] >>> 1 ^ -(told[i] & 1);
  return new Int32Array(told.buffer);
}
/// Adds each frame to the previous one.
function on_top(changes, rows) {
  for (let i = rows; i < changes.length; ++i) changes[i] += changes[i - rows];
  return changes;
}

/// Predictions of numbers from other quantities. The program uses the same operations in the same
/// order (view_data.cpp) and stores only the differences.
const formulas = {
  moved_x: (n) => (i) => data.origin[2 * (i % n)] + data.dx[i],
  moved_y: (n) => (i) => data.origin[2 * (i % n) + 1] + data.dy[i],
  length: (n, [x, y]) => (i) => Math.sqrt(x[i] * x[i] + y[i] * y[i]),
  principal: (n, sign) => (i) => {
    const a = data.s11[i], b = data.s22[i], c = data.s12[i], half = 0.5 * (a - b);
    return 0.5 * (a + b) + sign * Math.sqrt(half * half + c * c);
  },
  energy: (n) => (i) => 0.5 * (data.mass[i % n] * (data.vx[i] * data.vx[i] + data.vy[i] * data.vy[i])
    + data.inertia[i % n] * (data.spin[i] * data.spin[i])),
};
const guess_of = ({name, guess, rows}) => ({
  length: () => formulas.length(rows, name === "speed" ? [data.vx, data.vy] : [data.dx, data.dy]),
  principal_1: () => formulas.principal(rows, 1), principal_2: () => formulas.principal(rows, -1),
}[guess] ?? (() => formulas[guess](rows)))();

const tens = Array.from({length: 64}, (_, k) => Number(`1e${k}`));
const shifted = (value, power) => power >= 0 ? value * tens[power] : value / tens[-power];
const not_finite = 127;

/// Reads numbers of six digits and a power of ten (view_numbers.hpp).
function read_digits(part, note) {
  const {count, rows, guess} = note, shown = new Float32Array(count);
  const power = on_top(new Int8Array(part.slice(0, count).buffer), rows);
  const told = unfold(planes(part.subarray(count), count, 3));
  const expected = guess === "before" ? (i) => i < rows ? 0 : shown[i - rows]
    : guess === "linear" ? (i) => i < rows ? 0 : i < 2 * rows ? shown[i - rows] : 2 * shown[i - rows] - shown[i - 2 * rows]
    : guess_of(note);
  for (let i = 0; i < count; ++i) {
    const near = Math.floor(shifted(expected(i), -power[i]) + 0.5);
    const digits = told[i] + (near !== near ? 0 : Math.max(-999999, Math.min(999999, near)));
    shown[i] = power[i] !== not_finite ? shifted(digits, power[i]) : digits ? digits * Infinity : NaN;
  }
  return shown;
}

/// Returns the forces of each frame: their corners, directions and sizes.
function read_forces() {
  const {acting, directions, sizes} = data, all = acting.length / frames, result = [];
  let before = {start: new Uint32Array(all + 1), direction: [], size: []};
  for (let f = 0, at = 0; f < frames; ++f) {
    const count = acting.subarray(f * all, (f + 1) * all), start = new Uint32Array(all + 1);
    for (let c = 0; c < all; ++c) start[c + 1] = start[c] + count[c];
    const n = start[all], corner = new Uint32Array(n), direction = directions.slice(at, at + n), size = sizes.slice(at, at + n);
    for (let c = 0; c < all; ++c)
      for (let i = start[c], old = before.start[c]; i < start[c + 1]; ++i, ++old) {
        corner[i] = c;
        if (old >= before.start[c + 1]) continue;
        direction[i] += before.direction[old];
        size[i] += before.size[old];
      }
    result.push({corner, direction, size});
    before = {start, direction, size};
    at += n;
  }
  return result;
}

const quantity = (name) => meta.quantities.find((q) => q.name === name);
const value = (name, block, frame) => data[name][frame * meta.blocks + block];
const exists = (block, frame) => block < meta.counts[frame];
/// Formats a number with six digits, as in the file (told), or with more digits, down to `finest`.
/// Trailing zeros are removed.
const digits = (told, finest = Infinity, sharp = told) => {
  const size = Math.abs(sharp), more = Math.floor(Math.log10(size)) - Math.round(Math.log10(finest)) + 1;
  const many = size > 0 ? Math.max(6, Math.min(15, more)) : 6;
  const number = many > 6 ? sharp : told;
  return size !== 0 && (size < 1e-3 || size >= 10 ** Math.max(7, many))
    ? number.toExponential(many - 1).replace(/\.?0+e/, "e").replace("e+", "e")
    : String(Number(number.toPrecision(many)));
};
/// Coordinates are shown with the decimals of a six-digit number as large as the model, wherever
/// the model is.
const is_place = (name) => name === "x" || name === "y";
let finest_place = Infinity;
function find_finest_place() {
  const widths = ["x", "y"].map((name) => ranges[name][1] - ranges[name][0]);
  const extent = data.size.reduce((most, size) => Math.max(most, size), Math.max(...widths));
  if (extent > 0) finest_place = 10 ** (Math.floor(Math.log10(extent)) - 5);
}
const counted = (n, thing) => `${n} ${thing}${n === 1 ? "" : "s"}`;
const with_unit = (text, unit) => unit ? `${text} [${unit}]` : text;

function find_ranges() {
  for (const q of meta.quantities) {
    let low = Infinity, high = -Infinity;
    for (let f = 0; f < frames; ++f)
      for (let b = 0, i = f * meta.blocks; b < meta.counts[f]; ++b, ++i) {
        const v = data[q.name][i];
        if (v < low) low = v;
        if (v > high) high = v;
      }
    if (q.name === "x" && meta.mirror !== null)
      [low, high] = [Math.min(low, 2 * meta.mirror - high), Math.max(high, 2 * meta.mirror - low)];
    if (!(low <= high)) low = high = 0;
    if (q.signed) { high = Math.max(Math.abs(low), Math.abs(high)); low = -high; }
    else if (!is_place(q.name)) low = Math.min(low, 0);
    if (!(high > low)) [low, high] = q.signed ? [-1, 1] : [low, low + 1];
    ranges[q.name] = [low, high];
  }
}

// ---- the model -----------------------------------------------------------------------

const model = $("model"), pen = model.getContext("2d");
let corners = new Float64Array(0);  // of the current frame, in model lengths

function centre(b, f) {
  const x = data.origin[2 * b], y = data.origin[2 * b + 1];
  return x === x ? [x + value("dx", b, f), y + value("dy", b, f)]
                 : [value("x", b, f), value("y", b, f)];  // the block was made after the first frame
}

function place_corners(f, into) {
  for (let b = 0; b < meta.counts[f]; ++b) {
    const [x, y] = centre(b, f);
    const turn = (value("rotation", b, f) - data.angle[b]) * Math.PI / 180;
    const cos = Math.cos(turn), sin = Math.sin(turn);
    let a = cos, c = sin, d = -sin, e = cos;  // columns (a, c), (d, e)
    if (data.strain) {
      const i = 4 * (f * meta.blocks + b), step = meta.strain_step;
      const s = 1 + step * data.strain[i], t = step * data.strain[i + 1];
      const u = step * data.strain[i + 2], v = 1 + step * data.strain[i + 3];
      [a, c, d, e] = [cos * s - sin * t, sin * s + cos * t, cos * u - sin * v, sin * u + cos * v];
    }
    for (let i = 2 * data.first_corner[b]; i < 2 * data.first_corner[b + 1]; i += 2) {
      const u = data.arm[i], v = data.arm[i + 1];
      into[i] = x + a * u + d * v;
      into[i + 1] = y + c * u + e * v;
    }
  }
  return into;
}

/// Adds the other half of a half model, if the page has a symmetry plane and shows it.
const reflect = (all) => all.map((value, i) => i % 2 ? value : 2 * meta.mirror - value);
const both_halves = (all) => state.mirror ? [reflect(all), all] : [all];

const to_screen = (x, y) => [
  model.clientWidth / 2 + (x - state.view.x) * state.view.scale,
  model.clientHeight / 2 - (y - state.view.y) * state.view.scale];
const to_model = (px, py) => [
  state.view.x + (px - model.clientWidth / 2) / state.view.scale,
  state.view.y - (py - model.clientHeight / 2) / state.view.scale];

/// Shows everything of the first and the current frame, next to the legend if there is room.
function fit() {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const f of new Set([0, state.frame])) {
    const all = place_corners(f, new Float64Array(2 * data.first_corner[meta.blocks]));
    for (let i = 0; i < 2 * data.first_corner[meta.counts[f]]; i += 2) {
      const other = state.mirror ? 2 * meta.mirror - all[i] : all[i];
      left = Math.min(left, all[i], other); right = Math.max(right, all[i], other);
      low = Math.min(low, all[i + 1]); high = Math.max(high, all[i + 1]);
    }
  }
  if (!(left < right)) [left, right, low, high] = [0, 1, 0, 1];
  const wide = model.clientWidth > 700, legend = wide ? 150 : 0, head = wide ? 0 : 130;
  const room = model.clientWidth - legend, tall = model.clientHeight - head;
  const scale = Math.min(0.92 * room / (right - left), 0.86 * tall / (high - low));
  state.view = {x: (left + right) / 2 + legend / 2 / scale, y: (low + high) / 2 + head / 2 / scale, scale};
  redraw();
}

function trace(b, from) {
  const first = 2 * data.first_corner[b], end = 2 * data.first_corner[b + 1];
  const {x, y, scale} = state.view;
  const u = model.clientWidth / 2 - x * scale, v = model.clientHeight / 2 + y * scale;
  pen.moveTo(u + from[first] * scale, v - from[first + 1] * scale);
  for (let i = first + 2; i < end; i += 2)
    pen.lineTo(u + from[i] * scale, v - from[i + 1] * scale);
  pen.closePath();
}

/// Paints blocks in groups, because one path of many blocks is much slower than many short paths.
function in_parts(blocks, from, paint, most = 32) {
  for (let i = 0; i < blocks.length; i += most) {
    pen.beginPath();
    for (const b of blocks.slice(i, i + most)) trace(b, from);
    paint();
  }
}

/// Groups the visible blocks of one half by colour.
function shades(f, visible, half) {
  const groups = new Map(), shade_of = shades_at(f, half);
  for (const b of visible) {
    const shade = shade_of(b);
    groups.has(shade) ? groups.get(shade).push(b) : groups.set(shade, [b]);
  }
  return groups;
}
/// Returns the value of the mirrored block; odd quantities change their sign.
const in_mirror = (q, v) => q.name === "x" ? 2 * meta.mirror - v : q.odd ? -v : v;
/// Returns a function that gives the colour of a block of that half in that frame.
function shades_at(f, half) {
  if (state.colour === "material") return (b) => meta.materials[meta.material[b]];
  const q = quantity(state.colour), map = q.signed ? meta.diverging : meta.sequential;
  const [low, high] = ranges[q.name], factor = (map.length - 1) / (high - low);
  const shown = half === corners ? (v) => v : (v) => in_mirror(q, v);
  return (b) => map[Math.round((shown(value(q.name, b, f)) - low) * factor)];
}
const is_dark = (shade) => [1, 3, 5].reduce((sum, i) => sum + parseInt(shade.slice(i, i + 2), 16), 0) < 306;

const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);

function draw_model() {
  const f = state.frame, {x, y, scale} = state.view;
  size_canvas(model, pen);
  place_corners(f, corners);
  const half_w = model.clientWidth / 2 / scale, half_h = model.clientHeight / 2 / scale;
  const visible = [];
  for (let b = 0; b < meta.counts[f]; ++b) {
    const [cx, cy] = centre(b, f), r = 1.3 * data.size[b];
    const near = Math.abs(cx - x) < half_w + r || (state.mirror && Math.abs(2 * meta.mirror - cx - x) < half_w + r);
    if (near && Math.abs(cy - y) < half_h + r) visible.push(b);
  }
  const fine = visible.length <= draft_above || !hurried(), halves = both_halves(corners);
  if (!fine) {
    draw_draft(f, visible, halves);
    for (const [x0, y0, x1, y1, part] of state.forces ? force_lines(f, halves) : [])
      put_line(x0, y0, x1, y1, pixel(force_shade(part)));
    pen.putImageData(picture, 0, 0);
  }
  for (const half of fine ? halves : [])
    for (const [shade, group] of shades(f, visible, half)) {
      pen.fillStyle = shade;
      in_parts(group, half, () => pen.fill());
    }
  for (const half of halves) hatch_fixed(f, visible, half);
  const edge = Math.min(1, typical_size() * scale / 24);
  if (fine && edge > 0.2) {
    pen.strokeStyle = style("--edge");
    pen.lineWidth = edge;
    pen.lineJoin = "round";
    for (const half of halves) in_parts(visible, half, () => pen.stroke());
  }
  if (state.original) draw_original();
  if (fine && state.forces) draw_forces(f, halves);
  if (state.mirror) draw_plane();
  if (state.labels) draw_labels(f, visible);
  if (state.block >= 0 && exists(state.block, f)) {
    pen.beginPath();
    for (const half of halves) trace(state.block, half);
    pen.strokeStyle = style("--sheet"); pen.lineWidth = 5; pen.stroke();
    pen.strokeStyle = style("--mark"); pen.lineWidth = 2.5; pen.stroke();
  }
}

function draw_plane() {
  const [px] = to_screen(meta.mirror, 0);
  pen.save();
  pen.setLineDash([14, 4, 3, 4]);
  pen.strokeStyle = style("--muted"); pen.lineWidth = 1;
  pen.beginPath(); pen.moveTo(px, 0); pen.lineTo(px, model.clientHeight); pen.stroke();
  pen.restore();
}

function hatch_fixed(f, visible, half) {
  const fixed = visible.filter((b) => data.fixed[f * meta.blocks + b]), shade_of = shades_at(f, half);
  const dark = (b) => is_dark(shade_of(b));
  hatch(fixed.filter((b) => !dark(b)), half, style("--edge"));
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
  pen.save();
  pen.setLineDash([4, 3]);
  pen.strokeStyle = style("--first"); pen.lineWidth = 0.9;
  for (const half of both_halves(first_corners)) in_parts([...Array(meta.counts[0]).keys()], half, () => pen.stroke());
  pen.restore();
}

/// Returns the median of the largest forces of the frames, as a byte, so that an impact does not
/// hide all other forces.
let usual = -1;
function usual_force() {
  if (usual >= 0) return usual;
  const largest = data.forces.map(({size}) => size.reduce((most, s) => Math.max(most, s), 0))
    .filter((most) => most > 0).sort((a, b) => a - b);
  return usual = largest[largest.length >> 1] ?? 255;
}

/// Returns the length on the page of the reference force. Lengths grow with the square root of the
/// force, so that small forces remain visible.
const force_length = () => Math.min(60, 1.2 * typical_size() * state.view.scale);

/// The number of shades and widths. `part` is the ratio of a force to the reference force.
const force_steps = 12;
const force_shade = (part) => meta.intensity[Math.round(Math.min(1, part) * (meta.intensity.length - 1))];

/// Returns lines through the contacts along their forces: x0, y0, x1, y1 on the page, and the ratio
/// of the force to the reference force.
function force_lines(f, halves) {
  const {corner, direction, size} = data.forces[f], full = force_length(), lines = [];
  const {x, y, scale} = state.view, w = model.clientWidth, h = model.clientHeight;
  for (let i = 0; i < corner.length; ++i) {
    const part = 10 ** (6 * (size[i] - usual_force()) / 255), length = Math.min(2 * full, full * Math.sqrt(part));
    if (length < 0.7) continue;
    const turn = direction[i] / 256 * 2 * Math.PI;
    halves.forEach((half) => {
      const px = w / 2 + (half[2 * corner[i]] - x) * scale, py = h / 2 - (half[2 * corner[i] + 1] - y) * scale;
      if (px < -full || py < -full || px > w + full || py > h + full) return;
      const dx = (half === corners ? 1 : -1) * Math.cos(turn) * length / 2, dy = -Math.sin(turn) * length / 2;
      lines.push([px - dx, py - dy, px + dx, py + dy, part]);
    });
  }
  return lines;
}

/// Draws small forces first, so that wide and dark lines are on top.
function draw_forces(f, halves) {
  const full = force_length(), groups = Array.from({length: force_steps + 1}, () => []);
  for (const line of force_lines(f, halves)) groups[Math.round(Math.min(1, line[4]) * force_steps)].push(line);
  const paint = (lines, colour, width, alpha) => {
    pen.strokeStyle = colour; pen.lineWidth = width; pen.globalAlpha = alpha;
    for (let i = 0; i < lines.length; i += 64) {
      pen.beginPath();
      for (const [x0, y0, x1, y1] of lines.slice(i, i + 64)) { pen.moveTo(x0, y0); pen.lineTo(x1, y1); }
      pen.stroke();
    }
  };
  pen.lineCap = full > 10 ? "round" : "butt";
  groups.forEach((lines, k) => {
    const part = k / force_steps, width = Math.max(0.6, Math.min(1, full / 12) * (1 + 3 * part));
    if (full > 10) paint(lines, "#fff", width + 1.6, 0.7);
    paint(lines, force_shade(part), width, 1);
  });
  pen.globalAlpha = 1;
}

let typical = 0;
const typical_size = () => typical ||= 2 * [...data.size].sort((a, b) => a - b)[meta.blocks >> 1];

function draw_labels(f, visible) {
  pen.textAlign = "center"; pen.textBaseline = "middle"; pen.lineJoin = "round";
  for (const b of visible) {
    const room = data.size[b] * state.view.scale;
    if (room < 12) continue;
    pen.font = `${Math.min(13, Math.max(8, 0.45 * room))}px system-ui, sans-serif`;
    const [px, py] = to_screen(...centre(b, f));
    pen.strokeStyle = "rgba(255, 255, 255, .8)"; pen.lineWidth = 3;
    pen.strokeText(b + 1, px, py);
    pen.fillStyle = "#1a1c20";
    pen.fillText(b + 1, px, py);
  }
}

function size_canvas(canvas, its_pen) {
  const ratio = window.devicePixelRatio || 1;
  const w = Math.round(canvas.clientWidth * ratio), h = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
  its_pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  its_pen.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
}

/// Returns the topmost block at a point of the canvas, or -1.
function pick(px, py) {
  const [x, y] = to_model(px, py), here = pick_at(x, y);
  return here < 0 && state.mirror ? pick_at(2 * meta.mirror - x, y) : here;
}
function pick_at(x, y) {
  for (let b = meta.counts[state.frame] - 1; b >= 0; --b) {
    let inside = false;
    const first = 2 * data.first_corner[b], end = 2 * data.first_corner[b + 1];
    for (let i = first, j = end - 2; i < end; j = i, i += 2)
      if ((corners[i + 1] > y) !== (corners[j + 1] > y) &&
          x < corners[i] + (y - corners[i + 1]) / (corners[j + 1] - corners[i + 1]) * (corners[j] - corners[i]))
        inside = !inside;
    if (inside) return b;
  }
  return -1;
}

// ---- legend, numbers, history --------------------------------------------------------

function nice_ticks(low, high, count) {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw)), digit = raw / power;
  const step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10), ticks = [];
  if (Math.max(Math.abs(low), Math.abs(high)) > 1e15 * step) return ticks;  // doubles are too coarse for the ticks
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * (high - low); ++k)
    ticks.push(k * step);
  return ticks;
}
const tick_text = (t) => {
  if (t === 0) return "0";
  const big = Math.abs(t) >= 1e6 || Math.abs(t) < 1e-4;
  return (big ? Number(t.toPrecision(4)).toExponential() : String(Number(t.toPrecision(6)))).replaceAll("-", "−");
};

const made = (kind, name, text = "") => {
  const part = document.createElement(kind);
  part.className = name;
  part.textContent = text;
  return part;
};

/// Large and small numbers are shown in powers of ten, which are written with the unit.
const superscript = (n) => String(n).replace("-", "⁻").replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
function power_of(low, high) {
  const most = Math.max(Math.abs(low), Math.abs(high));
  return most >= 1e5 || (most > 0 && most < 1e-3) ? 3 * Math.floor(Math.log10(most) / 3) : 0;
}
const titled = (label, unit, power) => with_unit(label, [power ? `10${superscript(power)}` : "", unit].filter(Boolean).join(" "));

/// Returns round numbers of an axis with their labels, and the title of the axis. If numbers differ
/// only in late digits, a round number is subtracted: y − 4000000 [m].
function label_ticks(low, high, count, name, unit) {
  const ticks = nice_ticks(low, high, count), step = ticks[1] - ticks[0];
  let offset = 0;
  if (Math.max(...ticks.map(Math.abs)) >= 1e5 * step) {
    const slack = 1e-6 * step;
    let unit = 10 ** Math.ceil(Math.log10(Math.max(...ticks.map(Math.abs))));
    do offset = Math.ceil((ticks[0] - slack) / unit) * unit;  // the number with the fewest digits
    while (offset > ticks.at(-1) + slack && (unit /= 10) > 1e-3 * step);
    offset = Number(offset.toPrecision(15));
  }
  // The difference carries the rounding error of the tick; round it off.
  const digit = 10 ** Math.floor(Math.log10(step) + 1e-3);
  const rest = (t) => offset ? Math.round((t - offset) / digit) * digit : t;
  const power = power_of(...(offset ? [rest(ticks[0]), rest(ticks.at(-1))] : [low, high]));
  const from = offset ? ` ${offset < 0 ? "+" : "−"} ${Math.abs(offset)}` : "";
  return {ticks: ticks.map((t) => [t, tick_text(rest(t) / 10 ** power)]), title: titled(name + from, unit, power)};
}

/// Returns a colour bar with its numbers; there are fewer on the short bar of a small screen
/// (page.css).
const small_screen = matchMedia("(max-width: 760px), (max-aspect-ratio: 9/10)");
function key_bar(name, unit, map, low, high) {
  const {ticks: all, title: label} = label_ticks(low, high, small_screen.matches ? 2 : 5, name, unit);
  const bar = made("div", "bar"), ticks = made("div", "ticks");
  bar.style.background = `linear-gradient(to top, ${map.join(", ")})`;
  for (const [t, words] of all) {
    const text = made("span", "", words);
    text.style.top = `${100 * (high - t) / (high - low)}%`;
    ticks.append(text);
  }
  const key = made("div", "scale");
  key.append(made("p", "", label), bar, ticks);
  return key;
}

/// Draws the legend of the colours; many materials are shown as numbers only.
let key_shown = "";
function draw_key() {
  const wanted = `${state.colour} ${state.forces} ${small_screen.matches}`;
  if (wanted === key_shown) return;
  key_shown = wanted;
  const by_material = state.colour === "material", materials = by_material ? Object.entries(meta.materials) : [];
  const many = materials.length > 12, list = made("div", many ? "many" : "few");
  const add = (text, shade, name) => {
    const row = made("div", `swatch ${name}_row`), colour = made("i", name);
    colour.style.backgroundColor = shade;
    row.append(colour, text);
    list.append(row);
  };
  for (const [name, shade] of materials) add(many ? name : `material ${name}`, shade, "");
  if (data.fixed.some((is) => is)) add("fixed", "", "fixed");
  const parts = [list];
  if (many) parts.unshift(made("p", "", "materials"));
  if (!by_material) {
    const q = quantity(state.colour);
    parts.push(key_bar(q.label, q.unit, q.signed ? meta.diverging : meta.sequential, ...ranges[q.name]));
  }
  if (state.forces && meta.largest_force > 0)
    parts.push(key_bar("contact force", meta.force_unit, meta.intensity, 0,
      meta.largest_force * 10 ** (6 * (usual_force() / 255 - 1))));
  $("key").replaceChildren(...parts);
}

/// Returns the rows of the table for the selected block, or for the whole model.
function rows() {
  const f = state.frame;
  if (state.block < 0)
    return [
      {name: "kinetic_energy", label: "kinetic energy", unit: meta.energy_unit, all: meta.kinetic_energy},
      {name: "contacts", label: "acting contacts", unit: "", all: meta.contacts},
      {name: "blocks", label: "blocks", unit: "", all: meta.counts}];
  return meta.quantities.map((q) => ({...q, all: meta.times.map((_, g) =>
    exists(state.block, g) ? value(q.name, state.block, g) : NaN)}));
}

const text_of = (name, number) => is_place(name)
  ? digits(data[`told_${name}`][state.frame * meta.blocks + state.block], finest_place, number) : digits(number);

let shown_block = null;
function draw_numbers() {
  const list = rows(), body = $("numbers").tBodies[0], f = state.frame, b = state.block;
  if (shown_block !== (b < 0)) {
    shown_block = b < 0;
    body.replaceChildren(...list.map(({name, label, unit}) => {
      const row = document.createElement("tr");
      row.dataset.name = name;
      row.tabIndex = 0;
      for (const text of [label, "", unit]) row.insertCell().textContent = text;
      row.onclick = () => { state.followed = name; redraw(); };
      row.onkeydown = (event) => { if (event.key === "Enter") row.onclick(); };
      return row;
    }));
  }
  const followed = list.find(({name}) => name === state.followed) ?? list[0];
  list.forEach(({name, all}, i) => {
    const row = body.rows[i];
    row.cells[1].textContent = Number.isNaN(all[f]) ? "–" : text_of(name, all[f]).replaceAll("-", "−");
    row.setAttribute("aria-selected", name === followed.name);
  });
  $("block_name").textContent = b < 0 ? "Whole model" : `Block ${b + 1}`;
  $("block_about").textContent = b < 0 ? "Click a block to see its numbers."
    : !exists(b, f) ? "does not exist yet" : `material ${meta.material[b]}, ${data.corners[b]} corners`
      + (data.fixed[f * meta.blocks + b] ? ", fixed" : "");
  draw_chart(followed);
}

const chart = $("chart"), chart_pen = chart.getContext("2d");
let chart_time = null;  // maps a pointer position to a frame
function draw_chart({label, unit, all}) {
  size_canvas(chart, chart_pen);
  const p = chart_pen, w = chart.clientWidth, h = chart.clientHeight;
  const left = 58, right = w - 10, top = 10, bottom = h - 34;
  let low = Infinity, high = -Infinity;
  for (const v of all) if (v === v) { low = Math.min(low, v); high = Math.max(high, v); }
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
  p.beginPath();
  let drawing = false;
  all.forEach((v, i) => {
    if (v !== v) { drawing = false; return; }
    drawing ? p.lineTo(px(meta.times[i]), py(v)) : p.moveTo(px(meta.times[i]), py(v));
    drawing = true;
  });
  p.strokeStyle = style("--accent"); p.lineWidth = 1.8; p.lineJoin = "round"; p.stroke();
  const now = px(meta.times[state.frame]);
  p.strokeStyle = style("--muted"); p.lineWidth = 1;
  p.beginPath(); p.moveTo(now, top); p.lineTo(now, bottom); p.stroke();
  const v = all[state.frame];
  if (v === v) {
    p.beginPath(); p.arc(now, py(v), 4, 0, 2 * Math.PI);
    p.fillStyle = style("--mark"); p.fill();
  }
  chart_time = (x) => nearest(t0 + (x - left) / (right - left) * (t1 - t0));
}

function nearest(time) {
  let best = 0;
  for (let i = 1; i < frames; ++i)
    if (Math.abs(meta.times[i] - time) < Math.abs(meta.times[best] - time)) best = i;
  return best;
}

function draw_clock() {
  const unit = meta.time_unit === "T" ? "" : ` ${meta.time_unit}`;
  $("clock").innerHTML = "";
  const time = document.createElement("b"), more = document.createElement("small");
  time.textContent = `t = ${Number(meta.times[state.frame].toPrecision(4))}${unit}`;
  more.textContent = ` step ${meta.steps[state.frame]}`;
  $("clock").append(time, more);
  $("scrub").value = state.frame;
  $("scrub").setAttribute("aria-valuetext", time.textContent);
}

// ---- drawing once per animation frame ------------------------------------------------

let asked = false;
function redraw() {
  if (asked || !state.ready) return;
  asked = true;
  requestAnimationFrame(draw);
}
function draw() {
  asked = false;
  draw_model();
  draw_key();
  draw_clock();
  draw_numbers();
}

// ---- playing -------------------------------------------------------------------------

let started = 0, started_at = 0;
/// Returns the duration of the whole run: 25 frames per second, but at least 4 s.
const whole = () => Math.max(4, frames / 25) / state.pace;
function tick(now) {
  if (!state.playing) return;
  const [t0, t1] = [meta.times[0], meta.times[frames - 1]];
  const part = started_at + (now - started) / 1000 / whole();
  const frame = nearest(t0 + Math.min(part, 1) * (t1 - t0));
  if (frame !== state.frame) { state.frame = frame; redraw(); }
  if (part >= 1) play(false);
  else requestAnimationFrame(tick);
}
function play(on) {
  if (on && frames < 2) return;
  if (on && state.frame === frames - 1) state.frame = 0;
  state.playing = on;
  $("play").textContent = on ? "❚❚" : "▶";
  $("play").setAttribute("aria-label", on ? "pause" : "play");
  if (on) {
    const [t0, t1] = [meta.times[0], meta.times[frames - 1]];
    started = performance.now();
    started_at = (meta.times[state.frame] - t0) / (t1 - t0 || 1);
    requestAnimationFrame(tick);
  }
  redraw();
}
function show(frame) {
  if (state.playing) play(false);
  moves();
  state.frame = Math.max(0, Math.min(frames - 1, frame));
  redraw();
}

// ---- pointer and keys ----------------------------------------------------------------

function zoom(factor, px = model.clientWidth / 2, py = model.clientHeight / 2) {
  moves();
  const [x, y] = to_model(px, py);
  state.view.scale *= factor;
  const [u, v] = to_model(px, py);
  state.view.x += x - u;
  state.view.y += y - v;
  redraw();
}

const pointers = new Map();
let moved = 0;
model.addEventListener("pointerdown", (event) => {
  try { model.setPointerCapture(event.pointerId); } catch { /* not a real pointer */ }
  pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
  if (pointers.size === 1) moved = 0;
});
model.addEventListener("pointermove", (event) => {
  const last = pointers.get(event.pointerId);
  if (!last) return;
  const here = [event.offsetX, event.offsetY], others = [...pointers].filter(([id]) => id !== event.pointerId);
  moved += Math.hypot(here[0] - last[0], here[1] - last[1]);
  if (others.length === 0) {
    state.view.x -= (here[0] - last[0]) / state.view.scale;
    state.view.y += (here[1] - last[1]) / state.view.scale;
  } else {
    const [x, y] = others[0][1];
    state.view.x -= (here[0] - last[0]) / 2 / state.view.scale;
    state.view.y += (here[1] - last[1]) / 2 / state.view.scale;
    zoom(Math.hypot(here[0] - x, here[1] - y) / Math.max(1, Math.hypot(last[0] - x, last[1] - y)),
      (here[0] + x) / 2, (here[1] + y) / 2);
  }
  pointers.set(event.pointerId, here);
  moves();
  redraw();
});
model.addEventListener("pointerup", (event) => {
  if (pointers.delete(event.pointerId) && moved < 6 && pointers.size === 0)
    choose(pick(event.offsetX, event.offsetY));
});
model.addEventListener("pointercancel", (event) => pointers.delete(event.pointerId));
model.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), event.offsetX, event.offsetY);
}, {passive: false});
model.addEventListener("dblclick", (event) => zoom(2, event.offsetX, event.offsetY));

function choose(block) { state.block = block; redraw(); }

const scrub_chart = (event) => { if (event.buttons) show(chart_time(event.offsetX)); };
chart.addEventListener("pointerdown", scrub_chart);
chart.addEventListener("pointermove", scrub_chart);

function colour_by(name) {
  state.colour = name;
  $("colour").value = name;
  if (name !== "material") state.followed = name;
  redraw();
}
function next_colour(step) {
  const names = ["material", ...meta.quantities.map((q) => q.name)];
  colour_by(names[(names.indexOf(state.colour) + step + names.length) % names.length]);
}
function toggle(name) { state[name] = !state[name]; $(name).checked = state[name]; redraw(); }
function set_theme(name) { document.documentElement.dataset.theme = name; redraw(); }
const other_theme = () => set_theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");

const keys = {
  " ": () => play(!state.playing), "ArrowLeft": () => show(state.frame - 1), "ArrowRight": () => show(state.frame + 1),
  "Home": () => show(0), "End": () => show(frames - 1), "+": () => zoom(1.25), "=": () => zoom(1.25), "-": () => zoom(0.8),
  "m": () => meta.mirror !== null && toggle("mirror"), "f": fit, "0": fit, "o": () => toggle("original"), "c": () => toggle("forces"), "n": () => toggle("labels"),
  "[": () => next_colour(-1), "]": () => next_colour(1), "t": other_theme, "Escape": () => choose(-1),
  ",": () => choose(Math.max(0, state.block - 1)), ".": () => choose(Math.min(meta.blocks - 1, state.block + 1)),
  "?": () => $("keys").showModal()};
addEventListener("keydown", (event) => {
  const target = event.target.tagName;
  if (event.ctrlKey || event.metaKey || event.altKey || !state.ready || $("keys").open) return;
  const pressable = target === "BUTTON" || event.target.type === "checkbox";
  if (target === "SELECT" || (pressable && event.key === " ")) return;
  const action = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (action) { event.preventDefault(); action(); }
});

$("play").onclick = () => play(!state.playing);
$("back").onclick = () => show(state.frame - 1);
$("next").onclick = () => show(state.frame + 1);
$("scrub").oninput = (event) => show(Number(event.target.value));
$("pace").onchange = (event) => {
  const on = state.playing;
  state.pace = Number(event.target.value);
  if (on) { play(false); play(true); }
};
$("colour").onchange = (event) => colour_by(event.target.value);
for (const name of ["original", "forces", "labels", "mirror"])
  $(name).onchange = (event) => { state[name] = event.target.checked; redraw(); };
$("fit").onclick = fit;
$("help").onclick = () => $("keys").showModal();
$("theme").onclick = other_theme;

// ---- start ---------------------------------------------------------------------------

async function begin() {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  set_theme(dark.matches ? "dark" : "light");
  dark.addEventListener("change", () => set_theme(dark.matches ? "dark" : "light"));
  document.title = $("title").textContent = meta.title || "BLOCKS";
  $("about").textContent = `${meta.file} · ${counted(meta.blocks, "block")} · ${counted(frames, "frame")}`;
  $("scrub").max = frames - 1;
  $("mirror").checked = state.mirror;
  $("mirror").parentElement.hidden = meta.mirror === null;
  const option = (name, text) => $("colour").add(new Option(text, name));
  option("material", "material");
  for (const q of meta.quantities) option(q.name, with_unit(q.label, q.unit));
  await unpack();
  find_ranges();
  find_finest_place();
  corners = new Float64Array(2 * data.first_corner[meta.blocks]);
  state.ready = true;
  $("message").textContent = "";
  fit();
  new ResizeObserver(redraw).observe($("stage"));
  document.documentElement.dataset.ready = "yes";
}
begin().catch((fault) => { $("message").textContent = fault.message; });
