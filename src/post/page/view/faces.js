// Faces between blocks in the colours of their opening or shear displacement, and sides in those of
// the pressure of water, with the rules of sides.cpp. Pages without them do not show them.

/// Returns the quantity of the colours, of blocks or of faces; nothing for materials.
const face_quantity = (name) => (meta.face_quantities ?? []).find((q) => q.name === name);
const colour_quantity = () => quantity(state.colour) ?? face_quantity(state.colour);
const shows_faces = () => face_quantity(state.colour) !== undefined;
/// Whether the sides of blocks have colours, and blocks those of their materials.
const shows_sides = () => state.colour === "bond" || shows_faces();

/// The sides of the faces of a quantity: both, or the one that water presses.
const sides_of = (q) => q.name === "water_pressure" ? {sides: data.water_side, each: [0]} : {sides: data.face_side, each: [0, 1]};

/// Returns the places of both ends of one side of a face, in model lengths.
function face_ends({sides, each}, face, which) {
  const from = sides[each.length * face + which], to = corner_beside(from, 1);
  return [0, 1].map((end) => {
    const part = each.length === 1 ? data.water_part[2 * (state.frame * sides.length + face) + end]
      : data.face_part[4 * face + 2 * which + end];
    return [0, 1].map((axis) => corners[2 * from + axis] + part * (corners[2 * to + axis] - corners[2 * from + axis]));
  });
}

/// Draws the faces of the current frame, the largest values on top, and the outlines of blocks.
function draw_faces(f, visible, halves) {
  const q = face_quantity(state.colour), [low, high] = colour_range(q), colours = colours_of(q, [low, high]);
  const its = sides_of(q), count = its.sides.length / its.each.length, all = data[q.name], at = (face) => 2 * (f * count + face);
  const shade = (v) => colours[Math.round(Math.max(0, Math.min(1, (v - low) / (high - low))) * (colours.length - 1))];
  const size = (face) => Math.max(Math.abs(all[at(face)]), Math.abs(all[at(face) + 1]));
  const faces = [...Array(count).keys()].filter((face) => all[at(face)] === all[at(face)])
    .sort((a, b) => size(a) - size(b));
  const wide = Math.max(2, Math.min(6, 0.1 * typical_size() * state.view.scale)), steps = 8;
  pen.save();
  pen.lineWidth = wide;
  for (const half of halves) {
    const sign = half === corners || !q.odd ? 1 : -1, place = ([x, y]) => to_screen(half === corners ? x : 2 * meta.mirror - x, y);
    for (const face of faces)
      for (const which of its.each) {
        const [from, to] = face_ends(its, face, which).map(place), [a, b] = [sign * all[at(face)], sign * all[at(face) + 1]];
        if (Math.max(from[0], to[0]) < -wide || Math.min(from[0], to[0]) > model.clientWidth + wide
          || Math.max(from[1], to[1]) < -wide || Math.min(from[1], to[1]) > model.clientHeight + wide) continue;
        const shades = pen.createLinearGradient(...from, ...to);
        for (let i = 0; i <= steps; ++i) shades.addColorStop(i / steps, shade(a + i / steps * (b - a)));
        pen.strokeStyle = shades;
        pen.beginPath(); pen.moveTo(...from); pen.lineTo(...to); pen.stroke();
      }
    pen.strokeStyle = "#5c5c66"; pen.lineWidth = Math.min(0.7, 0.2 * wide);
    in_parts(visible, half, () => pen.stroke());
    pen.lineWidth = wide;
  }
  pen.restore();
}
