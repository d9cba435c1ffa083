// The sides of blocks and their joints: the side under the cursor, the picked side, and what is
// known of them. Pages of runs without joint ids and laws of joints do not show sides.

const reach = 10;  // pixels; the cursor is at a side of its block within this distance

/// Returns the first corner of a block in the current frame, and the number of its corners.
const first_corner_of = (block) => data.first_corner[shape_of(block, state.frame)];
const corner_count = (block) => data.corners[shape_of(block, state.frame)];
/// Returns the joint id of side i of a block; sides count from 0 here and from 1 in texts.
const joint_of = (block, i) => meta.joints[data.joint[first_corner_of(block) + i]];
const joint_text = (id) => id ? `joint ${id}` : "no joint";
const has_sides = () => meta.joints !== undefined || meta.slip_colours !== undefined;
const side_text = (block, i) => `side ${i + 1}` + (meta.joints ? `: ${joint_text(joint_of(block, i))}` : "");

/// Returns the ends of a side on the canvas.
function ends_of(block, i, half) {
  const n = corner_count(block), first = first_corner_of(block);
  return [i, (i + 1) % n].map((k) => to_screen(half[2 * (first + k)], half[2 * (first + k) + 1]));
}

/// Returns the side of a block at a point of the canvas, or -1.
function side_at(block, [px, py], half) {
  let best = -1, least = reach;
  for (let i = 0; has_sides() && block >= 0 && i < corner_count(block); ++i) {
    const [[x0, y0], [x1, y1]] = ends_of(block, i, half), dx = x1 - x0, dy = y1 - y0;
    const part = Math.min(1, Math.max(0, ((px - x0) * dx + (py - y0) * dy) / (dx * dx + dy * dy || 1)));
    const distance = Math.hypot(x0 + part * dx - px, y0 + part * dy - py);
    if (distance < least) [best, least] = [i, distance];
  }
  return best;
}

/// Draws a side with a rim, so that it is visible on every colour.
function draw_side(its_pen, block, i, halves, colour) {
  its_pen.save();
  its_pen.lineCap = "round";
  for (const [shade, width] of [[style("--sheet"), 9], [colour, 5]]) {
    its_pen.beginPath();
    for (const half of halves) {
      const [from, to] = ends_of(block, i, half);
      its_pen.moveTo(...from); its_pen.lineTo(...to);
    }
    its_pen.strokeStyle = shade; its_pen.lineWidth = width; its_pen.stroke();
  }
  its_pen.restore();
}
/// Whether the first picked block has the picked side; a block that splits may lose it.
const has_picked_side = (f) => {
  const [block] = state.picked;
  return state.side >= 0 && exists(block, f) && state.side < corner_count(block);
};
function draw_picked_side(f, halves) {
  const [block] = state.picked;
  if (has_picked_side(f)) draw_side(pen, block, state.side, halves, mark_colour(0));
}

/// Returns sentences about the joints of the first picked block and about its picked side.
function about_joints(f) {
  const [block] = state.picked;
  if (!has_sides() || block === undefined || !exists(block, f)) return [];
  if (!has_picked_side(f) && !meta.joints) return ["Click a side to see its bond."];
  if (!has_picked_side(f)) return [`Joints of block ${block + 1}: ${joints_around(block)}. Click a side to see its joint.`];
  const first = first_corner_of(block), n = corner_count(block), i = state.side;
  const [from, to] = [first + i, first + (i + 1) % n];
  const [dx, dy] = [0, 1].map((axis) => corners[2 * to + axis] - corners[2 * from + axis]);
  const angle = Math.atan2(dy, dx) * 180 / Math.PI, direction = Math.round(10 * (angle < 0 ? angle + 180 : angle)) / 10 % 180;
  const length = Number(Math.hypot(dx, dy).toPrecision(4));
  const whose = state.picked.length > 1 ? ` of block ${block + 1}` : "";
  return [`Side ${i + 1}${whose}: ${meta.joints ? `${joint_text(joint_of(block, i))}, ` : ""}`
    + `${value_text(digits(length), meta.length_unit)} long, at ${direction}°.`,
    ...about_bonds(block, i).map((text) => `${text[0].toUpperCase()}${text.slice(1)}.`)];
}
/// Returns the joints of a block: "1, 2".
function joints_around(block) {
  const all = new Set(Array.from({length: corner_count(block)}, (_, i) => joint_of(block, i)));
  return [...all].filter((id) => id).sort((a, b) => a - b).join(", ") || "none";
}
