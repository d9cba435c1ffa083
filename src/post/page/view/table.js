// The picked blocks: their numbers side by side, and which quantity the chart follows.

function set_picked(blocks, side = -1) {
  state.picked = blocks.filter((b, i) => b >= 0 && blocks.indexOf(b) === i);
  state.side = blocks[0] >= 0 ? side : -1;
  redraw();
}
const pick_first = (block, side) => set_picked([block], side);
/// Picks a block to compare with the first one; the same block again ends the comparison.
function pick_second(block) {
  const [first, second] = state.picked;
  if (block >= 0) set_picked(block === second ? [first] : [first ?? block, block], state.side);
}
/// Picks the next or previous block as the first one (i = 0), or as the one to compare (i = 1).
function pick_next(i, step) {
  const [first, second] = state.picked, from = (i ? second ?? first : first) ?? (step > 0 ? -1 : meta.blocks);
  const next = from + step === state.picked[1 - i] ? from + 2 * step : from + step;
  if (next < 0 || next >= meta.blocks) return;
  set_picked(i ? [first ?? next, next] : [next, second]);
}

/// Returns the rows of the table: of the whole model, or of the picked blocks.
const model_rows = () => [
  {name: "kinetic_energy", label: "kinetic energy", unit: meta.energy_unit, all: meta.kinetic_energy},
  {name: "contacts", label: "acting contacts", unit: "", all: meta.contacts},
  {name: "blocks", label: "blocks", unit: "", all: meta.present},
  ...(has_cracks() ? [{name: "cracks", label: "cracks", unit: "", all: meta.crack_counts}] : [])];
const rows = () => state.picked.length ? meta.quantities : model_rows();

/// Returns the texts of a row: one number, or two numbers and their difference.
function cells_of({name, all}) {
  const f = state.frame, {picked} = state;
  if (!picked.length) return [digits(all[f])];
  const texts = picked.map((b) => exists(b, f) ? text_of(name, b, f) : "NaN");
  return picked.length < 2 ? texts : [...texts, texts.includes("NaN") ? "NaN" : difference(name, picked, f)];
}

let columns_shown = -1;
function draw_numbers() {
  const list = rows(), body = $("numbers").tBodies[0], {picked} = state;
  if (columns_shown !== picked.length) make_rows(body, list);
  const followed = list.find(({name}) => name === state.followed) ?? list[0];
  list.forEach((entry, i) => {
    const row = body.rows[i];
    cells_of(entry).forEach((text, k) => row.cells[k + 1].textContent = shown(text));
    row.setAttribute("aria-selected", entry === followed);
    row.tabIndex = entry === followed ? 0 : -1;  // one stop of Tab; arrows reach the other rows
  });
  const heads = ["", ...picked.map((b) => `block ${b + 1}`), ...(picked.length > 1 ? ["difference"] : [])];
  $("heads").replaceChildren(...heads.map((text, k) => made("th", ["", "mark", "second", ""][k], text)));
  $("heads").hidden = !picked.length;
  $("numbers").classList.toggle("compared", picked.length > 1);
  $("block_name").textContent = picked.length === 0 ? "Whole model"
    : `Block${picked.length > 1 ? "s" : ""} ${picked.map((b) => b + 1).join(" and ")}`;
  $("block_about").replaceChildren(...about_picked().map((text) => made("span", "", text)));
  for (const [i, id] of ["first_block", "second_block"].entries())
    if (document.activeElement !== $(id)) $(id).value = picked[i] === undefined ? "" : picked[i] + 1;
  draw_chart(followed, picked.length
    ? picked.map((b, i) => ({all: history_of(followed.name, b), colour: mark_colour(i), dashes: i ? [6, 3] : []}))
    : [{all: followed.all, colour: style("--accent"), dashes: []}]);
}

function make_rows(body, list) {
  columns_shown = state.picked.length;
  body.replaceChildren(...list.map(({name, label, unit}) => {
    const row = document.createElement("tr");
    row.dataset.name = name;
    row.insertCell().append(label, made("small", "", unit ? ` [${unit}]` : ""));
    for (let k = 0; k < (columns_shown < 2 ? 1 : 3); ++k) row.insertCell();
    row.onclick = () => follow(name);
    return row;
  }));
}

function follow(name) { state.followed = name; redraw(); }
$("numbers").addEventListener("keydown", (event) => {
  const step = {ArrowUp: -1, ArrowDown: 1}[event.key], all = [...$("numbers").tBodies[0].rows];
  const next = all[all.indexOf(document.activeElement) + step];
  if (!next || event.shiftKey) return;
  event.preventDefault();
  follow(next.dataset.name);
  next.tabIndex = 0;
  next.focus();
});

/// Returns sentences about the picked blocks.
function about_picked() {
  const f = state.frame, {picked} = state;
  if (!picked.length)
    return ["Click a block to see its numbers. Click another one with Shift to compare them.", ...about_cracks(f)];
  const about = picked.map((b) => removed(b, f) ? `Block ${b + 1} is removed.`
    : !exists(b, f) ? `Block ${b + 1} does not exist yet.`
    : `Block ${b + 1}: ${material_of(b)}, ${corner_count(b)} corners`
      + `${data.fixed[f * meta.blocks + b] ? ", fixed" : ""}.`);
  about.push(...about_cracks(f), ...about_joints(f));
  if (picked.length < 2 || !picked.every((b) => exists(b, f))) return about;
  const [[x0, y0], [x1, y1]] = picked.map((b) => centre(b, f)), q = chosen();
  const distance = digits(Math.hypot(x1 - x0, y1 - y0), finest_place);
  return [...about, `Distance of the centroids: ${value_text(distance, meta.length_unit)}.`,
    `Difference of ${q.label}: ${value_text(difference(q.name, picked, f), q.unit)}.`];
}
