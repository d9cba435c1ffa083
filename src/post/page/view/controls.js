// The menus, boxes and buttons of the page. After a click in one of them, the model has the keys
// again, so that the space bar plays.

function colour_by(name) {
  state.colour = name;
  if (quantity(name)) state.followed = name;
  show_colour_controls();
  redraw();
}
/// The name of the colours of bonds, on pages that show them.
const bond_colour = () => meta.slip_colours ? ["bond"] : [];
const face_colours = () => (meta.face_quantities ?? []).map(({name}) => name);
const colour_names = () => ["material", ...(has_cracks() ? ["family"] : []), ...bond_colour(), ...face_colours(), ...meta.quantities.map(({name}) => name)];
const map_names = () => ["", ...Object.keys(meta.maps)];
const next_in = (list, now, step) => list[(list.indexOf(now) + step + list.length) % list.length];
const next_colour = (step) => colour_by(next_in(colour_names(), state.colour, step));
function use_map(name) { state.map = name; show_colour_controls(); redraw(); }
const next_map = () => colour_quantity() && use_map(next_in(map_names(), state.map, 1));

/// Shows map and range of the colours; an empty end of the range shows its automatic value.
function show_colour_controls() {
  const q = colour_quantity();
  $("colour").value = state.colour;
  $("map").value = state.map;
  $("colour_options").hidden = !q;
  if (!q) return;
  $("map").options[0].text = `automatic (${q.map})`;
  const typed = state.typed[q.name] ?? [null, null];
  $("automatic").disabled = typed.every((end) => end === null);
  ["low", "high"].forEach((id, i) => {
    $(id).placeholder = digits(Number(automatic_range(q)[i].toPrecision(4)));
    $(id).value = typed[i] ?? "";
    $(id).setCustomValidity("");
  });
}
/// Takes the typed range, unless it is empty or upside down.
function type_range() {
  const q = colour_quantity();
  const typed = ["low", "high"].map((id) => $(id).value === "" ? null : Number($(id).value));
  const [low, high] = automatic_range(q), is_good = (typed[0] ?? low) < (typed[1] ?? high);
  const fault = is_good ? "" : "The range must begin below its end.";
  for (const id of ["low", "high"]) $(id).setCustomValidity(fault);
  if (is_good) { state.typed[q.name] = typed; show_colour_controls(); redraw(); }
  else $("high").reportValidity();
}
function automatic() {
  delete state.typed[state.colour];
  show_colour_controls();
  redraw();
}

function turn(name, on) {
  state[name] = on;
  if ($(name)) $(name).checked = on;
  redraw();
}
const toggle = (name) => turn(name, !state[name]);
function set_theme(name) { document.documentElement.dataset.theme = name; redraw(); }
const other_theme = () => set_theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");

$("colour").onchange = (event) => colour_by(event.target.value);
$("map").onchange = (event) => use_map(event.target.value);
for (const id of ["low", "high"]) $(id).onchange = type_range;
$("automatic").onclick = automatic;
for (const name of ["reversed", "original", "forces", "cracks", "labels", "mirror"])
  $(name).onchange = (event) => turn(name, event.target.checked);
$("arrows").onchange = (event) => choose_arrows(event.target.value);
$("full_arrow").onchange = type_full_arrow;
$("fit").onclick = fit;
$("theme").onclick = other_theme;
/// Returns the block whose number is in a field, or -1.
const block_typed = (id) => {
  const number = Number($(id).value);
  return Number.isInteger(number) && number >= 1 && number <= meta.blocks ? number - 1 : -1;
};
$("first_block").onchange = () => set_picked([block_typed("first_block"), state.picked[1]]);
$("second_block").onchange = () => set_picked([state.picked[0], block_typed("second_block")]);

let by_pointer = false;
addEventListener("pointerdown", () => by_pointer = true, true);
addEventListener("keydown", () => by_pointer = false, true);
function give_keys_to_model() {
  if (by_pointer && !$("keys").open) model.focus();
}
for (const control of document.querySelectorAll("main select, footer select, input[type=range]"))
  control.addEventListener("change", give_keys_to_model);
for (const control of document.querySelectorAll("button, input[type=checkbox], input[type=range]"))
  control.addEventListener("click", give_keys_to_model);
