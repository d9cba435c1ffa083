// Where blocks are in the model and on the canvas.

const model = $("model");
let corners = new Float64Array(0);  // of the current frame, in model lengths

function centre(b, f) {
  const s = shape_of(b, f), x = data.origin[2 * s], y = data.origin[2 * s + 1];
  return x === x ? [x + value("dx", b, f), y + value("dy", b, f)]
                 : [value("x", b, f), value("y", b, f)];  // the block was made after the first frame
}

/// Corners of removed blocks are NaN, so the canvas draws nothing and nothing is inside them.
function place_corners(f, into) {
  for (let b = 0; b < meta.counts[f]; ++b) {
    const [x, y] = centre(b, f), shape = shape_of(b, f);
    const turn = (value("rotation", b, f) - data.angle[shape]) * Math.PI / 180;
    const cos = Math.cos(turn), sin = Math.sin(turn);
    let a = cos, c = sin, d = -sin, e = cos;  // columns (a, c), (d, e)
    if (data.strain) {
      const i = 4 * (f * meta.blocks + b), step = meta.strain_step;
      const s = 1 + step * data.strain[i], t = step * data.strain[i + 1];
      const u = step * data.strain[i + 2], v = 1 + step * data.strain[i + 3];
      [a, c, d, e] = [cos * s - sin * t, sin * s + cos * t, cos * u - sin * v, sin * u + cos * v];
    }
    for (let i = 2 * data.first_corner[shape]; i < 2 * data.first_corner[shape + 1]; i += 2) {
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

/// Shows everything of the first and the current frame.
function fit() {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const f of new Set([0, state.frame])) {
    const all = place_corners(f, new Float64Array(corners.length).fill(NaN));
    for (let i = 0; i < all.length; i += 2) {
      if (all[i] !== all[i]) continue;  // no block has this shape, or it is removed
      const other = state.mirror ? 2 * meta.mirror - all[i] : all[i];
      left = Math.min(left, all[i], other); right = Math.max(right, all[i], other);
      low = Math.min(low, all[i + 1]); high = Math.max(high, all[i + 1]);
    }
  }
  if (!(left < right)) [left, right, low, high] = [0, 1, 0, 1];
  const scale = Math.min(0.94 * model.clientWidth / (right - left), 0.92 * model.clientHeight / (high - low));
  state.view = {x: (left + right) / 2, y: (low + high) / 2, scale};
  state.fitted = true;
  redraw();
}
function zoom(factor, px = model.clientWidth / 2, py = model.clientHeight / 2) {
  const [x, y] = to_model(px, py);
  state.view.scale *= factor;
  const [u, v] = to_model(px, py);
  pan((u - x) * state.view.scale, (y - v) * state.view.scale);
}
/// Moves the picture by page pixels.
function pan(right, down) {
  moves();
  state.view.x -= right / state.view.scale;
  state.view.y += down / state.view.scale;
  state.fitted = false;
  redraw();
}

let typical = 0;
const typical_size = () => typical ||= 2 * [...data.size].sort((a, b) => a - b)[data.size.length >> 1];

/// Returns the topmost block at a point of the canvas, or -1, and whether it is the mirrored one.
function block_at([px, py]) {
  const [x, y] = to_model(px, py), block = block_around(x, y);
  if (block >= 0 || !state.mirror) return {block, mirrored: false};
  return {block: block_around(2 * meta.mirror - x, y), mirrored: true};
}
function block_around(x, y) {
  for (let b = meta.counts[state.frame] - 1; b >= 0; --b) {
    let inside = false;
    const shape = shape_of(b, state.frame);
    const first = 2 * data.first_corner[shape], end = 2 * data.first_corner[shape + 1];
    for (let i = first, j = end - 2; i < end; j = i, i += 2)
      if ((corners[i + 1] > y) !== (corners[j + 1] > y) &&
          x < corners[i] + (y - corners[i + 1]) / (corners[j + 1] - corners[i + 1]) * (corners[j] - corners[i]))
        inside = !inside;
    if (inside) return b;
  }
  return -1;
}
