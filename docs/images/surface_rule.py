#!/usr/bin/python3
"""Figures of docs/surface-rule.md: surface_rule.py writes surface-*.svg beside itself."""

from picture import ACTS, HIDDEN, INK, OTHER, ROCK, Picture


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
    p.save("surface-slides.svg")


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
    p.save("surface-notch.svg")


if __name__ == "__main__":
    for figure in (slides, notch):
        figure()
