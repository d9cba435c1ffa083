// The faces of blocks whose contacts have the law of a joint: their bond, slip and stress. Pages of
// runs without such laws do not show them. The parts of faces are those of joint_faces.cpp.

const bond_words = ["bonded", "weakened", "failed", "intact"];
const has_failed = (bond) => bond === 1 || bond === 2;

/// Returns the colour of a failed face, which has slipped by a part of the largest slip, 0 to 1.
const slip_shade = (part) => meta.slip_colours[Math.round(Math.min(1, part) * (meta.slip_colours.length - 1))];
const bond_shade = (bond, slip) =>
  has_failed(bond) ? slip_shade(meta.largest_slip > 0 ? Math.abs(slip) / meta.largest_slip : 0) : meta.bonded_colour;

let first_bond = null;
/// Returns the range of the contacts of a frame in the arrays.
function bonds_of(f) {
  if (!first_bond) {
    first_bond = new Uint32Array(frames + 1);
    data.bond_counts.forEach((count, i) => first_bond[i + 1] = first_bond[i] + count);
  }
  return [first_bond[f], first_bond[f + 1]];
}

const owner_of = (corner) => {  // the shape of a corner, by bisection
  let low = 0, high = data.corners.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (data.first_corner[middle] <= corner) low = middle; else high = middle - 1;
  }
  return low;
};
const corner_beside = (corner, step) => {
  const s = owner_of(corner), first = data.first_corner[s], n = data.corners[s];
  return first + (corner - first + step + n) % n;
};

/// Returns the parts of faces of the current frame: the contact, the own side of its corner (its
/// first corner), and the ends, in model lengths.
let parts_known = {f: -1, parts: []};
function face_parts() {
  const f = state.frame;
  if (parts_known.f === f) return parts_known.parts;
  const parts = [], [begin, end] = bonds_of(f), at = (c) => [corners[2 * c], corners[2 * c + 1]];
  for (let i = begin; i < end; ++i) {
    const c = data.bond_corner[i], e = data.bond_edge[i];
    const [cx, cy] = at(c), [sx, sy] = at(e), [ex, ey] = at(corner_beside(e, 1));
    const length = Math.hypot(ex - sx, ey - sy), ux = (ex - sx) / length, uy = (ey - sy) / length;
    const along = (x, y) => Math.max(0, Math.min(length, (x - sx) * ux + (y - sy) * uy));
    for (const step of [-1, 1]) {
      const [nx, ny] = at(corner_beside(c, step)), dx = step * (nx - cx), dy = step * (ny - cy);
      if ((dx * ux + dy * uy) / Math.hypot(dx, dy) > -0.95) continue;
      const foot = along(cx, cy), middle = 0.5 * (foot + along(nx, ny));
      parts.push({i, own: step < 0 ? corner_beside(c, -1) : c, edge: e,
        from: [sx + foot * ux, sy + foot * uy], to: [sx + middle * ux, sy + middle * uy]});
    }
  }
  const slipped = ({i}) => has_failed(data.bond_state[i]) ? 1 + Math.abs(data.bond_slip[i]) : 0;
  parts.sort((a, b) => slipped(a) - slipped(b));
  parts_known = {f, parts};
  return parts;
}

/// Draws the faces in the colours of their bonds.
function draw_bonds(halves) {
  const width = Math.max(1, Math.min(4, 0.07 * typical_size() * state.view.scale));
  pen.save();
  pen.lineCap = "round";
  for (const half of halves) {
    const place = ([x, y]) => to_screen(half === corners ? x : 2 * meta.mirror - x, y);
    for (const {i, from, to} of face_parts()) {
      pen.beginPath(); pen.moveTo(...place(from)); pen.lineTo(...place(to));
      pen.setLineDash(data.bond_state[i] === 1 ? [5, 4] : []);
      pen.strokeStyle = bond_shade(data.bond_state[i], data.bond_slip[i]); pen.lineWidth = width;
      pen.stroke();
    }
  }
  pen.restore();
}

/// Returns what is known of the faces on side i of a block: the bonds of their contacts, the mean
/// stresses, the mean slip and dilation; nothing without contacts.
function about_bonds(block, side) {
  if (!meta.slip_colours) return [];
  const first = data.first_corner[shape_of(block, state.frame)] + side;
  const contacts = new Set(face_parts().filter(({own, edge}) => own === first || edge === first).map(({i}) => i));
  if (!contacts.size) return [];
  const sum = (values) => [...contacts].reduce((total, i) => total + values[i], 0);
  const counts = bond_words.map((word, bond) => [word, [...contacts].filter((i) => data.bond_state[i] === bond).length])
    .filter(([, count]) => count);
  const bonds = counts.length === 1 ? counts[0][0] : counts.map(([word, count]) => `${count} ${word}`).join(", ");
  const length = sum(data.bond_length), n = contacts.size;
  const number = (value, unit) => value_text(digits(Number(value.toPrecision(3))), unit);
  return [`${bonds}, slip ${number(sum(data.bond_slip) / n, meta.length_unit)}`
    + `, dilation ${number(sum(data.bond_dilation) / n, meta.length_unit)}`,
    ...(length > 0 ? [`normal stress ${number(sum(data.bond_normal) / length, meta.stress_unit)}`
      + `, shear ${number(sum(data.bond_shear) / length, meta.stress_unit)}`] : [])];
}

/// Returns the parts of the legend that explain the faces.
function bond_legend(bar, ticks) {
  const present = [0, 1, 2, 3].filter((bond) => data.bond_state.includes(bond)), most = meta.largest_slip;
  const parts = [{title: "bond", swatches: present.map((bond) => ({
    name: bond_words[bond], line: true, dashes: bond === 1 ? [5, 3] : [],
    shade: has_failed(bond) ? slip_shade(most > 0 ? 0.5 : 0) : meta.bonded_colour}))}];
  if (most > 0)
    parts.push({...label_ticks(0, most, ticks, "slip", meta.length_unit), low: 0, high: most, bar,
      colours: meta.slip_colours, is_cut: [false, false], marks: []});
  return parts;
}
