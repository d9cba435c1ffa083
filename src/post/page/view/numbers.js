// The numbers of blocks: values, their text with the digits of the file, and their ranges.

const quantity = (name) => meta.quantities.find((q) => q.name === name);
const value = (name, block, frame) => data[name][frame * meta.blocks + block];
const removed = (block, frame) => data.fixed[frame * meta.blocks + block] === 2;
const exists = (block, frame) => block < meta.counts[frame] && !removed(block, frame);
/// Returns the values of a block in all frames; NaN where the block does not exist yet or is removed.
const history_of = (name, block) => meta.times.map((_, f) => exists(block, f) ? value(name, block, f) : NaN);

/// Formats a number with six digits, as in the file (told), or with more digits, down to `finest`.
/// Trailing zeros are removed.
const digits = (told, finest = Infinity, sharp = told) => {
  const size = Math.abs(sharp), more = Math.floor(Math.log10(size)) - Math.round(Math.log10(finest)) + 1;
  const many = size > 0 ? Math.max(6, Math.min(15, more)) : 6;
  const number = many > 6 ? sharp : told;
  return size !== 0 && (size < 1e-3 || size >= 10 ** Math.max(7, many))
    ? number.toExponential(many - 1).replace(/\.?0+e/, "e").replace("e+", "e")
    : String(Number(number.toPrecision(many)));
};
/// Returns the text of a value, for files.
const text_of = (name, b, f) => is_place(name)
  ? digits(data[`told_${name}`][f * meta.blocks + b], finest_place, value(name, b, f)) : digits(value(name, b, f));
/// Returns a text for people: a true minus sign, and a dash for what is not a number.
const shown = (text) => text === "NaN" ? "–" : text.replaceAll("-", "−");

/// Returns the text of the difference of a value between two blocks. It is rounded to the digits
/// of the larger value, because the other digits would be noise.
function difference(name, [a, b], f) {
  const [from, to] = [value(name, a, f), value(name, b, f)], most = Math.max(Math.abs(from), Math.abs(to));
  if (!(most > 0 && most < Infinity)) return String(to - from);
  const finest = is_place(name) ? finest_place : 10 ** (Math.floor(Math.log10(most)) - 5);
  return digits(Number((Math.round((to - from) / finest) * finest).toPrecision(12)));
}

/// Coordinates are shown with the decimals of a six-digit number as large as the model, wherever
/// the model is.
const is_place = (name) => name === "x" || name === "y";
let finest_place = Infinity;
function find_finest_place() {
  const widths = ["x", "y"].map((name) => ranges[name][1] - ranges[name][0]);
  const extent = data.size.reduce((most, size) => Math.max(most, size), Math.max(...widths));
  if (extent > 0) finest_place = 10 ** (Math.floor(Math.log10(extent)) - 5);
}

const counted = (n, thing) => `${n} ${thing}${n === 1 ? "" : "s"}`;
const with_unit = (text, unit) => unit ? `${text} [${unit}]` : text;
/// Returns the text of a value with its unit, or with its dimension if the units are not known.
const value_text = (text, unit) => meta.units_known ? measured(shown(text), unit) : with_unit(shown(text), unit);
/// Returns a number with its unit; nothing follows the number if the units are not known.
const measured = (text, unit) => meta.units_known && unit ? `${text} ${unit}` : text;
const time_text = () => measured(`t = ${Number(meta.times[state.frame].toPrecision(4))}`, meta.time_unit);

/// The least and the largest value of each quantity over all frames, also of the mirrored blocks.
let ranges = {};
function find_ranges() {
  const across = (q, least, most) => {  // with the mirrored ones
    const ends = [least, most, ...(meta.mirror !== null ? [in_mirror(q, least), in_mirror(q, most)] : [])];
    ranges[q.name] = least <= most ? [Math.min(...ends), Math.max(...ends)] : [0, 0];
  };
  for (const q of meta.face_quantities ?? []) {
    let low = Infinity, high = -Infinity;
    for (const v of data[q.name]) {
      if (v < low) low = v;
      if (v > high) high = v;
    }
    across(q, q.name === "water_pressure" ? 0 : low, high);
  }
  for (const q of meta.quantities) {
    let low = Infinity, high = -Infinity;
    for (let f = 0; f < frames; ++f)
      for (let b = 0, i = f * meta.blocks; b < meta.counts[f]; ++b, ++i) {
        const v = data[q.name][i];
        if (v < low) low = v;
        if (v > high) high = v;
      }
    across(q, low, high);
  }
}
/// Returns the value of the mirrored block; odd quantities change their sign.
const in_mirror = (q, v) => q.name === "x" ? 2 * meta.mirror - v : q.odd ? -v : v;
