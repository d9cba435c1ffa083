#!/usr/bin/python3
"""The tools of the page of `blocks view` in a browser: view_tools_test.py PROGRAM SOURCE [FOLDER].

Axes and cursor, comparison of two blocks, colour maps and ranges, saved files, the place of the legend, the keyboard,
and what is visible on every colour. It is skipped (77) without chromium. With FOLDER it keeps pages and pictures
there.
"""

import base64
import csv
import math
import re
import struct
import time

from view_pages import history, run, same_number, screen, show, with_browser

# Functions for the tests: the colour of a pixel of the model, the contrast of two colours (1 to 21), and all texts
# that a function draws with a pen.
HELP = """
window.shade_of = (bytes) => hex([...bytes].slice(0, 3).map((c) => c / 255));
window.pixel_at = (x, y) => shade_of(pen.getImageData(Math.round(x), Math.round(y), 1, 1).data);
window.contrast = (a, b) => { const [x, y] = [luminance(a), luminance(b)].sort(); return (y + 0.05) / (x + 0.05); };
window.written = (its_pen, paint) => {
  const texts = [], own = its_pen.fillText;
  its_pen.fillText = (text, x, y) => texts.push([String(text), x, y]);
  paint();
  its_pen.fillText = own;
  return texts;
};"""


def number(text):
    return float(re.search(r"[-−]?[\d.]+(e[-−]?\d+)?", text)[0].replace("−", "-"))


def text(page, name):
    return page.evaluate(f"$('{name}').textContent")


def tab_to(page, is_there):
    """Presses Tab until the expression is true."""
    for _ in range(60):
        if page.evaluate(is_there):
            return
        page.key("Tab")
    raise AssertionError(f"Tab never makes this true: {is_there}")


def middle(page, selector):
    return page.evaluate(f"(() => {{ const b = document.querySelector('{selector}').getBoundingClientRect();"
                         "return [b.left + b.width / 2, b.top + b.height / 2]; })()")


def check_axes(page, unit):
    """Each number of an axis is beside its coordinate, and the scale bar is as long as its text says."""
    for _ in range(3):
        texts = page.evaluate("written(axes_pen, draw_axes)")
        left, top, width, height = page.evaluate(
            "[model.offsetLeft, model.offsetTop, model.clientWidth, model.clientHeight]")
        for axis, is_ours in (("x", lambda x, y: y > top + height), ("y", lambda x, y: 0 < x < left)):
            ticks = [one for one in texts if is_ours(*one[1:]) and re.fullmatch(r"[−\d.]+", one[0])]
            assert len(ticks) > 2, (axis, texts)
            for label, x, y in ticks:
                at = page.evaluate(f"to_screen({number(label)}, {number(label)})")
                miss = x - left - at[0] if axis == "x" else y - top - at[1]
                assert abs(miss) < 9, f"{axis} = {label} is {miss} pixels from its place"
        assert {f"x [{unit or 'L'}]", f"y [{unit or 'L'}]"} <= {one[0] for one in texts}, texts
        words = text(page, "bar_length")
        width = page.evaluate("$('bar').getBoundingClientRect().width / state.view.scale")
        assert abs(width / number(words) - 1) < 0.02, (width, words)
        assert words.endswith(" m") if unit else re.fullmatch(r"[\d.]+", words), words
        page.evaluate("zoom(2.7)")
        page.drawn()
    page.key("f")


def check_cursor(page, program, results):
    """The pointer reads coordinates and the block below it, without a click."""
    row = history(program, results, ["x:4", "y:4", "speed:4", "dy:4"])[-1]
    page.evaluate("pick_first(-1)")
    page.move(*screen(page, row["x:4"], row["y:4"]))
    x, y = (number(part) for part in text(page, "place").split("y ="))
    assert math.hypot(x - row["x:4"], y - row["y:4"]) < page.evaluate("1.5 / state.view.scale"), text(page, "place")
    assert text(page, "place").endswith(" m")
    for name, words in (("material", "speed"), ("dy", "displacement y")):
        page.evaluate(f"colour_by('{name}'); follow('speed')")  # The chart may follow another quantity.
        page.drawn()
        tip = page.evaluate("[...$('tip').children].map((one) => one.textContent)")
        assert tip[0] == "Block 4, brick" and tip[1].startswith(words), tip
        exact = row["speed:4" if name == "material" else "dy:4"]
        assert same_number(tip[1].split()[-2].replace("−", "-"), exact), (tip, exact)
    assert page.evaluate("state.picked") == []
    marks = page.evaluate("legend_parts(true)[0].marks")
    assert len(marks) == 1 and abs(marks[0] / row["dy:4"] - 1) < 1e-5, "the colour bar does not mark the value"
    marked = page.evaluate("key.toDataURL()")
    page.move(*screen(page, row["x:4"], row["y:4"] + 2.6))
    assert page.evaluate("$('tip').hidden"), "there is no block above the stack"
    assert page.evaluate("key.toDataURL()") != marked, "the mark on the colour bar does not follow the pointer"


