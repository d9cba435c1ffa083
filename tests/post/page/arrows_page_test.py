#!/usr/bin/python3
"""The arrows of the page of `blocks view`: arrows_page_test.py PROGRAM SOURCE [FOLDER].

Their scale is that of a movie of `blocks plot`, and their values are those of the file. An arrow that leaves the
picture ends at its frame. It is skipped (77) without chromium.
"""

from statistics import median_high

from view_pages import history, run, show, with_browser

ARROWS = "arrows_of(state.frame, visible_blocks(), both_halves(corners))"


def check(page, program, source, folder):
    results = run(program, source / "decks/stack/stack.deck", folder)
    show(page, program, results, folder / "stack.html", "--mirror", "-2")
    count = page.evaluate("meta.blocks")
    curves = [f"{name}:{b + 1}" for b in range(count) for name in ("speed", "vx", "vy")]
    rows = history(program, results, curves)
    largest = [max(row[f"speed:{b + 1}"] for b in range(count)) for row in rows]
    usual = median_high([speed for speed in largest if speed > 0])
    plain = page.evaluate("$('model').toDataURL()")
    frame = largest.index(max(largest))
    page.evaluate(f"show({frame})")
    page.key("v")
    page.drawn()
    assert page.evaluate("state.arrows === 'velocity' && $('arrows').value === 'velocity'")
    assert abs(page.evaluate("full_arrow()") / usual - 1) < 1e-5
    assert page.evaluate("$('model').toDataURL()") != plain

    # Twice, because the other half has the same arrows with the other direction along x.
    full = page.evaluate("arrow_length()")
    wanted = sorted(length for b in range(count) for _ in (0, 1)
                    if (length := full * rows[frame][f"speed:{b + 1}"] / usual) >= 1.5)
    drawn = page.evaluate(f"{ARROWS}.map((one) => [Math.hypot(one.x1 - one.x0, one.y1 - one.y0), one.open, one.ux])")
    assert len(drawn) == len(wanted) > 2, (drawn, wanted)
    assert all(abs(one[0] - length) < 0.01 for one, length in zip(reversed(drawn), wanted)), (drawn, wanted)
    assert not any(one[1] for one in drawn), "the picture shows everything"
    assert abs(sum(one[2] for one in drawn)) < 1e-6, "the mirrored arrows point the wrong way"
    legend = "legend_parts(true).find((part) => part.arrow)"
    assert page.evaluate(f"{legend}.title") == "velocity" and "m/s" in page.evaluate(f"{legend}.arrow")
    page.picture(folder / "arrows.png")

    # A typed value limits the length.
    page.evaluate(f"$('full_arrow').value = {max(largest) / 4}; type_full_arrow()")
    page.drawn()
    assert page.evaluate(f"{legend}.more")
    lengths = page.evaluate(f"{ARROWS}.map((one) => Math.hypot(one.x1 - one.x0, one.y1 - one.y0))")
    assert abs(max(lengths) - full) < 0.01, lengths
    page.evaluate("$('full_arrow').value = ''; type_full_arrow()")
    assert abs(page.evaluate("full_arrow()") / usual - 1) < 1e-5

    # The frame of the picture is six pixels before the middle of the fastest block, which moves up or down.
    up = page.evaluate("""(() => { const all = [...Array(meta.blocks).keys()], f = state.frame;
        const b = all.reduce((a, b) => value('speed', b, f) > value('speed', a, f) ? b : a), up = value('vy', b, f) > 0;
        const [x, y] = centre(b, f), scale = 20 * state.view.scale, half = (model.clientHeight / 2 - 6) / scale;
        state.view = {x, y: up ? y - half : y + half, scale}; redraw(); return up; })()""")
    page.drawn()
    edge = page.evaluate(f"{'2' if up else 'model.clientHeight - 2'}")
    ends = page.evaluate(f"{ARROWS}.filter((one) => one.open).map((one) => one.y1)")
    assert ends and all(abs(y - edge) < 1e-6 for y in ends), (ends, edge)

    for name in ("displacement", ""):
        page.key("v")
        assert page.evaluate("state.arrows") == name
    assert page.evaluate("$('arrow_options').hidden")
    assert not page.faults(), page.faults()


with_browser(check)
