// Draws contact forces as lines through the contacts. A rim, dark beside a pale line and white
// beside a dark one, shows them on blocks of any colour.

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
const force_step = (part) => Math.round(Math.min(1, part) * force_steps);
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
  for (const line of force_lines(f, halves)) groups[force_step(line[4])].push(line);
  const paint = (lines, colour, width) => {
    pen.strokeStyle = colour; pen.lineWidth = width;
    for (let i = 0; i < lines.length; i += 64) {
      pen.beginPath();
      for (const [x0, y0, x1, y1] of lines.slice(i, i + 64)) { pen.moveTo(x0, y0); pen.lineTo(x1, y1); }
      pen.stroke();
    }
  };
  pen.lineCap = full > 10 ? "round" : "butt";
  const width_of = (part) => Math.max(0.6, Math.min(1, full / 12) * (0.8 + 3.2 * part));
  for (const is_rim of [true, false])
    groups.forEach((lines, k) => {
      const shade = force_shade(k / force_steps), width = width_of(k / force_steps);
      if (is_rim) paint(lines, rim_of_line(shade), width + Math.min(1.4, 0.3 + 0.7 * width));
      else paint(lines, shade, width);
    });
  pen.lineCap = "butt";
}
