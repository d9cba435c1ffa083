#!/usr/bin/python3
"""The page of `blocks view` in a browser: view_page_test.py PROGRAM SOURCE [FOLDER].

The test plays the page, picks every block at its place in the file, and compares the numbers
with those of `blocks history`. It is skipped (77) without chromium. With FOLDER it keeps pages
and pictures there.
"""

import re
import time

from view_pages import history, run, same_number, screen, show, with_browser

QUANTITIES = ["x", "y", "dx", "dy", "displacement", "speed", "vx", "vy", "rotation", "spin", "fx", "fy", "moment",
              "s11", "s22", "s12", "p1", "p2", "kinetic_energy", "overlap", "contacts"]
SEEN = """Object.fromEntries([...$("numbers").tBodies[0].rows].map((row) =>
    [row.dataset.name, row.cells[1].textContent.replaceAll("−", "-")]))"""


def check_numbers(page, rows, followed, deck):
    page.key("Home")
    for row in rows:
        seen = page.evaluate(SEEN)
        assert sorted(seen) == sorted(QUANTITIES), seen
        for name, shown in seen.items():
            exact = row[f"{name}:{followed}"]
            assert same_number(shown, exact), f"{deck}: {name} shown as {shown}, the file has {exact!r}"
        page.key("ArrowRight")


def check_corners(page, program, results, block):
    """The outline on the page is that of the file to a hundred-thousandth of the block size."""
    first, end = page.evaluate(f"[data.first_corner[{block - 1}], data.first_corner[{block}]]")
    curves = [f"{axis}:{block}.{c + 1}" for c in range(end - first) for axis in "xy"]
    for frame, row in enumerate(history(program, results, curves)):
        drawn = page.evaluate(f"[...place_corners({frame}, new Float64Array(corners.length))]")[2 * first:2 * end]
        for name, at in zip(curves, drawn):
            assert abs(at - row[name]) < 2e-5, f"frame {frame}: {name} drawn at {at}, the file has {row[name]}"


def check_playing(page, frames):
    page.evaluate("$('pace').value = '4'; $('pace').dispatchEvent(new Event('change'))")
    page.key("Home")
    page.key(" ")
    seen, end = [0], time.monotonic() + 30
    while page.evaluate("$('play').getAttribute('aria-label')") == "pause":
        seen.append(int(page.evaluate("$('scrub').value")))
        assert time.monotonic() < end, "it plays for ever"
    assert seen == sorted(seen) and len(set(seen)) > 3, seen  # The number depends on the machine.
    assert page.evaluate("state.frame") == frames - 1


def check_forces(page, acting):
    """At rest every force of the stack is vertical and at a corner where two bricks meet. The forces on the floor
    carry twelve bricks of 10 kN (in steps of 3 %)."""
    count, directions, heights, floor = page.evaluate(
        "(() => { const {corner, direction, size} = data.forces.at(-1);"
        "const at = [...corner].map((c) => corners[2 * c + 1]);"
        "const force = (i) => meta.largest_force * 10 ** (6 * (size[i] / 255 - 1));"
        "return [corner.length, [...direction], at, at.reduce((sum, y, i) => sum + (Math.abs(y) < 0.01 ? force(i) : 0), 0)];"
        "})()")
    assert count == acting and {d % 128 for d in directions} == {64}, directions
    assert all(abs(2 * y - round(2 * y)) < 0.01 for y in heights), heights
    assert abs(floor / 120e3 - 1) < 0.03, floor


def check_hands(page):
    """Every key that draws something changes the picture. Wheel and fingers zoom and pan."""
    pictures = set()
    page.key("Home")
    for name in ["ArrowRight", "o", "c", "n", "+", "]", "t"]:
        page.key(name)
        pictures.add(page.evaluate("$('model').toDataURL()"))
    assert len(pictures) == 7, "a key changed nothing"
    x, y = page.evaluate("(() => { const b = $('model').getBoundingClientRect();"
                         "return [b.left + b.width / 2, b.top + b.height / 2]; })()")
    before = page.evaluate("state.view.scale")
    page.wheel(x, y, 240)
    page.wait(f"state.view.scale > 1.2 * {before}")
    before = page.evaluate("state.view")
    page.touch([(x - 40, y), (x + 40, y)], [(x - 60, y), (x + 60, y)], [(x - 80, y), (x + 80, y)])
    after = page.evaluate("state.view")
    assert abs(after["scale"] / before["scale"] - 2) < 0.05, (before, after)
    page.touch([(x, y)], [(x + 30, y)], [(x + 60, y)])
    assert abs((after["x"] - page.evaluate("state.view.x")) * after["scale"] - 60) < 20
    for name in ["f", "n", "t", "Escape"]:
        page.key(name)


def check_draft(page, blocks):
    """The draft picture has the colours of the fine one in the middle of every block, and is replaced by it."""
    page.evaluate("colour_by('y')")
    page.drawn()
    colours = f"""[...Array({blocks}).keys()].map((b) => [...pen.getImageData(
        ...to_screen(...centre(b, state.frame)).map(Math.round), 1, 1).data].join())"""
    fine, picture = page.evaluate(colours), page.evaluate("$('model').toDataURL()")
    # The fine picture replaces the draft after a moment.
    draft, hurried = page.evaluate(f"draft_above = 0; moves(); draw(); [{colours}, $('model').toDataURL()]")
    assert draft == fine and len(set(fine)) > 2, (draft, fine)
    assert hurried != picture, "no draft was drawn"
    page.wait("performance.now() - moved_at > rest + 150")
    page.drawn()
    assert page.evaluate("$('model').toDataURL()") == picture, "the fine picture did not follow"
    page.evaluate("draft_above = 3000; colour_by('material')")


