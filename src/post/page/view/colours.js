// Colours of blocks: by material, or by the chosen quantity on a colour map. Outlines and rims are
// visible on every colour; they have the rules of colour_map.cpp.

/// Returns the colours of the chosen map for a quantity, and whether its middle means zero.
function colour_map(q) {
  const {diverging, colours} = meta.maps[state.map || q.map];
  return {diverging, colours: state.reversed ? [...colours].reverse() : colours};
}

/// Returns the range over all frames. It includes zero, which is the middle of a diverging map. The
/// rules are those of ScaleSurvey::colours.
function automatic_range(q) {
  let [low, high] = ranges[q.name];
  if (colour_map(q).diverging) {  // values of one sign need only half of the colours
    const most = Math.max(Math.abs(low), Math.abs(high));
    const lopsided = low < 0 && high > 0 && Math.min(-low, high) < 0.1 * most;
    if (!lopsided) [low, high] = [low < 0 ? -most : 0, high > 0 ? most : 0];
  }
  else if (!is_place(q.name)) low = Math.min(low, 0);
  return high > low ? [low, high] : colour_map(q).diverging ? [-1, 1] : [low, low + 1];
}
/// Returns the range with the typed ends.
function colour_range(q) {
  const [low, high] = automatic_range(q), typed = state.typed[q.name] ?? [null, null];
  return [typed[0] ?? low, typed[1] ?? high];
}

/// Returns the colours of a range. Those of a diverging map are a part of it in which zero keeps the
/// colour in the middle; for a range of one sign it is the half of that sign.
function colours_of(q, [low, high]) {
  const {diverging, colours} = colour_map(q), middle = (colours.length - 1) / 2;
  if (!diverging || !(low < high)) return colours;
  const end = (value) => Math.round(middle * (1 + value / Math.max(-low, high)));
  return colours.slice(low < 0 ? end(low) : middle, (high > 0 ? end(high) : middle) + 1);
}

/// Returns a function that gives the colour of a block of that half in that frame.
function shades_at(f, half) {
  if (state.colour === "material") return (b) => meta.materials[meta.material[b]];
  if (state.colour === "family") return (b) => meta.family_colours[family_of(b, f)];
  if (shows_sides()) return (b) => mixed(meta.materials[meta.material[b]], 1, 0.3);
  const q = quantity(state.colour), [low, high] = colour_range(q), colours = colours_of(q, [low, high]);
  const last = colours.length - 1, seen = half === corners ? (v) => v : (v) => in_mirror(q, v);
  return (b) => {
    const part = (seen(value(q.name, b, f)) - low) / (high - low);
    return colours[part > 0 ? Math.round(Math.min(1, part) * last) : 0];  // NaN has the first colour
  };
}
/// Groups the visible blocks of one half by colour.
function shades(f, visible, half) {
  const groups = new Map(), shade_of = shades_at(f, half);
  for (const b of visible) {
    const shade = shade_of(b);
    groups.has(shade) ? groups.get(shade).push(b) : groups.set(shade, [b]);
  }
  return groups;
}

const channels = (shade) => [1, 3, 5].map((i) => parseInt(shade.slice(i, i + 2), 16) / 255);
const hex = (parts) => "#" + parts.map((part) => Math.round(255 * part).toString(16).padStart(2, "0")).join("");
const remembered = (make) => {
  const known = new Map();
  return (key) => known.get(key) ?? known.set(key, make(key)).get(key);
};
/// Returns the relative luminance of sRGB, 0 for black to 1 for white.
const luminance = remembered((shade) => {
  const [r, g, b] = channels(shade).map((s) => s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
});
/// True if white is easier to see on the colour than black.
const is_dark = (shade) => luminance(shade) < 0.179;
const mixed = (shade, other, share) => hex(channels(shade).map((part) => share * part + (1 - share) * other));
const strong_outline = remembered((ground) => is_dark(ground) ? mixed(ground, 1, 0.4) : mixed(ground, 0, 0.3));
const faint_outline = remembered((ground) => is_dark(ground) ? mixed(ground, 1, 0.7) : mixed(ground, 0, 0.65));
/// Returns the colour of an outline on a ground; it is faint under contact forces and sides.
const outline_on = (ground) => state.forces || shows_sides() ? faint_outline(ground) : strong_outline(ground);
/// Returns the colour of the rim of a line, which has a high contrast to the line.
const rim_of_line = (line) => luminance(line) > 0.2 ? "#29292e" : "#ffffff";
