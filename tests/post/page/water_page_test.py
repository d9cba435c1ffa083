#!/usr/bin/python3
"""Water on the page of `blocks view`: water_page_test.py PROGRAM SOURCE [FOLDER].

The table and the pressures on the sides are those of the results. It is skipped (77) without chromium.
"""

import h5py
import numpy as np

from view_pages import run, show, with_browser


def check(page, program, source, folder):
    results = run(program, source / "decks/wet_slope/wet_slope.deck", folder)
    show(page, program, results, folder / "wet_slope.html")
    with h5py.File(results) as file:
        water = file["BLOCKS/water"]
        lines = [water["point"][first:first + count].ravel() for first, count in water["points_of_frame"]]
        first, count = water["parts_of_frame"][-1]
        largest = water["part"][first:first + count, 2:].max()
    shown = page.evaluate("meta.water_lines")
    assert len(shown) == len(lines) and not shown[0] and len(shown[-1]) >= 8
    assert all(np.allclose(a, b) for a, b in zip(shown, lines))

    pictures = {page.evaluate("$('model').toDataURL()")}
    page.evaluate("colour_by('water_pressure')")
    page.drawn()
    pictures.add(page.evaluate("$('model').toDataURL()"))
    page.picture(folder / "water.png")
    low, high = page.evaluate("colour_range(colour_quantity())")
    assert low == 0 and 0.5 * largest < high <= 1.001 * largest, (low, high, largest)
    assert page.evaluate("legend_parts(true)[0].title") == "water pressure [10³ Pa]"
    assert page.evaluate("legend_parts(true).at(-1).swatches.some(({name}) => name === 'water table')")
    # Each side that is drawn lies below the table at its deeper end.
    below = page.evaluate("""[...data.water_side.keys()].every((side) => {
        const at = 2 * (state.frame * data.water_side.length + side), [a, b] = [0, 1].map((end) => data.water_pressure[at + end]);
        if (a !== a) return true;
        const [from, to] = face_ends(sides_of(face_quantity("water_pressure")), side, 0);
        const [x, y] = a > b ? from : to, line = meta.water_lines[state.frame];
        let k = 0;
        while (k + 4 < line.length && line[k + 2] < x) k += 2;
        const level = line[k + 1] + (x - line[k]) / (line[k + 2] - line[k]) * (line[k + 3] - line[k + 1]);
        return Math.abs(9810 * (level - y) - Math.max(a, b)) < 1e-3 * 9810 * level;
    })""")
    assert below
    page.evaluate("show(0)")
    page.drawn()
    pictures.add(page.evaluate("$('model').toDataURL()"))
    assert len(pictures) == 3
    assert not page.faults(), page.faults()


with_browser(check)
