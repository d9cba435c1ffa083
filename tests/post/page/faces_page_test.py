#!/usr/bin/python3
"""Opening and shear displacement on the page of `blocks view`: faces_page_test.py PROGRAM SOURCE [FOLDER].

The values of the page agree, to four digits, with the places where it draws both sides of each face. It is skipped
(77) without chromium.
"""

from view_pages import run, show, with_browser

# Returns opening and shear of both ends of each face, from the places of its sides in the current frame.
FROM_PLACES = """(() => [...Array(data.face_side.length / 2).keys()].map((face) => {
    const [own, other] = [0, 1].map((which) => face_ends(sides_of(face_quantity("opening")), face, which));
    const way = (side) => { const at = 2 * side, to = 2 * corner_beside(side, 1);
        const d = [corners[to] - corners[at], corners[to + 1] - corners[at + 1]], size = Math.hypot(...d);
        return d.map((part) => part / size); };
    const [a, b] = [way(data.face_side[2 * face]), way(data.face_side[2 * face + 1])];
    const size = Math.hypot(a[0] - b[0], a[1] - b[1]), [tx, ty] = [(a[0] - b[0]) / size, (a[1] - b[1]) / size];
    return [0, 1].map((end) => { const dx = other[end][0] - own[end][0], dy = other[end][1] - own[end][1];
        return [dy * tx - dx * ty, dx * tx + dy * ty]; });
}))()"""


def check(page, program, source, folder):
    results = run(program, source / "decks/slope/slope.deck", folder)
    show(page, program, results, folder / "slope.html", "--mirror", "-12")
    names = ["opening", "shear_displacement"]
    assert page.evaluate("face_colours()") == names
    page.evaluate("show(0)")
    page.drawn()
    first = page.evaluate(FROM_PLACES)
    assert len(first) > 100, len(first)
    assert all(abs(value) < 1e-5 for face in first for end in face for value in end), first
    page.evaluate("show(nearest(1))")
    page.drawn()
    now = page.evaluate(FROM_PLACES)
    shown = [page.evaluate(f"[...data.{name}.slice(2 * state.frame * {len(now)}).slice(0, {2 * len(now)})]")
             for name in names]
    compared = 0
    for face, ends in enumerate(now):
        for end in (0, 1):
            for which in (0, 1):
                value = shown[which][2 * face + end]
                if value is not None:  # NaN: it is not a face any more
                    compared += 1
                    exact = ends[end][which] - first[face][end][which]
                    assert abs(value - exact) < 1e-5 + 5e-4 * abs(exact), (face, names[which], value, exact)
    assert compared > 3 * len(now), f"{compared} values of {len(now)} faces"
    assert min(value for value in shown[1] if value is not None) < -0.5, "the slope slides to the left"

    pictures = {page.evaluate("$('model').toDataURL()")}
    for name in names:
        page.evaluate(f"colour_by('{name}')")
        page.drawn()
        pictures.add(page.evaluate("$('model').toDataURL()"))
        page.picture(folder / f"{name}.png")
    assert len(pictures) == 3
    low, high = page.evaluate("colour_range(colour_quantity())")
    assert low == -high < -0.5, "shear has the other sign in the mirrored half"
    assert page.evaluate("legend_parts(true)[0].title.startsWith('shear displacement')")
    page.evaluate("$('low').value = -0.1; $('high').value = 0.1; type_range()")
    assert page.evaluate("legend_parts(true)[0].is_cut") == [True, True]
    page.key("]")
    assert page.evaluate("state.colour") == "displacement"
    assert not page.faults(), page.faults()

    results = run(program, source / "tests/post/strained.deck", folder)
    show(page, program, results, folder / "strained.html")
    assert page.evaluate("face_colours().length === 0 && data.opening === undefined")
    assert not page.faults(), page.faults()


with_browser(check)
