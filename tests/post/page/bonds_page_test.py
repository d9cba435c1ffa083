#!/usr/bin/python3
"""The page of `blocks view` with laws of joints: bonds_page_test.py PROGRAM SOURCE [FOLDER].

Block 2 hangs below block 1 by its bond; block 4 has fallen off block 3, whose bond was too weak. The page draws the
faces by their bond and tells bond and stress of the side under the pointer. It is skipped (77) without chromium.
"""

from view_pages import run, screen, show, with_browser

DECK = """START, 40, 4
BONDS
XLIMITS, -20, 20
YLIMITS, -20, 20
BOXES, 10, 10, 0.1
STIFF, 1.E7, 1.E7
FRACTION, 0.02
MATERIAL, 1, 1.E9, 4.E8, 1000
MATERIAL, 2, 1.E9, 4.E8, 1000
UNITS, m, kg, s
RIGID
END
CREATE, 4, 1, 1
-1, -1, 1, 1
1, 2, 2, 1
CREATE, 4, 1
-1, -1, 1, 1
0, 1, 1, 0
CREATE, 4, 2, 1
4, 4, 6, 6
1, 2, 2, 1
CREATE, 4, 2
4, 4, 6, 6
0, 1, 1, 0
JOINT, 1, 0.5, 1.E5, 5.E4
JOINT, 2, 0.5, 1.E5, 5.E3
JPAIR, 1, 1, 1
JPAIR, 2, 2, 2
BOND
GRAVITY, 0, -10
DAMPING, 0.5
PLOTS, 0.1
MOTION, 0.5
"""


def tip_at(page, x, y):
    page.move(*screen(page, x, y))
    page.drawn()
    return page.evaluate("$('tip').innerText")


def check(page, program, source, folder):
    (folder / "bonds.deck").write_text(DECK)
    results = run(program, folder / "bonds.deck", folder)
    show(page, program, results, folder / "bonds.html")
    assert page.evaluate("[...$('colour').options].some((one) => one.value === 'bond')")
    page.evaluate("colour_by('bond')")
    page.drawn()
    assert page.evaluate("face_parts().length") == 4
    assert page.evaluate("legend_parts(true)[0].swatches.map(({name}) => name)") == ["bonded"]
    tip = tip_at(page, 0, 0.98)
    assert "bonded, slip 0 m" in tip and "normal stress −10000 Pa, shear 0 Pa" in tip, tip
    assert "stress" not in tip_at(page, 0, 0.02), "nothing is below block 2"
    page.click(*screen(page, 0, 0.98))
    assert "Normal stress −10000 Pa" in page.evaluate("$('block_about').innerText")
    page.picture(folder / "bonds.png")
    assert "stress" not in tip_at(page, 5, 1.02), "block 4 has fallen"
    page.evaluate("show(0)")
    page.drawn()
    assert page.evaluate("face_parts().length") == 8
    page.evaluate("next_colour(1)")
    page.drawn()
    assert page.evaluate("state.colour") == "opening"
    assert not page.faults(), page.faults()

    results = run(program, source / "decks/bounce/bounce.deck", folder)
    show(page, program, results, folder / "bounce.html")
    assert not page.evaluate("[...$('colour').options].some((one) => one.value === 'bond')")
    assert page.evaluate("data.bond_counts === undefined && !has_sides()")
    assert not page.faults(), page.faults()


with_browser(check)
