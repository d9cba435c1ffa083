#!/usr/bin/python3
"""Figures of the time step for docs/architecture.md: step.py writes step-*.svg beside itself."""

from picture import ACTS, HIDDEN, INK, OTHER, ROCK, Picture


def arrow_down(p, x, y, length=22):
    """An arrow between two boxes of a column."""
    p.line((x, y), (x, y + length), INK, 1.5, arrow=True)


def data_flow():
    """The six calls of a step, with the data that each reads and writes."""
    p = Picture(760, 520)
    calls = [("1  update_pairs", "near pairs", "corners, velocities"),
             ("2  decide_contacts", "contacts that may act", "blocks, their net motion"),
             ("3  find_contact_forces", "springs, forces of pairs", "blocks, springs"),
             ("4  add_loads", "forces of blocks", "planes, loads, time"),
             ("5  move_blocks", "velocities, strain, corners", "forces of pairs and blocks"),
             ("6  update_domain", "blocks that left", "corners")]
    for k, (call, writes, reads) in enumerate(calls):
        y = 50 + 76 * k
        p.box(130, y, 210, [reads], ROCK)
        p.box(380, y, 200, [call], "#fdf3d8")
        p.box(635, y, 200, [writes], OTHER)
        p.line((235, y + 15), (278, y + 15), INK, 1.5, arrow=True)
        p.line((480, y + 15), (533, y + 15), INK, 1.5, arrow=True)
        if k < 5:
            arrow_down(p, 380, y + 31, 43)
    for x, title in ((130, "reads"), (380, "call"), (635, "writes")):
        p.text(x, 30, title, size=14)
    p.text(380, 505, "The time is advanced between 5 and 6. Call 1 does nothing until corners have moved far enough.",
           HIDDEN, size=12)
    p.save("step-data.svg")


def life_of_a_contact():
    """From two near blocks to the force and to the end of a contact."""
    p = Picture(760, 460)
    left, right = 200, 560
    p.box(left, 20, 300, ["near pair: the boxes of two blocks meet"], ROCK)
    arrow_down(p, left, 51)
    p.box(left, 75, 300, ["decision: corner c may act on edge e,", "as long as the blocks move little"], ROCK)
    arrow_down(p, left, 123)
    p.box(left, 147, 300, ["slot in the lane of the pair: c, e, springs 0"], ROCK)
    arrow_down(p, left, 178)
    p.box(left, 202, 300, ["each step: is c inside e (19)", "and between its ends?"], "#fdf3d8")
    arrow_down(p, left, 250, 36)
    p.text(left + 14, 272, "yes", ACTS, "start", 12)
    p.box(left, 288, 300, ["it acts: the springs advance, the dashpot", "and friction follow, forces are summed"], OTHER)
    p.line((left - 150, 312), (left - 180, 312), INK, 1.5)
    p.line((left - 180, 312), (left - 180, 226), INK, 1.5)
    p.line((left - 180, 226), (left - 152, 226), INK, 1.5, arrow=True)
    p.text(left - 190, 345, "next step", INK, "start", 12)
    p.line((left + 150, 226), (right - 152, 226), INK, 1.5, arrow=True)
    p.text(left + 168, 219, "no", ACTS, "start", 12)
    p.box(right, 202, 300, ["it does not act. If it acted in the step", "before, its springs are released"], "#fdf3d8")
    arrow_down(p, right, 250, 36)
    p.box(right, 288, 300, ["successor: a contact of the same corner", "or of the same faces takes the springs over"], OTHER)
    arrow_down(p, right, 336)
    p.text(right + 14, 354, "none", ACTS, "start", 12)
    p.box(right, 360, 300, ["the springs are lost"], ROCK)
    p.line((right, 147), (left + 160, 161), INK, 1.5, arrow=True)
    p.box(right, 116, 300, ["a decision expires when the blocks have", "moved far enough; it is then made again"], ROCK)
    p.text(380, 440, "A contact that loses its slot while its springs are loaded releases them, too.", HIDDEN, size=12)
    p.save("step-contact.svg")


if __name__ == "__main__":
    data_flow()
    life_of_a_contact()
