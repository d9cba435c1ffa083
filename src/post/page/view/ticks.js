// Round numbers for axes and colour bars, and their labels.

function nice_ticks(low, high, count) {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw)), digit = raw / power;
  const step = power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10), ticks = [];
  if (Math.max(Math.abs(low), Math.abs(high)) > 1e15 * step) return ticks;  // doubles are too coarse for the ticks
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * (high - low); ++k)
    ticks.push(k * step);
  return ticks;
}
const tick_text = (t) => {
  if (t === 0) return "0";
  const big = Math.abs(t) >= 1e6 || Math.abs(t) < 1e-4;
  return (big ? Number(t.toPrecision(4)).toExponential() : String(Number(t.toPrecision(6)))).replaceAll("-", "−");
};

/// Large and small numbers are shown in powers of ten, which are written with the unit.
const superscript = (n) => String(n).replace("-", "⁻").replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);
/// Returns the power for these ticks: if they are very large or small, or if that makes wide labels shorter.
function power_of(ticks) {
  const most = Math.max(...ticks.map(Math.abs)), power = most > 0 ? 3 * Math.floor(Math.log10(most) / 3 + 1e-9) : 0;
  const longest = (by) => Math.max(...ticks.map((t) => tick_text(t / 10 ** by).length));
  if (most >= 1e5 || (most > 0 && most < 1e-3)) return power;
  return longest(0) > 4 && longest(power) < longest(0) ? power : 0;
}
const titled = (label, unit, power) => with_unit(label, [power ? `10${superscript(power)}` : "", unit].filter(Boolean).join(" "));

/// Returns round numbers of an axis with their labels, and the title of the axis. If numbers differ
/// only in late digits, a round number is subtracted: y − 4000000 [m].
function label_ticks(low, high, count, name, unit) {
  const ticks = nice_ticks(low, high, count), step = ticks[1] - ticks[0];
  let offset = 0;
  if (Math.max(...ticks.map(Math.abs)) >= 1e5 * step) {
    const slack = 1e-6 * step;
    let unit = 10 ** Math.ceil(Math.log10(Math.max(...ticks.map(Math.abs))));
    do offset = Math.ceil((ticks[0] - slack) / unit) * unit;  // the number with the fewest digits
    while (offset > ticks.at(-1) + slack && (unit /= 10) > 1e-3 * step);
    offset = Number(offset.toPrecision(15));
  }
  // The difference carries the rounding error of the tick; round it off.
  const digit = 10 ** Math.floor(Math.log10(step) + 1e-3);
  const rest = (t) => offset ? Math.round((t - offset) / digit) * digit : t;
  const power = power_of(ticks.map(rest));
  const from = offset ? ` ${offset < 0 ? "+" : "−"} ${Math.abs(offset)}` : "";
  return {ticks: ticks.map((t) => [t, tick_text(rest(t) / 10 ** power)]), title: titled(name + from, unit, power)};
}