def check_comparison(page, program, results):
    """A click with Shift picks a second block. Numbers, differences, distance and both curves are shown."""
    names = [f"{name}:{b}" for b in (4, 9) for name in ("x", "y", "dy", "speed")]
    row = history(program, results, names)[-1]
    page.evaluate("colour_by('dy')")
    page.click(*screen(page, row["x:4"], row["y:4"]))
    page.click(*screen(page, row["x:9"], row["y:9"]), shift=True)
    assert text(page, "block_name") == "Blocks 4 and 9"
    cells = page.evaluate("""Object.fromEntries([...$('numbers').tBodies[0].rows].map((row) =>
        [row.dataset.name, [...row.cells].slice(1).map((cell) => cell.textContent.replaceAll("−", "-"))]))""")
    for name in ("x", "y", "dy", "speed"):
        first, second, difference = cells[name]
        assert same_number(first, row[f"{name}:4"]) and same_number(second, row[f"{name}:9"]), (name, cells[name])
        exact = row[f"{name}:9"] - row[f"{name}:4"]
        near = 1.01e-5 * max(abs(row[f"{name}:9"]), abs(row[f"{name}:4"]))
        assert abs(float(difference) - exact) <= near, (name, difference, exact)
    about = text(page, "block_about")
    distance = math.hypot(row["x:9"] - row["x:4"], row["y:9"] - row["y:4"])
    assert abs(number(about.split("centroids: ")[1]) / distance - 1) < 1e-4, about
    assert f"Difference of displacement y: {cells['dy'][2].replace('-', '−')} m" in about, about
    drawn = """((name) => { const all = chart_pen.getImageData(0, 0, chart.width, chart.height).data; let n = 0;
        const [r, g, b] = channels(style(name).trim()).map((c) => Math.round(255 * c));
        for (let i = 0; i < all.length; i += 4) n += all[i] === r && all[i + 1] === g && all[i + 2] === b;
        return n; })"""
    assert page.evaluate(f"[{drawn}('--mark') > 60, {drawn}('--second') > 60]") == [True, True], "a curve is missing"
    page.click(*screen(page, row["x:9"], row["y:9"]), shift=True)
    assert page.evaluate("state.picked") == [3], "the same block again does not end the comparison"
    assert page.evaluate(f"{drawn}('--second')") == 0


