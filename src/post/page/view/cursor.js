// The cursor: its coordinates, and the block under it with its number, material and the value of
// the chosen quantity. The cursor is the pointer, or a crosshair in the middle of the view, which
// keys move over the model. Its marks have their own canvas, so that a motion of the pointer does
// not draw the model.

const over = $("over"), over_pen = over.getContext("2d");
let pointer_at = null;  // on the canvas of the model

const cursor_at = () => state.crosshair ? [model.clientWidth / 2, model.clientHeight / 2] : pointer_at;
const no_block = {block: -1, mirrored: false, side: -1};
let hovered = no_block;

/// Returns the quantity of the chart and of the cursor: that of the colours, if they show one.
const chosen = () => quantity(quantity(state.colour) ? state.colour : state.followed) ?? quantity("speed");

function draw_cursor() {
  const at = cursor_at(), before = hovered.block;
  hovered = at ? place_at(at) : no_block;
  size_canvas(over, over_pen);
  if (hovered.block >= 0)
    draw_outline(over_pen, hovered.block, [hovered.mirrored ? reflect(corners) : corners], style("--ink"), 1.5);
  if (hovered.side >= 0)
    draw_side(over_pen, hovered.block, hovered.side, [hovered.mirrored ? reflect(corners) : corners], style("--ink"));
  if (state.crosshair) draw_crosshair(...at);
  tell_place(at);
  tell_block(at);
  if (hovered.block !== before) draw_colours();  // the colour bar marks the value
}

function draw_crosshair(x, y) {
  for (const [colour, width] of [[style("--sheet"), 4], [style("--ink"), 1.5]]) {
    over_pen.strokeStyle = colour; over_pen.lineWidth = width;
    over_pen.beginPath();
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      over_pen.moveTo(x + 4 * dx, y + 4 * dy); over_pen.lineTo(x + 14 * dx, y + 14 * dy);
    }
    over_pen.stroke();
  }
}

/// Shows the coordinates, rounded to what a pixel can distinguish.
function tell_place(at) {
  if (!at) { $("place").textContent = ""; return; }
  const places = Math.max(0, Math.min(12, Math.ceil(Math.log10(state.view.scale)) + 1));
  const [x, y] = to_model(...at).map((v) => shown(v.toFixed(places)));
  $("place").textContent = measured(`x = ${x}   y = ${y}`, meta.length_unit);
}

/// Returns the block at a point of the canvas and its side there.
function place_at(at) {
  const found = block_at(at);
  return {...found, side: side_at(found.block, at, found.mirrored ? reflect(corners) : corners)};
}

/// Returns what is known of the block under the cursor: the block, and the value of the quantity,
/// and the joint of the side under the cursor.
function words_of({block, mirrored, side}) {
  const q = chosen(), f = state.frame, v = value(q.name, block, f);
  const text = mirrored ? digits(in_mirror(q, v)) : text_of(q.name, block, f);
  return [`Block ${block + 1}${mirrored ? ", mirrored" : ""}, ${material_of(block)}`,
    `${q.label} ${value_text(text, q.unit)}`,
    ...cracks_of(block, f),
    ...(side < 0 ? [] : [side_text(block, side), ...about_bonds(block, side)])];
}

function tell_block(at) {
  const tip = $("tip");
  tip.hidden = hovered.block < 0 || pointers.size > 0;
  if (tip.hidden) return;
  const [block, ...others] = words_of(hovered);
  tip.replaceChildren(made("b", "", block), ...others.map((text) => made("span", "", text)));
  const [x, y] = [at[0] + model.offsetLeft, at[1] + model.offsetTop], gap = 14, room = $("plot");
  const left = x + gap + tip.offsetWidth < room.clientWidth ? x + gap : x - gap - tip.offsetWidth;
  const top = y + gap + tip.offsetHeight < room.clientHeight ? y + gap : y - gap - tip.offsetHeight;
  tip.style.transform = `translate(${Math.max(2, left)}px, ${Math.max(2, top)}px)`;
}

const made = (kind, name, text = "") => {
  const part = document.createElement(kind);
  part.className = name;
  part.textContent = text;
  return part;
};
