#!/usr/bin/python3
"""The page of `blocks view` with joint ids: joints_page_test.py PROGRAM SOURCE [FOLDER].

A square is cut by horizontal joints 1 and vertical joints 2, so the direction of a side tells its joint. The
page names the joint of each side under the pointer and of the picked one. A page without joints has no sides.
It is skipped (77) without chromium.
"""

from view_pages import run, screen, show, with_browser

DECK = """START, 40, 4
A SQUARE WITH JOINTS
XLIMITS, -10, 10
YLIMITS, -10, 10
BOXES, 10, 10, 0.1
STIFF, 1.E7, 1.E7
FRACTION, 0.02
MATERIAL, 1, 1.E9, 4.E8, 1000
UNITS, m, kg, s
RIGID
END
OUTLINE, 4, 1
0, 0, 4, 4
0, 4, 4, 0
JSET, 1, 0, , 1, , , , , , 0, 0.5
JSET, 2, 90, , 1, , , , , , 0.5, 0
CUT
PLOTS, 0.01
MOTION, 0.01
"""
SIDE = """(() => {{ const first = data.first_corner[{b}], n = data.corners[{b}];
return [{i}, ({i} + 1) % n].map((k) => [corners[2 * (first + k)], corners[2 * (first + k) + 1]]); }})()"""


def joint_of(from_, to):
    """The joint of a side of this deck."""
    (x0, y0), (x1, y1) = from_, to
    if abs(y0 - y1) < 1e-6:
        return "no joint" if min(abs(y0), abs(y0 - 4)) < 1e-6 else "joint 1"
    return "no joint" if min(abs(x0), abs(x0 - 4)) < 1e-6 else "joint 2"


def check(page, program, source, folder):
    (folder / "square.deck").write_text(DECK)
    results = run(program, folder / "square.deck", folder)
    show(page, program, results, folder / "square.html")
    seen = set()
    for block in (0, 6, 12, 24):
        cx, cy = page.evaluate(f"centre({block}, state.frame)")
        for side in range(page.evaluate(f"data.corners[{block}]")):
            ends = page.evaluate(SIDE.format(b=block, i=side))
            mx, my = (sum(axis) / 2 for axis in zip(*ends))
            at = screen(page, mx + 0.04 * (cx - mx), my + 0.04 * (cy - my))
            expected = joint_of(*ends)
            seen.add(expected)
            page.move(*at)
            tip = page.evaluate("$('tip').innerText")
            assert tip.endswith(f"side {side + 1}: {expected}"), tip
            page.click(*at)
            about = page.evaluate("$('block_about').lastChild.textContent")
            direction = 0 if abs(ends[0][1] - ends[1][1]) < 1e-6 else 90
            assert about.startswith(f"Side {side + 1}: {expected}, ") and about.endswith(f" m long, at {direction}°."), about
            assert page.evaluate("[state.picked[0], state.side]") == [block, side]
    assert seen == {"no joint", "joint 1", "joint 2"}, seen
    page.picture(folder / "side.png")
    page.evaluate("pick_first(12)")  # without a side, as with the keys
    page.drawn()
    assert page.evaluate("$('block_about').textContent").endswith("Joints of block 13: 1, 2. Click a side to see its joint.")
    page.move(*screen(page, *page.evaluate("centre(12, state.frame)")))
    assert "side" not in page.evaluate("$('tip').innerText")
    assert not page.faults(), page.faults()

    results = run(program, source / "decks/bounce/bounce.deck", folder)
    show(page, program, results, folder / "bounce.html")
    assert page.evaluate("meta.joints === undefined && data.joint === undefined")
    page.evaluate("pick({block: 0, side: side_at(0, to_screen(corners[0], corners[1]), corners)}, false)")
    page.drawn()
    assert page.evaluate("state.side") == -1 and "oint" not in page.evaluate("$('block_about').textContent")
    assert not page.faults(), page.faults()


with_browser(check)