def check_colours(page, program, results):
    """Maps and ranges give the blocks their colours. The automatic range is that of all times."""
    blocks = page.evaluate("meta.blocks")
    rows = history(program, results, [f"dy:{b}" for b in range(1, blocks + 1)])
    values = [row[f"dy:{b}"] for row in rows for b in range(1, blocks + 1)]
    last = [rows[-1][f"dy:{b}"] for b in range(1, blocks + 1)]
    page.evaluate("pick_first(-1); state.labels = false; colour_by('dy')")
    page.move(5, 5)
    ends = {"ylgnbu": ("#ffffd9", "#081d58"), "viridis": ("#440154", "#fde725"),
            "cividis": ("#00224e", "#fee838"), "grey": ("#f2f2f2", "#1c1c1c"), "bluered": ("#2166ac", "#b2182b")}
    assert list(ends) == page.evaluate("[...$('map').options].slice(1).map((one) => one.value)")
    seen = f"[...Array({blocks}).keys()].map((b) => pixel_at(...to_screen(...centre(b, state.frame))))"

    def expected(name, low, high, reverse):
        colours = page.evaluate(f"meta.maps.{name}.colours")
        colours = colours[::-1] if reverse else colours
        if name == "bluered" and 0 in (low, high):  # values of one sign have half of the map
            colours = colours[len(colours) // 2:] if low == 0 else colours[:len(colours) // 2 + 1]
        part = [min(1, max(0, (v - low) / (high - low))) for v in last]
        return [colours[math.floor(p * (len(colours) - 1) + 0.5)] for p in part]

    def check_pixels(name, low, high, reverse=False):
        page.drawn()
        colours, wanted = page.evaluate(seen), expected(name, low, high, reverse)
        right = sum(a == b for a, b in zip(colours[1:], wanted[1:]))  # The first block is hatched.
        assert right >= blocks - 2, (name, colours, wanted)

    most = max(map(abs, values))
    for name, (first, end) in ends.items():
        page.evaluate(f"$('map').value = '{name}'; $('map').dispatchEvent(new Event('change'))")
        low, high = min(0, min(values)), max(values)
        if name == "bluered":
            low, high = -most if low < 0 else 0, most if high > 0 else 0
        shown = page.evaluate("['low', 'high'].map((id) => Number($(id).placeholder))")
        assert shown == [float(f"{v:.4g}") for v in (low, high)], shown
        check_pixels(name, low, high)
        assert page.evaluate(f"[meta.maps.{name}.colours[0], meta.maps.{name}.colours.at(-1)]") == [first, end]
        page.evaluate("$('reversed').click()")
        check_pixels(name, low, high, True)
        page.evaluate("$('reversed').click()")
    assert page.evaluate("meta.maps.bluered.colours[32]") == "#f7f7f7", "zero is not in the middle"

    page.evaluate("$('map').value = 'viridis'; $('map').dispatchEvent(new Event('change'))")
    low, high = sorted(last)[2], sorted(last)[-3]
    for name, end in (("low", low), ("high", high)):
        page.evaluate(f"$('{name}').focus()")
        page.write(repr(end))
        page.key("Enter")
    check_pixels("viridis", low, high)
    assert page.evaluate("legend_parts(true)[0].is_cut") == [True, True]
    page.evaluate("$('high').focus(); $('high').select()")
    page.write(repr(2 * low - high))
    page.key("Enter")
    assert not page.evaluate("$('high').validity.valid"), "an empty range is accepted"
    check_pixels("viridis", low, high)
    page.evaluate("$('automatic').click()")
    check_pixels("viridis", min(0, min(values)), max(values))
    page.evaluate("use_map('')")


def saved(page, folder, name, act):
    """Returns the path of the file that the act saves."""
    path, end = folder / name, time.monotonic() + 20
    path.unlink(missing_ok=True)
    page.downloads(folder)
    act()
    while not path.exists() or path.stat().st_size == 0:
        assert time.monotonic() < end, f"{name} is not saved: {sorted(folder.iterdir())}"
        time.sleep(0.05)
    return path


def pressed(page, name):
    return lambda: page.evaluate(f"$('{name}').click()")


def check_files(page, program, results, folder):
    """The saved numbers are those of the file. The picture has twice the pixels, the legend and the scale bar."""
    page.key("End")
    page.evaluate("pick_first(3); pick_second(8); colour_by('dy')")
    page.drawn()
    blocks = page.evaluate("meta.blocks")
    with open(saved(page, folder, "stack_dy_t2.csv", pressed(page, "save_frame"))) as file:
        lines = list(csv.DictReader(file))
    row = history(program, results, [f"{name}:{b}" for b in range(1, blocks + 1) for name in ("x", "y", "dy")])[-1]
    assert [line["block"] for line in lines] == [str(b + 1) for b in range(blocks)]
    for line in lines:
        assert list(line) == ["block", "material", "x", "y", "dy"] and line["material"] == "1", line
        assert all(same_number(line[name], row[f"{name}:{line['block']}"]) for name in ("x", "y", "dy")), line

    with open(saved(page, folder, "stack_history_block4_block9.csv", pressed(page, "save_history"))) as file:
        lines = list(csv.DictReader(file))
    curves = [name for name in lines[0] if ":" in name]
    assert len(curves) == 2 * page.evaluate("meta.quantities.length")
    rows = history(program, results, curves)
    assert len(lines) == len(rows)
    for line, exact in zip(lines, rows):
        assert abs(float(line["time"]) - exact["time"]) < 1e-12
        assert all(same_number(line[name], exact[name]) for name in curves), line

    picture = saved(page, folder, "stack_t2.png", pressed(page, "save_picture")).read_bytes()
    size = struct.unpack(">II", picture[16:24])
    width, height = page.evaluate("[model.clientWidth, model.clientHeight]")
    assert size[0] > 2 * width and size[1] > 2 * height, (size, width, height)
    page.evaluate(f"""(async () => {{
        const bytes = Uint8Array.from(atob('{base64.b64encode(picture).decode()}'), (c) => c.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes])), sheet = document.createElement('canvas');
        [sheet.width, sheet.height] = [image.width, image.height];
        window.kept = sheet.getContext('2d', {{willReadFrequently: true}});
        kept.drawImage(image, 0, 0);
    }})()""")
    # The legend is to the right of the model and has the colours of the map; the bar is below the model.
    legend = page.evaluate("""(() => {
        const {width, height} = kept.canvas, from = 2 * (66 + model.clientWidth + 20), seen = new Set();
        const all = kept.getImageData(from, 0, width - from, height).data;
        for (let i = 0; i < all.length; i += 4) seen.add(shade_of(all.subarray(i, i + 3)));
        const q = quantity(state.colour), wanted = colours_of(q, colour_range(q));
        return wanted.filter((shade) => seen.has(shade)).length / wanted.length; })()""")
    assert legend > 0.92, f"{legend} of the colours of the map are in the legend"
    longest = page.evaluate("""(() => {
        const top = 2 * (40 + model.clientHeight + 40), w = kept.canvas.width, ink = style('--ink').trim();
        let longest = 0;
        for (let y = top; y < kept.canvas.height; ++y) {
          const line = kept.getImageData(0, y, w, 1).data;
          for (let x = 0, run = 0; x < w; ++x) {
            run = shade_of(line.subarray(4 * x, 4 * x + 3)) === ink ? run + 1 : 0;
            longest = Math.max(longest, run);
          }
        }
        return longest / (2 * scale_bar().width); })()""")
    assert abs(longest - 1) < 0.03, f"the scale bar of the picture has {longest} of its length"


def check_legend(page):
    """No part of the page covers the model. The legend is beside it, or below it in a narrow window."""
    page.evaluate("colour_by('speed'); state.forces || toggle('forces')")
    for width, height in ((1400, 900), (1000, 700), (880, 760), (700, 900), (500, 800)):
        page.size(width, height)
        time.sleep(0.1)
        page.drawn()
        boxes = page.evaluate("""Object.fromEntries(['model', 'legend', 'key', 'strip', 'side', 'clock'].map((id) => {
            const b = $(id).getBoundingClientRect(); return [id, [b.left, b.top, b.right, b.bottom]]; }))""")
        model = boxes.pop("model")
        assert model[2] - model[0] > 0.4 * width and model[3] - model[1] > 180, (width, model)
        for name, box in boxes.items():
            apart = box[0] >= model[2] or box[2] <= model[0] or box[1] >= model[3] or box[3] <= model[1]
            assert apart, f"{name} covers the model in a window {width} wide: {box}, {model}"
        below = boxes["legend"][1] >= model[3]
        assert below == (width <= 900), (width, boxes)
        # What is drawn is inside its canvas.
        texts = page.evaluate("written(key_pen, draw_colours)")
        room = page.evaluate("[key.clientWidth, key.clientHeight]")
        assert len(texts) > 5 and all(0 <= x < room[0] and 0 <= y < room[1] for _, x, y in texts), (texts, room)
        # Everything is in view, also after the window has changed its size.
        left, right = page.evaluate("""(() => { const all = [...corners].filter((_, i) => i % 2 === 0);
            return [Math.min(...all), Math.max(...all)].map((x) => to_screen(x, 0)[0]); })()""")
        assert 0 < left < right < model[2] - model[0], (left, right, model)
    page.evaluate("toggle('forces')")
    page.size(1300, 820)
    page.drawn()


def check_keyboard(page, folder):
    """All is done with keys: Tab reaches every control, and its focus is visible."""
    page.evaluate("colour_by('speed'); pick_first(-1); document.activeElement.blur(); show(0)")
    page.drawn()
    reached = []
    for _ in range(60):
        page.key("Tab")
        name, outline = page.evaluate("""(() => { const at = document.activeElement;
            return [at.id || at.dataset.name || at.tagName, getComputedStyle(at).outlineStyle]; })()""")
        if name in reached:
            break
        if name == "BODY":  # between the last control and the first one
            continue
        reached.append(name)
        assert outline not in ("none", ""), f"the focus on {name} is not visible"
    wanted = page.evaluate("""[...document.querySelectorAll('button, input, select, #model')]
        .filter((one) => one.offsetParent && !one.disabled && !one.closest('dialog')).map((one) => one.id)""")
    assert len(wanted) > 20 and set(wanted) <= set(reached), set(wanted) - set(reached)
    start = reached.index(wanted[0])
    order = [name for name in reached[start:] + reached[:start] if name in wanted]
    assert order == wanted, f"Tab does not follow the page: {order}"
    rows = page.evaluate("[...$('numbers').tBodies[0].rows].map((row) => row.dataset.name)")
    assert len(set(reached) & set(rows)) == 1, "the table needs more than one stop"

    def value(expression):
        page.drawn()
        return page.evaluate(expression)

    # A menu that has the focus: arrows choose in it, and all other keys keep their meaning.
    tab_to(page, "document.activeElement.id === 'colour'")
    before = value("state.colour")
    page.key("ArrowDown")
    assert value("state.colour") != before and value("document.activeElement.id") == "colour"
    now = value("state.colour")
    page.key("ArrowRight")
    page.key("ArrowRight")
    assert value("state.frame") == 2 and value("state.colour") == now == value("$('colour').value")
    page.key(" ")
    assert value("state.playing")
    page.key(" ")
    assert not value("state.playing") and value("$('colour').value") == now
    page.key("End")
    page.key("s")
    assert value("state.colour") == now == value("$('colour').value"), "the menu takes a letter"
    page.key("k")
    assert value("state.map") == "ylgnbu" == value("$('map').value")

    page.key("r")
    assert value("document.activeElement.id") == "low"
    page.write("0.25")
    page.key("Tab")
    page.write("0.75")
    page.key("Enter")
    assert value("colour_range(quantity(state.colour))") == [0.25, 0.75]
    assert value("document.activeElement.id") == "model"
    page.key("a")
    assert value("colour_range(quantity(state.colour)).join() === automatic_range(quantity(state.colour)).join()")

    page.key("b")
    page.write("4")
    page.key("Tab")
    page.write("9")
    page.key("Enter")
    assert value("state.picked") == [3, 8]
    page.key(".")
    page.key(">")
    assert value("state.picked") == [4, 9]
    page.key(",")
    page.key("<")
    assert value("state.picked") == [3, 8]
    page.key("Escape")
    assert value("state.picked") == []

    page.key("x")
    page.evaluate("window.there = centre(6, state.frame).slice(); 0")
    for _ in range(80):  # The crosshair goes to block 7 in steps of the arrows.
        dx, dy = value("to_screen(...there).map((at, i) => at - [model.clientWidth, model.clientHeight][i] / 2)")
        if abs(dx) <= 20 and abs(dy) <= 20:
            break
        across, down = "ArrowRight" if dx > 0 else "ArrowLeft", "ArrowDown" if dy > 0 else "ArrowUp"
        page.key(across if abs(dx) > abs(dy) else down, shift=True)
    for _ in range(8):
        page.key("+")
        if value("hovered.block") == 6:
            break
    assert value("hovered.block") == 6 and not value("$('tip').hidden"), (dx, dy)
    page.key("Enter")
    assert value("state.picked") == [6]
    page.key("x")
    page.key("f")

    tab_to(page, "document.activeElement.tagName === 'TR'")
    before = value("state.followed")
    page.key("ArrowDown")
    assert value("state.followed") != before and value("document.activeElement.dataset.name === state.followed")

    page.key("?")
    assert value("$('keys').open")
    help_text = text(page, "key_list")
    for name in page.evaluate("Object.keys(actions)"):
        word = {" ": "space", "-": "−", "=": "+", "0": "F", "Escape": "Esc"}.get(name, name)
        word = word.upper() if len(word) == 1 else word.split()[-1]
        word = {"ArrowLeft": "←", "ArrowRight": "→", "ArrowUp": "↑", "ArrowDown": "↓"}.get(word, word)
        assert word in help_text, f"the help does not list {name}"
    page.key("Escape")
    assert not value("$('keys').open")

    page.key("Home")
    saved(page, folder, "stack_t0.png", lambda: page.key("p"))


def check_keys_after_pointer(page):
    """After a click in a menu or on a button the space bar plays, and arrows step."""
    page.evaluate("colour_by('speed'); show(0)")
    page.drawn()
    page.click(*middle(page, "#colour"))
    page.key("ArrowDown")
    page.key("Enter")
    page.wait("state.colour !== 'speed'")
    chosen = page.evaluate("state.colour")
    page.key("ArrowDown")
    page.key("ArrowRight")
    assert page.evaluate("[state.colour, state.frame]") == [chosen, 1]
    for selector in ("#fit", "#forces", "#forces", "#next"):
        page.click(*middle(page, selector))
        before = page.evaluate("[state.forces, state.view.scale]")
        page.key(" ")
        assert page.evaluate("state.playing"), f"after a click on {selector} the space bar does not play"
        page.key(" ")
        assert page.evaluate("[state.forces, state.view.scale]") == before
    page.key("Home")


def check_visibility(page):
    """Outlines of blocks and contact forces differ from every ground."""
    grounds = "[...Object.values(meta.materials), ...Object.values(meta.maps).flatMap(({colours}) => colours)]"
    weak = page.evaluate(grounds + """.filter((shade) =>
        contrast(shade, strong_outline(shade)) < 1.9 || contrast(shade, faint_outline(shade)) < 1.2)""")
    assert not weak, f"outlines are weak on {weak}"
    assert not page.evaluate("meta.intensity.filter((shade) => contrast(shade, rim_of_line(shade)) < 3)")
    page.key("End")
    page.evaluate("pick_first(-1); colour_by('speed'); use_map('grey'); fit()")
    page.move(5, 5)
    # All blocks have the first colour of the map, because no value reaches the range.
    page.evaluate("state.typed.speed = [1e3, 2e3]; redraw()")
    for reverse in (False, True):
        page.evaluate(f"state.reversed = {str(reverse).lower()}; state.forces = false; redraw()")
        page.drawn()
        # From the middle of a brick up to the middle of the one above it, which has the same colour.
        ground, contrasts = page.evaluate("""(() => {
            const [px, py] = to_screen(...centre(3, state.frame)), [, above] = to_screen(...centre(4, state.frame));
            const ground = pixel_at(px, py);
            const steps = [...Array(Math.round(py - above)).keys()];
            return [ground, steps.map((i) => contrast(ground, pixel_at(px, py - i)))]; })()""")
        assert contrasts[0] == contrasts[-1] == 1 and max(contrasts) > 1.8, f"no outline on {ground}: {contrasts}"
        for draft in (False, True):
            page.evaluate(f"state.forces = true; draft_above = {-1 if draft else 3000}; redraw()")
            page.drawn()
            low, high = page.evaluate("""(() => {  // luminances across the largest and the smallest force
            if (draft_above < 0) { moves(); draw(); }
            const lines = force_lines(state.frame, [corners]).sort((a, b) => a[4] - b[4]);
            const around = ([x0, y0, x1, y1]) => {  // above the middle, which is on an outline
              const at = y0 < y1 ? 0.25 : 0.75, length = Math.hypot(x1 - x0, y1 - y0), l = [];
              const [mx, my] = [x0 + at * (x1 - x0), y0 + at * (y1 - y0)];
              const [u, v] = [-(y1 - y0) / length, (x1 - x0) / length];
              for (let s = -4; s <= 4; ++s) l.push(luminance(pixel_at(mx + s * u, my + s * v)));
              return l; };
            return [around(lines[0]), around(lines.at(-1))]; })()""")
            for line in (low, high):
                visible = (max(line) + 0.05) / (min(line) + 0.05) > 3
                assert visible, f"a force is not visible on {ground} in a {'draft' if draft else 'fine'} picture: {line}"
        page.evaluate("draft_above = 3000")
    page.evaluate("state.reversed = state.forces = false; use_map(''); automatic(); colour_by('material')")


def check(page, program, source, folder):
    deck = source / "decks/stack/stack.deck"
    results, unitless = run(program, deck, folder), folder / "unitless.deck"
    unitless.write_text("".join(line for line in deck.open() if not line.startswith("UNITS")))
    show(page, program, run(program, unitless, folder), folder / "unitless.html")
    page.evaluate(HELP)
    check_axes(page, "")
    show(page, program, results, folder / "stack.html")
    page.evaluate(HELP)
    check_axes(page, "m")
    assert page.evaluate("legend_parts(true)[0].swatches[0].name") == "brick"
    check_cursor(page, program, results)
    check_comparison(page, program, results)
    check_colours(page, program, results)
    check_files(page, program, results, folder)
    check_legend(page)
    check_keyboard(page, folder)
    check_keys_after_pointer(page)
    check_visibility(page)
    assert not page.faults(), page.faults()
    assert not page.requests(), page.requests()
    print("axes, cursor, comparison, colours, files, legend, keyboard and visibility are as described")


with_browser(check)
