"""Closure of a circular opening in jointed ground under its stress (INSITU)."""

import numpy as np
from suite.chart import Chart
from suite.rings import Rings
from suite.spring_statics import section

LENGTH = "long"
INNER, OUTER, JOINTS, ELASTIC, PRESSURE = 2.0, 10.0, 1e10, (1e10, 4e9), 100.0
SECTORS = (16, 32, 64)
REFERENCE = (16, 32)  # the linear statics of more blocks takes long
DECK = """START, {blocks}, 64
CIRCULAR OPENING IN RINGS OF {sectors} BLOCKS
XLIMITS, -20, 20
YLIMITS, -20, 20
BOXES, 40, 40, 0.01
FRACTION, 0.04
{materials}{rigid}END
{shapes}{joints}$ Joints that open while the wall swings would lose their shear force, so dashpots act too.
DAMPING, 0.2
LOCDAMP, 0.5
INSITU, {sxx}, {syy}
SOLVE, 1.E-9, 100
REMOVE, 1
SOLVE, 1.E-7
STOP
"""


def deck(rings, stress, elastic):
    """Returns the deck of the rings under the stress (sxx, syy)."""
    young, shear = elastic or ELASTIC
    materials, shapes, joints = rings.cards(f"{young:g}, {shear:g}, 2500")
    return DECK.format(sectors=rings.sectors, blocks=shapes.count("CREATE"), materials=materials,
                       rigid="" if elastic else "RIGID\n", shapes=shapes, joints=joints,
                       sxx=stress[0], syy=stress[1])


def inwards(rings, moved):
    """Returns the displacement of each block of the first ring towards the centre."""
    centres = np.array([section(rings.outline(*rings.radii[:2], k))[1]
                        for k in range(rings.sectors)])
    radius = np.linalg.norm(centres, axis=1)
    return -(moved * centres).sum(axis=1) / radius, radius[0]


def measured(rings, run):
    x = run.all("Centroid")[:, rings.first_ring() - 1, :2]
    return inwards(rings, x[-1] - x[0])


def check(case):
    charts = [Chart("Closure of rings, over that of the continuum", "1 / square of the number of "
                    "blocks around the opening", "closure")]
    charts[0].expected([0, 1 / SECTORS[0]**2], [1, 1], "continuum")
    for kind, elastic in (("rigid", None), ("deformable", ELASTIC)):
        ratio = []
        for sectors in SECTORS:
            rings = Rings(sectors, INNER, OUTER, JOINTS)
            run = case.run(f"rings_{sectors}",
                           text=deck(rings, (-PRESSURE, -PRESSURE), elastic))
            ours, radius = measured(rings, run)
            closure = rings.closure(PRESSURE, elastic, radius)
            ratio.append(ours.mean() / closure)
            what = f"{kind}, {sectors} blocks around the opening"
            if sectors in REFERENCE:
                stress = np.diag([-PRESSURE, -PRESSURE])
                springs = inwards(rings, rings.statics(stress, elastic))[0]
                case.equal(f"{what}: closure of the first ring, against springs",
                           1e9 * springs.mean(), 1e9 * ours.mean(), 1e-4,
                           "displacements are small", "nm")
            case.compared(f"{what}: the same, against the continuum", 1e9 * closure,
                          1e9 * ours.mean(), "blocks of finite size", "nm")
            case.measured(f"{what}: steps", str(run.summary["steps"]), "both SOLVE cards")
        fine = ratio[-1] + (ratio[-1] - ratio[-2]) / 3
        case.equal(f"{kind}: closure over that of the continuum, extrapolated to small blocks", 1.0,
                   fine, 0.003, "the error falls with the square of the size")
        charts[0].ours([1 / n**2 for n in SECTORS], ratio, kind)
    case.chart(charts[0])
    uneven(case)
    parted(case)
    layered(case)


def uneven(case):
    """Rings under a horizontal stress that is half of the vertical one."""
    rings, stress = Rings(32, INNER, OUTER, JOINTS), (-0.5 * PRESSURE, -PRESSURE)
    for kind, elastic in (("rigid", None), ("deformable", ELASTIC)):
        run = case.run("rings_uneven", text=deck(rings, stress, elastic))
        x = run.all("Centroid")[:, rings.first_ring() - 1, :2]
        springs = rings.statics(np.diag(stress), elastic)
        case.at_most(f"{kind}, sxx = syy / 2: largest error of a displacement of the first ring, of the "
                     "largest displacement", 1e-4,
                     np.abs(x[-1] - x[0] - springs).max() / np.abs(springs).max(),
                     "displacements are small")


