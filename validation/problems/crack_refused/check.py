"""Blocks that reach their strength and stay whole: the counts of the summary."""

from suite import cracking
from suite.deck import turned, with_lines

LENGTH = "quick"
SMALL, THIN = "a piece would be smaller than amin", "a piece would be too thin for the time step"
CORNERS, FULL = "a piece would have more corners than START allows", "START allows no more blocks"


def told(run):
    """Cracks and refusals in words, and the children in the order of their parents."""
    pairs = [f"{crack['parent']}>{crack['child']}" for crack in run.cracks]
    refused = [f"{why}: {', '.join(map(str, blocks))}"
               for why, blocks in run.summary["refused_cracks"].items()]
    return "; ".join([" ".join(pairs) or "none", *refused])


def children(parents, first):
    return " ".join(f"{parent}>{first + k}" for k, parent in enumerate(parents))


def numbers(blocks):
    return ", ".join(map(str, blocks))


def steps(run):
    return numbers(sorted({crack["step"] for crack in run.cracks})) or "none"


def pulled(text, pressure):
    return text.replace("-1.5E6", f"{-pressure:.15g}")


def check(case):
    row = case.text("row.deck")
    for degrees, shift in cracking.FRAMES:
        where = f"ten squares, turned by {degrees}"
        of = turned(row, degrees, shift)
        run = case.run("row", text=of)
        case.same(f"{where}: pieces", children(range(1, 11), 11), told(run), "the same")
        case.same(f"{where}: steps of the cracks", "1", steps(run), "all blocks in one step")
        counts = run.summary["crack_counts"]
        case.same(f"{where}: counts", "10, 10, 0",
                  numbers(counts[of] for of in ("all", "stress", "point loads")), "the same")
        run = case.run("row", text=with_lines(of, START="START, 13, 6"))
        case.same(f"{where}: pieces, START allows 13 blocks",
                  f"{children((1, 2, 3), 11)}; {FULL}: {numbers(range(4, 11))}", told(run),
                  "the first three blocks")
        run = case.run("row", text=with_lines(of, START="START, 10, 6"))
        case.same(f"{where}: pieces, START allows 10 blocks",
                  f"none; {FULL}: {numbers(range(1, 11))}", told(run), "no block")
        run = case.run("row", text=with_lines(of, CRACK="CRACK, 1, 1.E6, 0.6"))
        case.same(f"{where}: pieces, amin 0.6", f"none; {SMALL}: {numbers(range(1, 11))}",
                  told(run), "halves have an area of 0.5")
        run = case.run("row", text=pulled(of, 2.5e6))
        case.same(f"{where}: pieces under 2.5 MPa",
                  f"{children(range(1, 11), 11)} {children(range(1, 21), 21)}; "
                  f"{SMALL}: {numbers(outer(run))}", told(run), "each half splits again")
        case.equal(f"{where}: quarters that stay whole", 20, len(outer(run)), 0, "exact",
                   absolute=True)
        case.same(f"{where}: steps of the cracks under 2.5 MPa", "1, 2", steps(run),
                  "pieces do not split in the step that makes them")
        run = case.run("kite", text=turned(case.text("kite.deck"), degrees, shift))
        case.same(f"kite, turned by {degrees}: pieces", f"none; {CORNERS}: 1", told(run),
                  "a triangle and a pentagon")
        more = with_lines(case.text("kite.deck"), START="START, 4, 5", CYCLE="CYCLE, 1")
        run = case.run("kite", text=turned(more, degrees, shift))
        case.same(f"kite, turned by {degrees}, START allows 5 corners: pieces", "1>2", told(run),
                  "the same")
    for amin, expected in (("0.5", children(range(1, 11), 11)),
                           ("0.500001", f"none; {SMALL}: {numbers(range(1, 11))}")):
        for shift in ((0, 0), (3, -2), (-64, 128)):
            run = case.run("row", text=turned(with_lines(row, CRACK=f"CRACK, 1, 1.E6, {amin}"), 0,
                                              shift))
            case.same(f"ten squares, shifted by {shift}: pieces, amin {amin}", expected, told(run),
                      "areas are exact")
    for degrees, shift in cracking.FRAMES:
        text = turned(case.text("slender.deck"), degrees, shift)
        run = case.run("slender", text=text)
        case.same(f"slender block, turned by {degrees}: pieces", f"none; {THIN}: 1", told(run),
                  "a width of 0.2 m, less than sqrt(0.2) / 2 = 0.224")
        run = case.run("slender", text=with_lines(text, CRACK="CRACK, 1, 1.E6, 0.15",
                                                  MOTION="MOTION, 0.0017"))
        case.same(f"slender block, turned by {degrees}, amin 0.15: pieces", "1>2", told(run),
                  "sqrt(0.15) / 2 = 0.194")
    case.picture(case.run("row", text=with_lines(pulled(row, 2.5e6), CYCLE="MOTION, 0.008")))


def outer(run):
    """The blocks at the end with a side that is pulled, of ten squares cut in quarters."""
    return [block for block in range(1, run.blocks + 1)
            if run.of("AppliedStress", block)[-1][[0, 3]].sum() > 1e5]
