#!/usr/bin/python3
"""Figures of docs/contact-rule.md: contact_rule.py writes rule-*.svg beside itself.

Lengths are in pixels, y points down as in SVG.
"""

from html import escape
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROCK, OTHER, INK, ACTS, HIDDEN = "#d9e2ea", "#efe3d3", "#333333", "#c0392b", "#1f6fb2"


class Picture:
    """Elements of one SVG file."""

    def __init__(self, width, height):
        self.width, self.height, self.parts = width, height, []

    def block(self, points, colour=ROCK, label="", at=None):
        """A filled polygon with its name."""
        path = " ".join(f"{x},{y}" for x, y in points)
        self.parts.append(f'<polygon points="{path}" fill="{colour}" fill-opacity="0.8" '
                          f'stroke="{INK}" stroke-width="1.5"/>')
        if label:
            self.text(*at, label)

    def line(self, a, b, colour=INK, width=1.5, dashed=False, arrow=False):
        """A line, with an arrow head at b on request."""
        self.parts.append(
            f'<line x1="{a[0]}" y1="{a[1]}" x2="{b[0]}" y2="{b[1]}" stroke="{colour}" '
            f'stroke-width="{width}"' + (' stroke-dasharray="5 4"' if dashed else "") +
            (' marker-end="url(#head)"' if arrow else "") + "/>")

    def dot(self, x, y, colour=ACTS):
        """A contact, or the corner of an axis."""
        self.parts.append(f'<circle cx="{x}" cy="{y}" r="4.5" fill="{colour}"/>')

    def text(self, x, y, text, colour=INK, anchor="middle", size=13):
        """Text around or beside a point."""
        self.parts.append(f'<text x="{x}" y="{y}" fill="{colour}" text-anchor="{anchor}" '
                          f'font-size="{size}">{escape(text)}</text>')

    def box(self, x, y, width, lines, colour="white"):
        """A box of a flow chart, as high as its lines; x is its middle."""
        height = 14 + 17 * len(lines)
        self.parts.append(f'<rect x="{x - width / 2}" y="{y}" width="{width}" height="{height}" '
                          f'rx="5" fill="{colour}" stroke="{INK}"/>')
        for k, line in enumerate(lines):
            self.text(x, y + 21 + 17 * k, line, size=12.5)

    def save(self, name):
        """Writes the file."""
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
                f'width="{self.width}" height="{self.height}" '
                'font-family="DejaVu Sans, sans-serif">\n'
                '<defs><marker id="head" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" '
                f'markerHeight="8" orient="auto-start-reverse"><path d="M0 0L10 5L0 10z" '
                f'fill="{INK}"/></marker></defs>\n'
                f'<rect width="{self.width}" height="{self.height}" fill="white"/>\n')
        (HERE / name).write_text(head + "\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")


def axis():
    """The depth of three sides: an axis is a side with the corner deepest below it."""
    p = Picture(720, 280)
    p.block([(70, 160), (400, 160), (400, 260), (70, 260)], ROCK, "A", (235, 235))
    p.block([(250, 60), (440, 100), (310, 195), (230, 130)], OTHER, "B", (330, 105))
    p.dot(310, 195)
    p.line((310, 163), (310, 188), ACTS, 2)
    p.text(298, 184, "d", ACTS, "end")
    p.line((230, 130), (396, 130), HIDDEN, 1.2, dashed=True)
    p.line((400, 130), (400, 160), INK, 1, dashed=True)
    p.dot(230, 130, HIDDEN)
    p.text(460, 165, "axis of the upper side of A: its corner is", ACTS, "start", 11)
    p.text(460, 181, "the lowest one of B, its depth d is least", ACTS, "start", 11)
    p.text(460, 215, "axis of the right side of A: its corner", HIDDEN, "start", 11)
    p.text(460, 231, "is the leftmost one of B, much deeper", HIDDEN, "start", 11)
    p.save("rule-axis.svg")


