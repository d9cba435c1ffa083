// The cracks of blocks: their faces where they are now, and which blocks have split off which.
// Pages of runs without cracks do not show them.

const has_cracks = () => meta.cracks !== undefined;
/// Returns the cracks up to a frame.
const cracks_until = (f) => has_cracks() ? meta.cracks.slice(0, meta.crack_counts[f]) : [];

/// Draws the faces of cracks with a rim, so that they are visible on every colour.
function draw_cracks(f, visible, halves) {
  if (!data.crack || shows_sides()) return;
  const width = Math.max(1.2, Math.min(2.6, 0.05 * typical_size() * state.view.scale)), faces = [];
  for (const b of visible) {
    const first = data.first_corner[shape_of(b, f)], n = data.corners[shape_of(b, f)];
    for (let k = 0; k < n; ++k) if (data.crack[first + k]) faces.push([first + k, first + (k + 1) % n]);
  }
  pen.save();
  pen.lineCap = "round";
  for (const [shade, thick] of [["rgba(255, 255, 255, .8)", width + 1.4], [meta.crack_colour, width]]) {
    pen.strokeStyle = shade; pen.lineWidth = thick;
    for (const half of halves)
      for (let i = 0; i < faces.length; i += 64) {
        pen.beginPath();
        for (const [from, to] of faces.slice(i, i + 64)) {
          pen.moveTo(...to_screen(half[2 * from], half[2 * from + 1]));
          pen.lineTo(...to_screen(half[2 * to], half[2 * to + 1]));
        }
        pen.stroke();
      }
  }
  pen.restore();
}

/// Returns the block of the deck that a piece came from, from 1; 0 for a whole block.
let families_known = {f: -1, of: null};
function family_of(block, f) {
  if (families_known.f !== f) {
    const split = new Set(cracks_until(f).flatMap(({parent, child}) => [parent, child]));
    families_known = {f, of: meta.families.map((family, b) => split.has(b) ? family : 0)};
  }
  return families_known.of[block];
}
/// Returns the part of the legend that explains the colours of families.
function family_legend() {
  const all = Object.entries(meta.family_colours), many = all.length > 12;
  return {title: "pieces of", swatches: all.map(([number, shade]) =>
    ({name: number === "0" ? "whole" : many ? number : `block ${number}`, shade}))};
}

const crack_time = ({time}) => measured(`t = ${Number(time.toPrecision(4))}`, meta.time_unit);
/// Returns the numbers of blocks in words: "block 4", "blocks 4, 7 and 9".
function block_list(blocks) {
  const names = blocks.map((b) => b + 1), last = names.pop();
  return names.length ? `blocks ${names.join(", ")} and ${last}` : `block ${last}`;
}
/// Returns what is known of the cracks of a block, for the cursor: from which block it split off,
/// and which ones split off it.
function cracks_of(block, f) {
  const all = cracks_until(f), own = all.find(({child}) => child === block);
  const pieces = all.filter(({parent}) => parent === block).map(({child}) => child);
  return [...(own ? [`split off block ${own.parent + 1} at ${crack_time(own)}`] : []),
    ...(pieces.length ? [`${block_list(pieces)} split off it`] : [])];
}
/// Returns sentences about the cracks of the picked blocks, or of the whole model.
function about_cracks(f) {
  const all = cracks_until(f), {picked} = state, three = (v) =>
    Math.abs(v) < 1e5 ? digits(Number(v.toPrecision(3))) : v.toExponential(2).replace(/\.?0*e\+?/, "e");
  const told = ({parent, child, time, cause, stress, angle}) =>
    `Block ${child + 1} split off block ${parent + 1} at ${crack_time({time})}: ${cause}, `
    + `${value_text(three(stress), meta.stress_unit)}, chord at ${Math.round(10 * angle) / 10}°.`;
  if (!picked.length) return all.length ? [`The last crack: ${told(all.at(-1))}`] : [];
  return picked.filter((b) => exists(b, f)).flatMap((b) => {
    const own = all.find(({child}) => child === b), pieces = all.filter(({parent}) => parent === b);
    if (pieces.length > 1) {
      const list = block_list(pieces.map(({child}) => child));
      return [...(own ? [told(own)] : []), `B${list.slice(1)} split off block ${b + 1}.`];
    }
    return [own, ...pieces].filter((crack) => crack).map(told);
  });
}
