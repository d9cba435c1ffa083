// Fills the page when its data are unpacked.

async function begin() {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  set_theme(dark.matches ? "dark" : "light");
  dark.addEventListener("change", () => set_theme(dark.matches ? "dark" : "light"));
  document.title = $("title").textContent = meta.title || "BLOCKS";
  $("about").textContent = `${meta.file} · ${counted(meta.blocks, "block")} · ${counted(frames, "frame")}`;
  $("scrub").max = frames - 1;
  $("mirror").checked = state.mirror;
  $("cracks").checked = state.cracks;
  $("cracks").parentElement.hidden = !has_cracks();
  $("mirror").parentElement.hidden = meta.mirror === null;
  $("first_block").max = $("second_block").max = meta.blocks;
  $("colour").add(new Option("material", "material"));
  if (has_cracks()) $("colour").add(new Option("pieces by block", "family"));
  if (meta.slip_colours) $("colour").add(new Option("bond of joints", "bond"));
  for (const q of [...(meta.face_quantities ?? []), ...meta.quantities]) $("colour").add(new Option(with_unit(q.label, q.unit), q.name));
  $("map").add(new Option("automatic", ""));
  for (const [name, {diverging}] of Object.entries(meta.maps))
    $("map").add(new Option(diverging ? `${name} (centred on 0)` : name, name));
  list_keys();
  await unpack();
  find_ranges();
  find_finest_place();
  corners = new Float64Array(2 * data.first_corner.at(-1));
  state.ready = true;
  $("message").textContent = "";
  show_colour_controls();
  fit();
  new ResizeObserver(() => state.fitted ? fit() : redraw()).observe(model);
  document.documentElement.dataset.ready = "yes";
}
begin().catch((fault) => { $("message").textContent = fault.message; });
