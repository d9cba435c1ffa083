#!/usr/bin/python3
"""The page of `blocks view` with a removed block: removed_page_test.py PROGRAM SOURCE [FOLDER].

The block is drawn and can be picked until it is removed. After that it has no numbers, no curve and no
place, and the page fits the others. It is skipped (77) without chromium.
"""

from view_pages import run, screen, show, with_browser

DECK = """START, 10, 4
THE BLOCK ON THE RIGHT IS REMOVED
XLIMITS, -50, 50
YLIMITS, -50, 50
BOXES, 10, 10, 0.1
STIFF, 1.E7, 1.E7
FRACTION, 0.02
MATERIAL, 1, 1.E9, 4.E8, 1000
RIGID
END
CREATE, 4, 1, 1
-2, -2, 6, 6
-1, 0, 0, -1
CREATE, 4, 1
0, 0, 1, 1
0, 1, 1, 0
CREATE, 4, 1, 1
20, 20, 21, 21
0, 1, 1, 0
GRAVITY, 0, -9.81
PLOTS, 0.01
REMOVE, 3
MOTION, 0.02
"""


def block_at(page, x, y):
    px, py = screen(page, x, y)
    return page.evaluate("(() => { const box = $('model').getBoundingClientRect();"
                         f"return block_at([{px} - box.left, {py} - box.top]).block; }})()")


def check(page, program, source, folder):
    for stem, deck in (("early", DECK), ("late", DECK.replace("REMOVE, 3\n", "MOTION, 0.02\nREMOVE, 3\n"))):
        (folder / f"{stem}.deck").write_text(deck)
        results = run(program, folder / f"{stem}.deck", folder)
        show(page, program, results, folder / f"{stem}.html")
        assert page.evaluate("removed(2, frames - 1) && !exists(2, frames - 1)")
        assert page.evaluate("visible_blocks().includes(2)") is False
        assert block_at(page, 20.5, 0.5) == -1 and block_at(page, 0.5, 0.5) == 1
        page.evaluate("pick_first(2)")
        page.drawn()
        assert page.evaluate("$('block_about').textContent") == "Block 3 is removed."
        assert page.evaluate("$('numbers').tBodies[0].rows[0].cells[1].textContent") == "–"
        page.evaluate("pick_first(-1)")
        page.drawn()
        assert page.evaluate("rows().find(({name}) => name === 'blocks').all.at(-1)") == 2
        assert page.evaluate("frame_lines().length") == 3
        assert page.evaluate("ranges.x[1] < 10") is (stem == "early")
        page.evaluate("fit()")
        page.drawn()
        wide = page.evaluate("model.clientWidth / state.view.scale")
        assert (wide < 20) is (stem == "early"), wide  # A block of the first frame is fitted, too.
    page.key("Home")
    page.drawn()
    assert block_at(page, 20.5, 0.5) == 2 and page.evaluate("exists(2, 0)")
    assert page.evaluate("history_of('y', 2).filter((v) => v === v).length") == 3


with_browser(check)