def faces():
    """Contacts of aligned faces, offset faces and of a corner on an edge."""
    p = Picture(720, 220)
    for x, left, right, title in ((30, 0, 0, "aligned faces: four contacts"),
                                  (265, 70, 70, "offset faces: two contacts")):
        p.block([(x, 110), (x + 130, 110), (x + 130, 190), (x, 190)], ROCK)
        p.block([(x + left, 40), (x + 130 + right, 40), (x + 130 + right, 122),
                 (x + left, 122)], OTHER)
        ends = [(x + left, 122), (x + 130, 110)]
        if not left:
            ends += [(x, 110), (x + 130, 122)]
        for end in ends:
            p.dot(*end)
        p.text(x + 65 + left / 2, 214, title, size=12)
    p.block([(520, 110), (700, 110), (700, 190), (520, 190)], ROCK)
    p.block([(560, 40), (660, 60), (622, 122), (575, 100)], OTHER)
    p.dot(622, 122)
    p.text(610, 214, "no side faces it: one contact", size=12)
    p.save("rule-faces.svg")


def joint():
    """A stake on a closed joint: the sides of the joint are covered, its surfaces carry."""
    p = Picture(600, 290)
    p.block([(40, 150), (300, 150), (300, 270), (40, 270)], ROCK, "T", (150, 220))
    p.block([(300, 150), (560, 150), (560, 270), (300, 270)], ROCK, "A", (450, 220))
    p.block([(250, 40), (370, 40), (312, 185)], OTHER, "B", (310, 75))
    p.line((300, 150), (300, 270), HIDDEN, 3)
    p.line((302, 150), (560, 150), ACTS, 3)
    p.dot(312, 185)
    p.text(308, 262, "g: side of A that T covers, hidden", HIDDEN, "start", 12)
    p.text(440, 140, "s: surface of the joint, takes over", ACTS, "middle", 12)
    p.line((318, 183), (345, 183), INK, 1)
    p.text(350, 187, "tip: nearest to g, but acts on s", INK, "start", 12)
    p.save("rule-joint.svg")


def choice():
    """The steps of the choice as a flow chart."""
    p = Picture(720, 465)
    p.box(220, 10, 330, ["L: the axis of least depth"])
    p.box(220, 76, 330, ["Is L deeper than 0?"])
    p.box(220, 142, 330, ["E: first entered axis in the order of depth.", "Is there one?"])
    p.box(220, 225, 330, ["X is E at first. Does a closed joint hide X?"])
    p.box(220, 320, 330, ["X: least axis of the surfaces of the joints",
                          "that hide it (at most twice)"])
    p.box(570, 76, 250, ["contacts along L"], OTHER)
    p.box(570, 150, 250, ["L stands in"], OTHER)
    p.box(570, 225, 250, ["contacts along X; if none acts", "and X is E: L stands in, or nothing",
                          "if X is an inner side"], OTHER)
    p.box(570, 328, 250, ["hidden a third time: E stands in"], OTHER)
    p.box(570, 400, 250, ["the second surface is the side of E:",
                          "the first one is not hidden"], OTHER)
    for top, end, word in ((41, 76, ""), (107, 142, "yes"), (190, 225, "yes"), (256, 320, "yes")):
        p.line((220, top), (220, end), arrow=True)
        p.text(230, (top + end) / 2 + 6, word, anchor="start", size=12)
    for y, word in ((92, "no"), (166, "no"), (241, "no"), (344, "")):
        p.line((385, y), (445, y), arrow=True)
        p.text(415, y - 6, word, size=12)
    p.line((385, 360), (445, 416), arrow=True)
    p.line((55, 344), (30, 344))
    p.line((30, 344), (30, 241))
    p.line((30, 241), (55, 241), arrow=True)
    p.save("rule-choice.svg")


if __name__ == "__main__":
    for figure in (axis, faces, joint, choice):
        figure()
