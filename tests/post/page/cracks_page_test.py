#!/usr/bin/python3
"""The page of `blocks view` with blocks that split: cracks_page_test.py PROGRAM SOURCE [FOLDER].

In every frame each block has the corners of the file, the faces of a crack are twice as long as its chord, and no
displacement jumps. The page tells which block split off which one. It is skipped (77) without chromium.
"""

import math

from view_pages import history, run, screen, show, with_browser

CORNERS = """(() => {{ const f = {f}, all = place_corners(f, new Float64Array(corners.length));
return [...Array(meta.counts[f]).keys()].map((b) => {{ const s = shape_of(b, f);
  return exists(b, f) ? [...all.slice(2 * data.first_corner[s], 2 * data.first_corner[s + 1])] : []; }}); }})()"""
FACES = """(() => {{ const f = {f}, all = place_corners(f, new Float64Array(corners.length));
const length = meta.cracks.map(() => 0);
for (let b = 0; b < meta.counts[f]; ++b) {{
  const s = shape_of(b, f), first = data.first_corner[s], n = data.corners[s];
  for (let k = 0; k < n && exists(b, f); ++k) {{
    const i = 2 * (first + k), j = 2 * (first + (k + 1) % n), crack = data.crack[first + k];
    if (crack) length[crack - 1] += Math.hypot(all[j] - all[i], all[j + 1] - all[i + 1]);
  }}
}}
return length; }})()"""


def check_corners(page, program, results, frames):
    drawn = [page.evaluate(CORNERS.format(f=f)) for f in range(frames)]
    most = {}
    for blocks in drawn:
        for b, corners in enumerate(blocks):
            most[b] = max(most.get(b, 0), len(corners) // 2)
    curves = [f"{axis}:{b + 1}.{c + 1}" for b in most for c in range(most[b]) for axis in "xy"]
    rows = history(program, results, curves)
    assert len(rows) == frames
    for blocks, row in zip(drawn, rows):
        for b in most:
            corners = blocks[b] if b < len(blocks) else []
            exact = [row[f"{axis}:{b + 1}.{c + 1}"] for c in range(most[b]) for axis in "xy"]
            there = [at for at in exact if not math.isnan(at)]
            assert len(there) == len(corners), (b, corners, exact)
            assert all(abs(x - y) < 2e-5 for x, y in zip(corners, there)), (b, corners, exact)


def check_faces(page, frames):
    lengths = page.evaluate("meta.cracks.map(({length}) => length)")
    for f in range(frames):
        count = page.evaluate(f"meta.crack_counts[{f}]")
        for i, (faces, length) in enumerate(zip(page.evaluate(FACES.format(f=f)), lengths)):
            exact = 2 * length if i < count else 0
            assert abs(faces - exact) < 2e-3 * length, f"frame {f}, crack {i + 1}: {faces}, not {exact}"


def check_words(page, frames):
    last = frames - 1
    parent, child = page.evaluate("[meta.cracks[0].parent, meta.cracks[0].child]")
    page.evaluate(f"show({last}), pick_first(-1)")
    page.drawn()
    about = page.evaluate("$('block_about').lastChild.textContent")
    assert about.startswith("The last crack: Block ") and " split off block " in about, about
    assert page.evaluate("rows().find(({name}) => name === 'cracks').all.at(-1)") == page.evaluate("meta.cracks.length")
    page.move(*screen(page, *page.evaluate(f"centre({child}, {last})")))
    tip = page.evaluate("$('tip').innerText")
    assert tip.startswith(f"Block {child + 1}, ") and f"split off block {parent + 1} at t = " in tip, tip
    page.evaluate(f"pick_first({child})")
    page.drawn()
    about = page.evaluate("$('block_about').innerText")
    assert f"Block {child + 1} split off block {parent + 1} at t = " in about, about
    page.evaluate("show(0)")
    page.drawn()
    assert page.evaluate("$('block_about').textContent").startswith(f"Block {child + 1} does not exist yet.")


def check_pictures(page, frames):
    page.evaluate(f"pick_first(-1), show({frames - 1}), fit()")
    page.move(1, 1)
    page.drawn()
    with_cracks = page.evaluate("$('model').toDataURL()")
    page.key("g")
    page.drawn()
    assert page.evaluate("!$('cracks').checked && $('model').toDataURL()") != with_cracks
    page.key("g")
    page.evaluate("colour_by('family')")
    page.drawn()
    roots = page.evaluate("[...new Set(meta.families)].sort()")
    assert len(roots) > 2 and page.evaluate(f"family_of(0, {frames - 1})") == 1 and page.evaluate("family_of(0, 0)") == 0
    page.evaluate("colour_by('displacement'), turn('original', true)")
    page.drawn()


def check(page, program, source, folder):
    results = run(program, source / "tests/post/cracked.deck", folder)
    show(page, program, results, folder / "cracked.html")
    frames = page.evaluate("frames")
    assert page.evaluate("meta.crack_counts[0] === 0 && meta.crack_counts.at(-1) === meta.cracks.length")
    assert page.evaluate("meta.cracks.length") >= 2
    check_corners(page, program, results, frames)
    check_faces(page, frames)
    moved = page.evaluate("[...data.displacement].filter((d, i) => i % meta.blocks !== 2)")
    speed = page.evaluate("data.speed.reduce((most, v) => Math.max(most, v), 0)")
    assert max(moved) <= speed * page.evaluate("meta.times.at(-1)") + 1e-6, max(moved)
    check_words(page, frames)
    check_pictures(page, frames)
    page.evaluate("show(0), play(true)")
    page.wait(f"!state.playing && state.frame === {frames - 1}")
    page.picture(folder / "cracked.png")
    assert not page.faults(), page.faults()

    results = run(program, source / "decks/bounce/bounce.deck", folder)
    show(page, program, results, folder / "bounce.html")
    assert page.evaluate("meta.cracks === undefined && data.shape === undefined && $('cracks').parentElement.hidden")
    assert not page.faults(), page.faults()


if __name__ == "__main__":
    with_browser(check)
