#!/usr/bin/python3
"""Figures of docs/contact-rule.md: it writes rule-*.svg here."""

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


def carries():
    """A corner beside a joint by rounding: the pair is left to T, which carries the block."""
    p = Picture(780, 270)
    for x, aside, title in ((20, 3, "doubtful: own is left to T, which carries"),
                            (410, 40, "not doubtful: own and T act")):
        joint, left = x + 190, x + 190 - aside
        p.block([(x, 130), (joint, 130), (joint, 230), (x, 230)], ROCK, "own", (x + 40, 205))
        p.block([(joint, 130), (x + 350, 130), (x + 350, 230), (joint, 230)], ROCK, "T",
                (x + 310, 205))
        p.block([(left, 40), (x + 300, 40), (x + 300, 150), (left, 150)], OTHER, "other",
                (x + 250, 75))
        p.line((joint, 130), (joint, 230), HIDDEN, 3)
        p.line((x, 130), (joint, 130), INK if aside < 10 else ACTS, 3)
        p.dot(x + 300, 150)
        p.dot(joint, 130)
        if aside < 10:
            p.text(joint - 10, 100, "overlap within the slack", INK, "end", 12)
            p.line((joint - 60, 106), (joint - 6, 138), INK, 1, arrow=True)
        else:
            p.dot(left, 150)
        p.text(joint + 6, 190, "hidden by T", HIDDEN, "start", 12)
        p.text(x + 175, 258, title, INK, "middle", 12)
    p.save("rule-carries.svg")


def far():
    """A far corner, and a deep tip that is not far because a third part holds it."""
    p = Picture(780, 290)
    p.block([(40, 80), (250, 120), (40, 150)], ROCK, "own", (75, 122))
    p.block([(262, 90), (330, 90), (330, 240), (176, 240)], OTHER, "other", (285, 200))
    p.line((40, 80), (250, 120), HIDDEN, 3)
    p.text(140, 85, "e", HIDDEN)
    p.line((202, 110), (176, 240), HIDDEN, 1.5, dashed=True)
    p.text(180, 180, "d", HIDDEN, "end")
    p.dot(176, 240, HIDDEN)
    p.text(256, 72, "common region", INK, "end", 12)
    p.line((236, 78), (247, 115), INK, 1, arrow=True)
    p.text(185, 278, "far: 10 times as deep as the common region", HIDDEN, "middle", 12)
    p.block([(420, 90), (640, 90), (420, 150)], ROCK, "own", (470, 115))
    p.block([(640, 90), (720, 90), (720, 240), (420, 240), (420, 150)], ROCK, "T", (480, 210))
    p.block([(604, 60), (636, 60), (620, 165)], OTHER)
    p.text(620, 48, "other")
    p.line((420, 90), (640, 90), ACTS, 3)
    p.text(530, 82, "e", ACTS)
    p.line((648, 90), (648, 160), ACTS, 1.5, dashed=True)
    p.text(656, 135, "d", ACTS, "start")
    p.dot(620, 165)
    p.text(570, 278, "not far: the tip is as deep in T, a third part", ACTS, "middle", 12)
    p.save("rule-far.svg")


def local():
    """The ray from the contact point, and the circle around a corner."""
    p = Picture(800, 290)
    for x, gap, title, colour in ((20, 12, "T is met within w: local", HIDDEN),
                                  (290, 70, "T is not met within w", ACTS)):
        joint = x + 130
        p.block([(x, 150), (joint - gap, 150), (joint - gap, 250), (x, 250)], ROCK, "T",
                (x + 25, 225))
        p.block([(joint, 150), (joint + 100, 150), (joint + 100, 250), (joint, 250)], ROCK, "own",
                (joint + 65, 225))
        p.block([(x + 40, 60), (joint + 22, 60), (joint + 22, 190), (x + 40, 190)], OTHER, "other",
                (x + 85, 95))
        p.line((joint, 150), (joint, 250), colour, 3)
        p.line((joint, 170), (joint - 40, 170), INK, 1.8, arrow=True)
        p.text(joint - 20, 164, "w", INK, "middle", 12)
        p.dot(joint, 170, colour)
        p.text(x + 115, 280, title, colour, "middle", 12)
    p.block([(560, 150), (665, 150), (665, 250), (560, 250)], ROCK, "T", (590, 225))
    p.block([(669, 150), (780, 150), (780, 250), (669, 250)], ROCK, "other", (740, 225))
    p.block([(648, 40), (712, 40), (680, 190)], OTHER, "own", (680, 65))
    p.line((712, 40), (680, 190), HIDDEN, 3)
    p.ring(669, 150, 24)
    p.text(650, 132, "w", INK, "end", 12)
    p.dot(669, 150, HIDDEN)
    p.text(670, 280, "corner, no facing side: local", HIDDEN, "middle", 12)
    p.save("rule-local.svg")


def slides():
    """A slider that is shifted out of the next box, and slides up until it leaves T."""
    p = Picture(800, 300)
    for x, top, title, rest, colour in (
            (20, 150, "flush: nothing is left, hidden", 0, HIDDEN),
            (290, 138, "ledge lower than the slide: hidden", 12, HIDDEN),
            (560, 70, "step: more is left than the slide, acts", 80, ACTS)):
        joint = x + 130
        p.block([(x, 150), (joint, 150), (joint, 250), (x, 250)], ROCK, "T", (x + 50, 220))
        p.block([(joint, top), (joint + 100, top), (joint + 100, 250), (joint, 250)], ROCK, "own",
                (joint + 65, 220))
        p.block([(x + 30, 60), (joint + 22, 60), (joint + 22, 180), (x + 30, 180)], OTHER, "other",
                (x + 75, 95))
        p.line((joint, top), (joint, 250), colour, 3)
        # The shift and the slide of the lower right corner.
        p.line((joint + 22, 180), (joint + 2, 180), INK, 1.5, arrow=True)
        p.line((joint - 3, 180), (joint - 3, 152), INK, 1.5, arrow=True)
        p.text(joint - 10, 171, "t", INK, "end", 13)
        if rest:
            p.line((joint - 3, 150), (joint - 3, 150 - rest), colour, 1.5, dashed=True)
        p.dot(joint + 22, 180, colour)
        p.text(x + 115, 280, title, colour, "middle", 12)
    p.save("rule-slides.svg")


def notch():
    """The tip of a wedge below the bottom of a notch acts on both flanks."""
    p = Picture(560, 270)
    p.block([(60, 60), (260, 180), (260, 250), (60, 250)], ROCK, "own", (120, 225))
    p.block([(260, 180), (460, 60), (460, 250), (260, 250)], ROCK, "T", (400, 235))
    p.block([(222, 30), (318, 30), (270, 200)], OTHER, "other", (270, 70))
    p.line((60, 60), (260, 180), ACTS, 3)
    p.line((260, 182), (260, 250), HIDDEN, 3)
    # The foot of the tip on the line of the left flank.
    p.line((260, 180), (277, 190), INK, 1, dashed=True)
    p.line((270, 200), (277, 190), INK, 1.5)
    p.dot(270, 200)
    p.text(300, 196, "foot beyond the end, in T", INK, "start", 12)
    p.text(20, 20, "this side has no end in the notch", ACTS, "start", 12)
    p.text(252, 265, "hidden by T", HIDDEN, "end", 12)
    p.save("rule-notch.svg")


if __name__ == "__main__":
    for figure in (axis, carries, faces, far, local, slides, notch):
        figure()
