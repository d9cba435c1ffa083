#!/usr/bin/python3
"""Figures of docs/contact-rule.md: contact_rule.py writes rule-*.svg beside itself."""

from picture import ACTS, HIDDEN, INK, OTHER, ROCK, Picture


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
    p.box(570, 150, 250, ["L is used instead"], OTHER)
    p.box(570, 225, 250, ["contacts along X; if none acts", "and X is E: L instead, or nothing",
                          "if X is an inner side"], OTHER)
    p.box(570, 328, 250, ["hidden a third time: E is used instead"], OTHER)
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