def check_mirror(program, results, folder, page, block, x, y):
    """The other half of a half model is drawn and can be picked. M hides it."""
    show(page, program, results, folder / "whole.html", "--mirror", "-2")
    there = screen(page, -4 - x, y)
    page.click(*there)
    assert page.evaluate("state.picked") == [block - 1]
    both = page.evaluate("$('model').toDataURL()")
    page.key("m")
    assert page.evaluate("$('model').toDataURL()") != both
    page.click(*there)
    assert page.evaluate("state.picked") == []


def check(program, deck, folder, followed, page, hands):
    results, path = run(program, deck, folder), folder / f"{deck.stem}.html"
    show(page, program, results, path)
    assert not re.search(r"https?://|\bsrc=|<link|@import", path.read_text()), "the page asks for something outside"
    energy = history(program, results, ["kinetic_energy"])[-1]["kinetic_energy"]
    assert same_number(page.evaluate(SEEN)["kinetic_energy"], energy)

    blocks = int(history(program, results, ["blocks"])[-1]["blocks"])
    last = history(program, results, [f"{axis}:{b}" for b in range(1, blocks + 1) for axis in "xy"])[-1]
    for b in range(1, blocks + 1):
        page.click(*screen(page, last[f"x:{b}"], last[f"y:{b}"]))
        picked = page.evaluate("$('block_name').textContent")
        assert picked == f"Block {b}", f"a click on block {b} picks {picked}"
    corner = page.evaluate("(() => { const b = $('model').getBoundingClientRect(); return [b.left + 3, b.bottom - 3]; })()")
    page.click(*corner)
    assert page.evaluate("$('block_name').textContent") == "Whole model"
    page.click(*screen(page, last[f"x:{followed}"], last[f"y:{followed}"]))

    rows = history(program, results, [f"{name}:{followed}" for name in QUANTITIES])
    assert len(rows) > 5
    check_numbers(page, rows, followed, deck.stem)
    check_corners(page, program, results, followed)
    check_playing(page, len(rows))
    page.picture(folder / f"{deck.stem}_block.png")
    if hands:
        check_forces(page, history(program, results, ["contacts"])[-1]["contacts"])
        check_hands(page)
        page.key("f")
        check_draft(page, blocks)
        check_mirror(program, results, folder, page, followed, last[f"x:{followed}"], last[f"y:{followed}"])
    assert not page.faults(), page.faults()
    assert not page.requests(), page.requests()
    print(f"{deck.stem}: {blocks} blocks picked, {len(rows) * len(QUANTITIES)} numbers as in the file")


def check_far_from_the_origin(program, folder, page):
    """Far from the origin, numbers and history of a place are those of the file to a hundred-thousandth of the model
    size. Axis and colour bar have a round number as offset."""
    deck = folder / "far.deck"
    deck.write_text("""START, 4, 4
FAR AWAY
XLIMITS, 499990, 500030
YLIMITS, 3999990, 4000030
BOXES, 20, 20, 0.1
STIFF, 1.E8, 1.E8
FRACTION, 0.02
MATERIAL, 1, 1.E10, 4.E9, 2500
END
CREATE, 4, 1, 1
500000, 500000, 500010, 500010
3999999, 4000000, 4000000, 3999999
CREATE, 4, 1
500001, 500001, 500002, 500002
4000000, 4000001, 4000001, 4000000
GRAVITY, 0, -10
PLOTS, 0.01
MOTION, 0.05
""")
    results = run(program, deck, folder)
    show(page, program, results, folder / "far.html")
    page.evaluate("pick_first(1); state.followed = 'y'; colour_by('y')")
    page.drawn()
    page.key("Home")
    for row in history(program, results, ["x:2", "y:2"]):
        seen = page.evaluate(SEEN)
        for name in "xy":
            assert abs(float(seen[name]) - row[f"{name}:2"]) <= 0.51e-5, (name, seen[name], row)
        page.key("ArrowRight")
    title = page.evaluate("$('chart_name').textContent")
    assert re.match(r"y − 4000000(\.\d+)?( |$)", title), title
    ticks = page.evaluate("legend_parts(true)[0].ticks.map((one) => one[1])")
    assert len(ticks) == len(set(ticks)) > 2, ticks
    late = page.evaluate("label_ticks(4000000.49975, 4000000.5, 4, 'y', 'm').ticks.map((one) => one[1])")
    assert late == ["−250", "−200", "−150", "−100", "−50", "0"], late
    page.picture(folder / "far.png")


def check_all(page, program, source, folder):
    check(program, source / "decks/stack/stack.deck", folder, 4, page, True)  # rigid
    check(program, source / "tests/post/strained.deck", folder, 2, page, False)  # deformable, spinning
    check_far_from_the_origin(program, folder, page)


with_browser(check_all)