def parted(case):
    """Rings under a stress of 1 MPa, where corners that meet leave each other's edges."""
    rings, stress = Rings(16, INNER, OUTER, JOINTS), (-1e6, -1e6)
    for kind, elastic in (("rigid", None), ("deformable", ELASTIC)):
        run = case.run("rings_parted", text=deck(rings, stress, elastic))
        springs = inwards(rings, rings.statics(np.diag(stress), elastic))[0]
        case.equal(f"{kind}, 16 blocks around the opening, stress of 1 MPa: closure over that on "
                   "springs", 1, measured(rings, run)[0].mean() / springs.mean(), 1e-3,
                   "corners part, and displacements are not small")


def wall(run, radius, within):
    """Returns the mean displacement towards the centre of the corners that lie on the wall, and those
    of the roof and the floor, and of both sides."""
    angle, moved = [], []
    for block in run.free():
        start, end = run.outline(block, 0), run.outline(block, -1)
        if len(end) == len(start) and np.abs(end - start).max() < 0.05:  # It does not fall.
            far = np.linalg.norm(start, axis=1)
            for k in np.nonzero(np.abs(far - radius) < within)[0]:
                angle.append(np.arctan2(start[k, 1], start[k, 0]))
                moved.append(-(end[k] - start[k]) @ start[k] / far[k])
    terms = np.stack([np.ones(len(angle)), np.cos(angle), np.sin(angle),
                      np.cos(2 * np.array(angle)), np.sin(2 * np.array(angle))], 1)
    mean, _, _, double, _ = np.linalg.lstsq(terms, np.array(moved), rcond=None)[0]
    return mean, mean - double, mean + double


def layered(case):
    """The deck with beds and cross joints, and the same ground in blocks of a quarter of the size."""
    text = case.text("decks/circular_opening/circular_opening.deck")
    text = text.replace("circle.csv", str(case.source / "decks/circular_opening/circle.csv"))
    held = text
    for joint, friction in ((1, ".6"), (2, ".8"), (3, ".8")):
        held = held.replace(f"JOINT, {joint}, {friction},", f"JOINT, {joint}, 10,")
    decks = {"deck": text, "fine": refined(text), "joints that do not slip": held,
             "joints that do not slip, fine": refined(held),
             "rigid": text.replace("UNITS", "RIGID\nUNITS")}
    for name, one in decks.items():
        run = case.run("layered", text=one)
        case.measured(f"layered ground, {name}: mean closure; roof and floor; sides; steps",
                      "; ".join(f"{1e3 * value:.2f} mm" for value in wall(run, 3.0, 0.25)) +
                      f"; {run.summary['steps']}", "no closed form")
    mean = 0.5 * (2.1e6 + 3e6)
    for name, outer in (("infinite", 1e9), ("fixed at 12 m", 12.0)):
        ground = Rings(32, 3.0, min(outer, 12.0), 1e10)
        ground.outer = outer
        case.measured(f"mean closure of a continuum, {name}",
                      f"{1e3 * ground.closure(mean, ELASTIC, 3.0):.2f} mm",
                      "isotropic, elastic, mean of the horizontal and the vertical stress")


def refined(text):
    """Returns the deck with joints halfway between its joints. They are ten times as stiff and do not
    fail, and the blocks are stiffer, so that the ground between the joints of the deck is the same."""
    text = text.replace("SOLVE, 1.D-6, 50000", "SOLVE, 1.D-6, 6000")  # Splinters may still fall.
    text = text.replace("MATERIAL, 1, 1.D10, 4.D9,", "MATERIAL, 1, 1.25D10, 4.7619D9,")
    text = text.replace("START, 900", "START, 3600").replace(
        "TRACES,", "JSET, 4, 0., , 1., , , , , , 0., 0.\nJSET, 4, 90., , 1., , , , , , 0., 0.\nTRACES,")
    return text.replace("INSITU", "JOINT, 4, 10., 1.D9, 1.D8, , , , , , 1.D11, 1.D11\nBOND, 4\nINSITU")
