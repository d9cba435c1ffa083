// Draft pictures for the page of `blocks view`. The canvas fills only about 200 blocks per
// millisecond. If there are very many blocks and something moves, they are drawn pixel by pixel
// instead, twenty times as fast. The fine picture follows when nothing moves.

const rest = 250;
let draft_above = 3000, moved_at = -Infinity, fine_later = 0;
const hurried = () => state.playing || performance.now() - moved_at < rest;
/// Call this for every change of the next picture.
function moves() {
  moved_at = performance.now();
  clearTimeout(fine_later);
  fine_later = setTimeout(redraw, rest + 50);
}

/// Converts "#rrggbb" to a pixel.
const pixel = remembered((shade) => 0xff000000 | parseInt(shade.slice(5, 7) + shade.slice(3, 5) + shade.slice(1, 3), 16));
let picture = null, pixels = null, crossings = new Float64Array(64);

/// The canvas in its own pixels. It is read once per picture, because reading it for every block
/// took nine tenths of the time. ratio: canvas pixels per page pixel; scale: canvas pixels per
/// model length; u, v: origin of the model.
let sheet = {w: 0, h: 0, ratio: 1, scale: 1, u: 0, v: 0};

function draw_draft(f, visible, halves) {
  const w = model.width, h = model.height, ratio = w / model.clientWidth, scale = state.view.scale * ratio;
  sheet = {w, h, ratio, scale, u: w / 2 - state.view.x * scale, v: h / 2 + state.view.y * scale};
  if (picture?.width !== w || picture?.height !== h) {
    picture = pen.createImageData(w, h);
    pixels = new Uint32Array(picture.data.buffer);
  }
  pixels.fill(0);
  const edges = typical_size() * state.view.scale > 7;
  for (const half of halves)
    for (const [shade, group] of shades(f, visible, half)) {
      const ground = pixel(shade), edge = edges ? pixel(outline_on(shade)) : ground;
      for (const b of group) put_block(b, half, ground, edge);
    }
  if (state.forces) put_forces(force_lines(f, halves));
  pen.putImageData(picture, 0, 0);
  for (const half of halves) hatch_fixed(f, visible, half);
  if (state.cracks) draw_cracks(f, visible, halves);
  if (state.arrows) draw_arrows(f, visible, halves);
}

/// Draws contact forces: lines of one pixel with a rim of one pixel on both sides.
function put_forces(lines) {
  const shades = Array.from({length: force_steps + 1}, (_, k) => force_shade(k / force_steps));
  const inner = shades.map(pixel), rims = shades.map(rim_of_line).map(pixel), side = 1 / sheet.ratio;
  for (const [x0, y0, x1, y1, part] of lines) {
    const rim = rims[force_step(part)], is_flat = Math.abs(x1 - x0) > Math.abs(y1 - y0);
    const [u, v] = is_flat ? [0, side] : [side, 0];
    put_line(x0 - u, y0 - v, x1 - u, y1 - v, rim);
    put_line(x0 + u, y0 + v, x1 + u, y1 + v, rim);
  }
  for (const [x0, y0, x1, y1, part] of lines) put_line(x0, y0, x1, y1, inner[force_step(part)]);
}

/// Draws a line; its ends are in page pixels.
function put_line(x0, y0, x1, y1, colour) {
  const {w, h, ratio} = sheet;
  const n = Math.max(1, Math.ceil(ratio * Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0))));
  const dx = ratio * (x1 - x0) / n, dy = ratio * (y1 - y0) / n;
  for (let i = 0, x = ratio * x0, y = ratio * y0; i <= n; ++i, x += dx, y += dy)
    if (x >= 0 && y >= 0 && x < w && y < h) pixels[(y | 0) * w + (x | 0)] = colour;
}

/// Sets the pixels whose middle is inside, so that neighbours leave no gap. The leftmost pixel of
/// each row and the lowest row get the colour of the edge.
function put_block(b, corners, ground, edge) {
  const shape = shape_of(b, state.frame), first = 2 * data.first_corner[shape], end = 2 * data.first_corner[shape + 1];
  const {w, h, scale, u, v} = sheet;
  let low = Infinity, high = -Infinity;
  for (let i = first; i < end; i += 2) {
    const y = v - corners[i + 1] * scale;
    if (y < low) low = y;
    if (y > high) high = y;
  }
  if (end - first > crossings.length) crossings = new Float64Array(end - first);
  const last = Math.min(h, Math.ceil(high - 0.5));
  for (let row = Math.max(0, Math.ceil(low - 0.5)); row < last; ++row) {
    const y = (v - row - 0.5) / scale;  // model coordinate
    let n = 0;
    for (let i = first, j = end - 2; i < end; j = i, i += 2) {
      if ((corners[i + 1] > y) === (corners[j + 1] > y)) continue;
      let x = u + scale * (corners[i] + (y - corners[i + 1]) / (corners[j + 1] - corners[i + 1]) * (corners[j] - corners[i]));
      let k = n++;
      for (; k > 0 && crossings[k - 1] > x; --k) crossings[k] = crossings[k - 1];
      crossings[k] = x;
    }
    const inner = row === last - 1 ? edge : ground;
    for (let k = 0; k + 1 < n; k += 2) {
      const from = Math.max(0, Math.ceil(crossings[k] - 0.5)), to = Math.min(w, Math.ceil(crossings[k + 1] - 0.5));
      for (let at = row * w + from, stop = row * w + to; at < stop; ++at) pixels[at] = inner;
      if (from < to) pixels[row * w + from] = edge;
    }
  }
}
