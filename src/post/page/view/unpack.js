// Unpacks the arrays of the page (view_store.hpp): decodes the text, inflates it, and adds the
// differences to their predictions.

let data = {};  // arrays by name

async function unpack() {
  if (!("DecompressionStream" in window))
    throw new Error("This browser is too old for the page: it needs DecompressionStream "
      + "(Chromium 80, Firefox 113, Safari 16.4 or newer).");
  const packed = bytes_of($("data").textContent, meta.packed);
  $("data").remove();
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const kinds = {f64: Float64Array, f32: Float32Array, u32: Uint32Array, u16: Uint16Array, u8: Uint8Array};
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
  const shapes = data.corners.length;  // first those of all blocks, then more for blocks that split
  data.first_corner = new Uint32Array(shapes + 1);
  for (let s = 0; s < shapes; ++s)
    data.first_corner[s + 1] = data.first_corner[s] + data.corners[s];
  [data.told_x, data.told_y] = [data.x, data.y];
  data.x = places("x", "dx", 0);
  data.y = places("y", "dy", 1);
  data.forces = read_forces();
  data.size = new Float32Array(shapes);  // longest arm of each shape, for picking and zoom
  for (let s = 0; s < shapes; ++s)
    for (let c = data.first_corner[s]; c < data.first_corner[s + 1]; ++c)
      data.size[s] = Math.max(data.size[s], Math.hypot(data.arm[2 * c], data.arm[2 * c + 1]));
}

/// Returns the shape of number i of a column. Each block has one shape, and another one after each
/// crack; without cracks the shapes are the blocks.
const shape_at = (i) => data.shape ? data.shape[i] : i % meta.blocks;
const shape_of = (block, f) => data.shape ? data.shape[f * meta.blocks + block] : block;

/// Returns the coordinates of all blocks. Six digits are too few for national coordinates. So the
/// exact coordinate in the first frame is added to the displacement, unless the displacement is
/// larger than the coordinate. A block made after the first frame has no such coordinate.
function places(name, way, axis) {
  const all = Float64Array.from(data[name]);
  for (let i = 0; i < all.length; ++i) {
    const moved = data[way][i], place = data.origin[2 * shape_at(i) + axis] + moved;
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
  moved_x: () => (i) => data.origin[2 * shape_at(i)] + data.dx[i],
  moved_y: () => (i) => data.origin[2 * shape_at(i) + 1] + data.dy[i],
  length: (n, [x, y]) => (i) => Math.sqrt(x[i] * x[i] + y[i] * y[i]),
  principal: (n, sign) => (i) => {
    const a = data.s11[i], b = data.s22[i], c = data.s12[i], half = 0.5 * (a - b);
    return 0.5 * (a + b) + sign * Math.sqrt(half * half + c * c);
  },
  energy: () => (i) => 0.5 * (data.mass[shape_at(i)] * (data.vx[i] * data.vx[i] + data.vy[i] * data.vy[i])
    + data.inertia[shape_at(i)] * (data.spin[i] * data.spin[i])),
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
