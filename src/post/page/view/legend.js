// The legend of colours, drawn beside the model and on saved pictures. Its parts follow each other
// from top to bottom, or from left to right in a narrow window.

const key = $("key"), key_pen = key.getContext("2d");
const narrow_window = matchMedia("(max-width: 900px), (max-aspect-ratio: 9/10)");

function draw_colours() {
  const wide = !narrow_window.matches, parts = legend_parts(wide), room = key.clientWidth;
  const width = wide ? room : Math.min(140, (room + part_gap) / parts.length - part_gap);
  const height = wide ? legend_height(key_pen, parts, width)
    : Math.max(...parts.map((part) => part_height(key_pen, part, width)));
  key.style.height = `${height}px`;
  size_canvas(key, key_pen);
  if (wide) put_legend(key_pen, parts, 0, 0, key.clientWidth);
  else parts.forEach((part, i) => put_part(key_pen, part, i * (width + part_gap), 0, width));
}

/// Returns the parts of the legend: lists of swatches, colour bars, an arrow.
function legend_parts(wide) {
  const parts = [], bar = wide ? 190 : 60, ticks = wide ? 5 : 2;
  if (state.colour === "material")
    parts.push({title: "material", swatches: Object.entries(meta.materials).map(([number, shade]) =>
      ({name: material_name(number), shade}))});
  else if (state.colour === "family") parts.push(family_legend());
  else if (state.colour === "bond") parts.push(...bond_legend(bar, ticks));
  else {
    const q = colour_quantity(), [low, high] = colour_range(q), [least, most] = ranges[q.name];
    const marks = [...state.picked, hovered.block].filter((b) => b >= 0 && exists(b, state.frame));
    const colours = colours_of(q, [low, high]);
    if (least === 0 && most === 0)
      parts.push({title: `${q.label}${q.unit ? ` [${q.unit}]` : ""}`, swatches: [
        {name: "0 everywhere", shade: colours[Math.round(Math.max(0, -low / (high - low)) * (colours.length - 1))]}]});
    else parts.push({
      ...label_ticks(low, high, ticks, q.label, q.unit), low, high, bar, colours,
      is_cut: [least < low, most > high], marks: shows_faces() ? [] : marks.map((b) => value(q.name, b, state.frame))});
  }
  if (state.forces && meta.largest_force > 0) {
    const high = meta.largest_force * 10 ** (6 * (usual_force() / 255 - 1));
    parts.push({
      ...label_ticks(0, high, wide ? 4 : 2, "contact force", meta.force_unit), low: 0, high, bar: wide ? 110 : 60,
      colours: meta.intensity, is_cut: [false, high < meta.largest_force], marks: []});
  }
  if (state.arrows && full_arrow() > 0) parts.push(arrow_legend());
  const others = state.picked.map((b, i) => ({name: `block ${b + 1}`, ring: mark_colour(i)}));
  if (data.fixed.some((is) => is === 1)) others.push({name: "fixed", hatched: true});
  if (meta.planes && !state.mirror) others.push({name: "plane", shade: style("--ink"), line: true, dashes: []});
  if (meta.water_lines) others.push({name: "water table", shade: meta.water_colour, line: true, dashes: []});
  if (state.cracks && data.crack && !shows_sides())
    others.push({name: "crack", shade: meta.crack_colour, line: true, dashes: []});
  if (others.length) parts.push({swatches: others});
  return parts;
}

