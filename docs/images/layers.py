#!/usr/bin/python3
"""Figures of layers for docs/theory.md: layers.py writes layer-*.svg beside itself."""

from picture import ACTS, HIDDEN, INK, OTHER, ROCK, Picture

BOTTOM, TOP = 200, 70


def sides(p, bottom, top, colours=None, shift=0):
    """Blocks between sides; each side joins its place on the bottom line to that on the top line."""
    for k in range(len(bottom) - 1):
        colour = colours[k] if colours else ROCK
        p.block([(bottom[k] + shift, BOTTOM), (top[k] + shift, TOP), (top[k + 1] + shift, TOP),
                 (bottom[k + 1] + shift, BOTTOM)], colour)


def corners():
    """Corners of LAYER, its lines, and the corners of its blocks."""
    p = Picture(640, 290)
    bottom, top = [90, 190, 330, 420, 550], [130, 215, 335, 410, 520]
    for k in range(4):
        p.block([(bottom[k], 210), (top[k], 80), (top[k + 1], 80), (bottom[k + 1], 210)], ROCK)
        p.text((bottom[k] + bottom[k + 1] + top[k] + top[k + 1]) / 4, 172, f"{k + 1}", size=15)
    p.line((110, 145), (535, 145), HIDDEN, 1.3, dashed=True)
    p.text(600, 149, "mid-line", HIDDEN, size=12)
    for (x, y), (dx, dy), name in (((90, 210), (-14, 22), "1  bottom left"), ((130, 80), (-14, -12), "2  top left"),
                                   ((520, 80), (20, -12), "3  top right"), ((550, 210), (14, 22), "4  bottom right")):
        p.dot(x, y)
        p.text(x + dx, y + dy, name, ACTS, size=13)
    p.text(325, 66, "top line, from corner 2 to corner 3", size=12)
    p.text(320, 232, "bottom line, from corner 1 to corner 4", size=12)
    for (x, y), name in (((198, 203), "BL"), ((226, 96), "TL"), ((318, 96), "TR"), ((316, 203), "BR")):
        p.text(x + (6 if name in ("BL",) else 0), y, name, INK, size=10.5)
    p.text(320, 276, "Blocks are numbered from left to right; each has the corners BL, TL, TR, BR (clockwise).",
           size=12)
    p.save("layer-corners.svg")


def orient():
    """ORIENT: sides before and after they turn about their places on the mid-line."""
    p = Picture(720, 290)
    places, tangents = [30, 100, 170, 215, 330], [0.0, 0.25, -0.12, 0.3, 0.0]
    sides(p, places, places)
    half = (BOTTOM - TOP) / 2
    sides(p, [x + t * half for x, t in zip(places, tangents)], [x - t * half for x, t in zip(places, tangents)],
          shift=360)
    middle = (TOP + BOTTOM) / 2
    for shift in (0, 360):
        p.line((30 + shift, middle), (330 + shift, middle), HIDDEN, 1.2, dashed=True)
        for x in places[1:-1]:
            p.dot(x + shift, middle, HIDDEN)
    p.text(180, 45, "before: sides normal to the mid-line")
    p.text(540, 45, "after ORIENT: each side has an angle of its own")
    x, t = places[3] + 360, tangents[3]
    p.line((x, middle), (x, TOP - 2), ACTS, 1.3, dashed=True)
    p.text(x + 4, TOP + 22, "angle", ACTS, "start", 11)
    p.text(360, 250, "A side turns about its place on the mid-line, anticlockwise if the angle is positive. It may not cross",
           size=12)
    p.text(360, 268, "a neighbour on the bottom or top line: it is drawn again, and at last it takes a line between both.",
           size=12)
    p.save("layer-orient.svg")


def merge():
    """MERGE: narrow blocks before and after they are absorbed."""
    p = Picture(720, 270)
    places = [30, 110, 128, 210, 232, 246, 320]
    narrow = [b - a < 26 for a, b in zip(places, places[1:])]
    sides(p, places, places, [OTHER if n else ROCK for n in narrow])
    kept = [30, 110, 210, 320]
    sides(p, kept, kept, [ROCK, OTHER, OTHER], shift=360)
    for x in (128, 232, 246):
        p.line((x + 360, TOP), (x + 360, BOTTOM), INK, 1, dashed=True)
    for a, b in ((119, 165), (221, 239), (239, 283)):
        p.line((a, 222), (b, 222), ACTS, 1.5, arrow=True)
    p.text(175, 45, "before: widths drawn at random")
    p.text(535, 45, "after MERGE: no block is narrower")
    p.text(360, 255, "A block with width / height < aratio is absorbed by its right neighbour, the last block by its left one.",
           size=12)
    p.save("layer-merge.svg")


if __name__ == "__main__":
    corners()
    orient()
    merge()
