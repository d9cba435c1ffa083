// Arrows of velocities and displacements, with the rules of arrows.cpp: the largest value has the
// full length, in the median over the frames, and short arrows are on top. Where the full length is
// typed, longer arrows are drawn at it. An arrow that leaves the picture ends at its frame, with an
// open head.

const arrow_kinds = {velocity: ["vx", "vy", "speed"], displacement: ["dx", "dy", "displacement"]};
const next_arrows = () => choose_arrows(next_in(["", ...Object.keys(arrow_kinds)], state.arrows, 1));

/// Returns the value of arrows of full length unless it is typed.
const usual_arrow = remembered((kind) => {
  const size = data[arrow_kinds[kind][2]], largest = meta.times.map((_, f) => {
    let most = 0;
    for (let b = 0; b < meta.counts[f]; ++b)
      if (exists(b, f) && size[f * meta.blocks + b] > most) most = size[f * meta.blocks + b];
    return most;
  }).filter((most) => most > 0).sort((a, b) => a - b);
  return largest[largest.length >> 1] ?? 0;
});
const full_arrow = () => state.full_arrows[state.arrows] ?? usual_arrow(state.arrows);
const arrow_length = () => Math.max(24, Math.min(90, 1.25 * typical_size() * state.view.scale));
const head_of = (length) => Math.min(0.4 * length, 9);

/// Returns the arrows of blocks on the page: the ends, the length of the head, and whether it is open.
function arrows_of(f, visible, halves) {
  const [along, up] = arrow_kinds[state.arrows], full = arrow_length(), factor = full / full_arrow();
  const is_typed = state.full_arrows[state.arrows] !== undefined, arrows = [];
  for (const half of halves)
    for (const b of visible) {
      let dx = factor * value(along, b, f), dy = -factor * value(up, b, f), length = Math.hypot(dx, dy);
      if (!(length >= 1.5 && length < Infinity)) continue;
      if (is_typed && length > full) { dx *= full / length; dy *= full / length; length = full; }
      const is_own = half === corners, [x, y] = centre(b, f), [px, py] = to_screen(is_own ? x : 2 * meta.mirror - x, y);
      arrows.push({x: px, y: py, dx: is_own ? dx : -dx, dy, length});
    }
  return arrows.sort((a, b) => b.length - a.length).map(arrow_inside).filter((one) => one);
}

/// Returns the part of an arrow that the picture shows, unless it is less than its head.
function arrow_inside({x, y, dx, dy, length}) {
  const edge = 2;
  let begin = 0, end = 1;
  for (const [from, way, size] of [[x, dx, model.clientWidth], [y, dy, model.clientHeight]]) {
    const ends = [edge, size - edge].map((limit) => (limit - from) / way);
    if (way === 0 && (from < edge || from > size - edge)) return null;
    if (way === 0) continue;
    begin = Math.max(begin, Math.min(...ends)); end = Math.min(end, Math.max(...ends));
  }
  const open = end < 1, head = open ? Math.max(7, head_of(length)) : head_of(length), left = (end - begin) * length;
  if (!(begin < end) || (!open && left < head)) return null;
  return {x0: x + begin * dx, y0: y + begin * dy, x1: x + end * dx, y1: y + end * dy,
    ux: dx / length, uy: dy / length, shaft: left > head, head, open};
}

function trace_shaft(p, {x0, y0, x1, y1, ux, uy, shaft, head}) {
  if (shaft) { p.moveTo(x0, y0); p.lineTo(x1 - head * ux, y1 - head * uy); }
}
function trace_head(p, {x1, y1, ux, uy, head}) {
  const x = x1 - head * ux, y = y1 - head * uy, side = 0.42 * head;
  p.moveTo(x1, y1); p.lineTo(x - side * uy, y + side * ux); p.lineTo(x + side * uy, y - side * ux); p.closePath();
}

/// Draws arrows in groups, because one path of many arrows is slow.
function put_arrows(p, arrows, shade, rim) {
  const paint = (some, traces, act) => {
    p.beginPath();
    for (const one of some) for (const trace of traces) trace(p, one);
    act();
  };
  const stroke = (colour, width) => () => { p.strokeStyle = colour; p.lineWidth = width; p.stroke(); };
  const fill = (colour) => () => { p.fillStyle = colour; p.fill(); };
  p.save();
  p.lineJoin = "miter";
  for (let i = 0; i < arrows.length; i += 32) {
    const some = arrows.slice(i, i + 32), open = some.filter((one) => one.open);
    if (rim) paint(some, [trace_shaft, trace_head], stroke(rim, 3.2));
    paint(some, [trace_shaft], stroke(shade, 1.3));
    paint(some.filter((one) => !one.open), [trace_head], fill(shade));
    paint(open, [trace_head], fill("#ffffff"));
    paint(open, [trace_head], stroke(shade, 1.1));
  }
  p.restore();
}
const draw_arrows = (f, visible, halves) =>
  full_arrow() > 0 && put_arrows(pen, arrows_of(f, visible, halves), "#29292e", "rgba(255, 255, 255, .75)");

/// Returns the part of the legend for arrows, and draws it.
function arrow_legend() {
  const {unit} = quantity(arrow_kinds[state.arrows][0]), is_typed = state.full_arrows[state.arrows] !== undefined;
  return {title: state.arrows, arrow: value_text(digits(Number(full_arrow().toPrecision(3))), unit),
    more: is_typed && ranges[arrow_kinds[state.arrows][2]][1] > full_arrow()};
}
function put_arrow_part(p, {arrow, more}, x, y) {
  const length = arrow_length(), head = head_of(length);
  put_arrows(p, [{x0: x, y0: y + 6, x1: x + length, y1: y + 6, ux: 1, uy: 0, shaft: true, head}], style("--ink"));
  p.fillStyle = style("--ink"); p.font = font(12);
  p.fillText(`${more ? "≥ " : ""}${arrow}`, x, y + 6 + line_height);
}

/// Shows the chosen arrows and the value of their full length in the controls.
function show_arrow_controls() {
  $("arrows").value = state.arrows;
  $("arrow_options").hidden = !state.arrows;
  if (!state.arrows) return;
  $("full_arrow").placeholder = digits(Number(usual_arrow(state.arrows).toPrecision(3)));
  $("full_arrow").value = state.full_arrows[state.arrows] ?? "";
}
function choose_arrows(kind) {
  state.arrows = kind;
  show_arrow_controls();
  redraw();
}
function type_full_arrow() {
  const typed = Number($("full_arrow").value);
  if (typed > 0) state.full_arrows[state.arrows] = typed;
  else delete state.full_arrows[state.arrows];
  choose_arrows(state.arrows);
}