/// Breaks a title into lines of that width.
function lines_of(p, text = "", width) {
  const lines = [];
  p.font = font(12);
  for (const word of text.split(" ").filter(Boolean)) {
    const longer = lines.length ? `${lines.at(-1)} ${word}` : word;
    if (lines.length && p.measureText(longer).width <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
const line_height = 16, part_gap = 14;
const columns_of = ({swatches}) => swatches.length > 12 ? 3 : 1;
const part_height = (p, part, width) => line_height * lines_of(p, part.title, width).length
  + (part.bar ? part.bar + 24 : part.arrow ? 2 * line_height : line_height * Math.ceil(part.swatches.length / columns_of(part)) + 4);
const legend_height = (p, parts, width) =>
  parts.reduce((sum, part) => sum + part_height(p, part, width) + part_gap, 0);

function put_legend(p, parts, x, y, width) {
  for (const part of parts) {
    put_part(p, part, x, y, width);
    y += part_height(p, part, width) + part_gap;
  }
}
function put_part(p, part, x, y, width) {
  const lines = lines_of(p, part.title, width);
  p.fillStyle = style("--ink"); p.textAlign = "left"; p.textBaseline = "middle";
  for (const line of lines) { p.fillText(line, x, y + line_height / 2); y += line_height; }
  if (part.bar) put_bar(p, part, x, y + 12);
  else if (part.arrow) put_arrow_part(p, part, x, y + 2);
  else put_swatches(p, part, x, y + 2, width);
}

function put_swatches(p, part, x, y, width) {
  const columns = columns_of(part);
  part.swatches.forEach(({name, shade, ring, hatched, line, dashes}, i) => {
    const left = x + i % columns * width / columns, top = y + Math.floor(i / columns) * line_height;
    if (line) return put_line_swatch(p, name, shade, dashes, left, top);
    p.fillStyle = shade ?? style("--sheet");
    p.fillRect(left, top, 14, 11);
    p.strokeStyle = ring ?? (shade ? outline_on(shade) : style("--muted")); p.lineWidth = ring ? 2.5 : 1;
    p.beginPath();
    p.rect(left + 0.5, top + 0.5, 13, 10);
    for (let s = 4; hatched && s < 22; s += 5) {
      p.moveTo(left + Math.min(s, 14), top + Math.max(0, s - 14));
      p.lineTo(left + Math.max(0, s - 11), top + Math.min(s, 11));
    }
    p.stroke();
    p.fillStyle = style("--ink"); p.font = font(12); p.textAlign = "left"; p.textBaseline = "middle";
    p.fillText(name, left + 20, top + 6.5);
  });
}

function put_line_swatch(p, name, shade, dashes, left, top) {
  p.save();
  p.strokeStyle = shade; p.lineWidth = 3; p.setLineDash(dashes);
  p.beginPath(); p.moveTo(left, top + 6); p.lineTo(left + 14, top + 6); p.stroke();
  p.restore();
  p.fillStyle = style("--ink"); p.font = font(12); p.textAlign = "left"; p.textBaseline = "middle";
  p.fillText(name, left + 20, top + 6.5);
}

/// Draws a colour bar with its numbers. An end is pointed if values lie beyond it. Small triangles
/// mark the values of the picked blocks and of the block under the cursor.
function put_bar(p, {bar, colours, low, high, ticks, is_cut, marks}, x, y) {
  const w = 16, at = (v) => y + bar * (high - Math.max(low, Math.min(high, v))) / (high - low);
  colours.forEach((shade, i) => {
    p.fillStyle = shade;  // one rectangle for each colour overlaps the one below, so no gap is seen
    p.fillRect(x, y + bar * (1 - (i + 1) / colours.length), w, bar / colours.length + (i ? 1 : 0));
  });
  p.strokeStyle = style("--axis"); p.lineWidth = 1;
  p.strokeRect(x - 0.5, y - 0.5, w + 1, bar + 1);
  const tip = (is, edge, out, shade) => {
    if (!is) return;
    p.fillStyle = shade;
    p.beginPath(); p.moveTo(x, edge); p.lineTo(x + w / 2, edge + out); p.lineTo(x + w, edge); p.fill();
  };
  tip(is_cut[0], y + bar, 9, colours[0]);
  tip(is_cut[1], y, -9, colours.at(-1));
  p.fillStyle = style("--ink");
  p.font = font(11); p.textAlign = "left"; p.textBaseline = "middle";
  for (const [v, text] of ticks) {
    p.beginPath(); p.moveTo(x + w, at(v)); p.lineTo(x + w + 4, at(v)); p.stroke();
    p.fillText(text, x + w + 13, at(v));
  }
  for (const v of marks.filter((one) => one === one)) {
    p.beginPath();
    p.moveTo(x + w + 1, at(v)); p.lineTo(x + w + 10, at(v) - 4.5); p.lineTo(x + w + 10, at(v) + 4.5);
    p.fill();
  }
}
