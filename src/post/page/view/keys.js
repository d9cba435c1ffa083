// The keys of the page, and the help that lists them.

const commands = [
  {title: "Time"},
  {name: "space", help: "play or pause", keys: {" ": () => play(!state.playing)}},
  {name: "← →", help: "previous, next frame", keys: {
    ArrowLeft: () => show(state.frame - 1), ArrowRight: () => show(state.frame + 1)}},
  {name: "Home End", help: "first, last frame", keys: {Home: () => show(0), End: () => show(frames - 1)}},
  {title: "View"},
  {name: "+ −", help: "zoom in, zoom out; also the wheel or two fingers", keys: {
    "+": () => zoom(1.25), "=": () => zoom(1.25), "-": () => zoom(0.8)}},
  {name: "Shift ← → ↑ ↓", help: "move the view; also drag", keys: {
    "Shift ArrowLeft": () => pan(40, 0), "Shift ArrowRight": () => pan(-40, 0),
    "Shift ArrowUp": () => pan(0, 40), "Shift ArrowDown": () => pan(0, -40)}},
  {name: "F", help: "show everything", keys: {f: () => fit(), 0: () => fit()}},
  {name: "O C N M", help: "first state, contact forces, block numbers, mirror", keys: {
    o: () => toggle("original"), c: () => toggle("forces"), n: () => toggle("labels"),
    m: () => meta.mirror !== null && toggle("mirror")}},
  {name: "V", help: "next arrows", keys: {v: () => next_arrows()}},
  ...(meta.cracks ? [{name: "G", help: "the faces of cracks", keys: {g: () => toggle("cracks")}}] : []),
  {name: "T", help: "light or dark", keys: {t: () => other_theme()}},
  {title: "Blocks"},
  {name: ", .", help: "pick the previous, next block; also a click", keys: {
    ",": () => pick_next(0, -1), ".": () => pick_next(0, 1)}},
  {name: "< >", help: "the same for the block to compare; also a click with Shift", keys: {
    "<": () => pick_next(1, -1), ">": () => pick_next(1, 1)}},
  {name: "B", help: "type the number of a block", keys: {b: () => $("first_block").focus()}},
  {name: "X", help: "a crosshair in the middle that reads coordinates and blocks", keys: {
    x: () => toggle("crosshair")}},
  {name: "Enter", help: "pick the block at the crosshair, with Shift to compare", keys: {
    Enter: () => pick_at_crosshair(false), "Shift Enter": () => pick_at_crosshair(true)}},
  {name: "Esc", help: "pick no block; leave a field", keys: {Escape: () => pick_first(-1)}},
  {title: "Colours"},
  {name: "[ ]", help: "colour by the previous, next quantity", keys: {
    "[": () => next_colour(-1), "]": () => next_colour(1)}},
  {name: "K", help: "next colour map", keys: {k: () => next_map()}},
  {name: "R A", help: "type the range, automatic range", keys: {
    r: () => colour_quantity() && $("low").focus(), a: () => automatic()}},
  {title: "Save"},
  {name: "P", help: "the picture", keys: {p: () => save_picture()}},
  {name: "S H", help: "the numbers of this frame, the histories", keys: {
    s: () => save_frame(), h: () => save_history()}},
  {title: "Help"},
  {name: "?", help: "these keys", keys: {"?": () => $("keys").showModal()}},
  {name: "Tab ↑ ↓", help: "all controls; choose in a menu or in the table", keys: {}},
];
const actions = Object.assign({}, ...commands.map(({keys}) => keys));

const pick_at_crosshair = (is_second) => state.crosshair && pick(hovered, is_second);

/// A key keeps its meaning in every control, except where the control needs it: a field takes all
/// keys until Enter or Esc, a button takes the space bar, a menu takes the keys that choose in it.
function belongs_to(control, event) {
  if (/^Arrow(Up|Down)$/.test(event.key)) return control.matches("select, input[type=range]");
  if (event.key === "Enter" && control.matches("select")) return true;
  return control.matches("button, input[type=checkbox]") && (event.key === " " || event.key === "Enter");
}

addEventListener("keydown", (event) => {
  const control = event.target;
  const is_for_page = !event.ctrlKey && !event.metaKey && !event.altKey && !event.defaultPrevented;
  if (!is_for_page || !state.ready || $("keys").open) return;
  if (control.matches("input[type=number]")) {
    if (event.key === "Enter" || event.key === "Escape") model.focus();  // a changed field acts when it is left
    return;
  }
  if (belongs_to(control, event)) return;
  const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const action = (event.shiftKey && actions[`Shift ${name}`]) || actions[name];
  if (action) { event.preventDefault(); action(); }
});

function list_keys() {
  let group = null;
  for (const {title, name, help} of commands) {
    if (title) {
      group = made("dl", "");
      $("key_list").append(made("h3", "", title), group);
    } else group.append(made("dt", "", name), made("dd", "", help));
  }
}
$("help").onclick = () => $("keys").showModal();
$("keys").addEventListener("close", () => by_pointer && model.focus());
