"""Makes decks from decks: replaces cards, or turns, shifts or mirrors the whole scene."""

import math
import re


def polygon(corners, fixed=False, material=1):
    """Returns CREATE with these corners, clockwise."""
    xs = ", ".join(f"{x:.17g}" for x, _ in corners)
    ys = ", ".join(f"{y:.17g}" for _, y in corners)
    return f"CREATE, {len(corners)}, {material}, {int(fixed)}\n{xs}\n{ys}\n"


def rectangle(left, bottom, right, top, fixed=False, material=1):
    """Returns CREATE of a rectangle."""
    return polygon([(left, bottom), (left, top), (right, top), (right, bottom)], fixed, material)


def with_lines(text, **lines):
    """Returns the deck with the card of each keyword replaced: MOTION="MOTION, 3"."""
    for card, line in lines.items():
        text, count = re.subn(rf"^{card}\b.*$", line, text, flags=re.M)
        assert count, f"the deck has no card {card}"
    return text


# Cards that are the same in every frame.
FRAMELESS = {"START", "STIFF", "RIGID", "FRACTION", "MATERIAL", "SEED", "END", "BOXES", "FUNCTION",
             "FIX", "FRICTN", "DAMPING", "MERGE", "ORIENT", "PRESSBC", "OUTPUT", "PLOTS", "DUMP",
             "MOTION", "CYCLE", "STOP", "UNITS", "JOINT", "JPAIR", "BOND", "WALTON", "BARTON", "CUT",
             "LOCDAMP", "KINDAMP", "SOLVE", "FOS", "MSCALE", "SERVO", "QUIET", "VORONOI", "HISTORY",
             "CRACK", "MDAMP"}


def turned(text, degrees, shift=(0.0, 0.0)):
    """Returns the deck in a frame turned anticlockwise and then shifted. It turns the corners of
    CREATE, OUTLINE, LAYER, REMOVE and FREE, and CLOOP, SETVEL, SETVELM, FORCE, GRAVITY, SPLANE,
    DRIVE, JSET, INSITU, WATER and JWATER, and enlarges the domain. Raises ValueError for a card that it cannot
    turn (READ9, RESTART, INSITU with a gradient) or that continues on the next line."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def turn(x, y, by=(0.0, 0.0)):
        return c * x - s * y + by[0], s * x + c * y + by[1]

    def words(line):
        return [word.strip() for word in re.split(r"[$!]", line)[0].split(",")]

    def numbers(count):
        """Returns the next numbers, which may be on several lines."""
        nonlocal at
        found = []
        while len(found) < count:
            found += [float(word) for word in words(lines[at]) if word]
            at += 1
        return found

    def real(card, field):
        word = card[field] if field < len(card) else ""
        return float(word.upper().replace("D", "E")) if word else 0.0

    def with_pairs(card, first, pairs, by=(0.0, 0.0)):
        """Returns the card with `pairs` pairs, from field `first` on, turned."""
        card = card + [""] * (first - len(card))
        new = [v for k in range(pairs)
               for v in turn(real(card, first + 2 * k), real(card, first + 2 * k + 1), by)]
        return ", ".join([*card[:first], *(f"{v:.15g}" for v in new), *card[first + 2 * pairs:]])

    # Field of the first pair, number of pairs, and whether they are points.
    pairs = {"CLOOP": (2, 1, False), "GRAVITY": (1, 1, False), "SETVEL": (3, 1, False),
             "SETVELM": (2, 1, False), "FORCE": (2, 1, False), "DRIVE": (2, 1, False),
             "SPLANE": (1, 2, True), "LAYER": (3, 4, True)}
    lines, out, limits = text.splitlines(), [], []
    at = 0
    while at < len(lines):
        line = lines[at]
        card = words(line)
        name = card[0].upper()
        at += 1
        if name in ("REMOVE", "FREE"):
            if any("(" in word for word in card):
                raise ValueError(f"no frame is known for {line}")
            out.append(line)
            count = int(real(card, 4))
            points = [turn(x, y, shift) for x, y in zip(numbers(count), numbers(count))]
            for values in zip(*points):
                out.append(", ".join(f"{value:.17g}" for value in values))
        elif name in ("CREATE", "OUTLINE"):
            xs, ys = ([float(word) for word in words(lines[at + k])] for k in (0, 1))
            if not len(xs) == len(ys) == int(card[1]):
                raise ValueError(f"{name} continues on a third line: {line}")
            at += 2
            points = [turn(x, y, shift) for x, y in zip(xs, ys)]
            fixed = len(card) > 3 and card[3] not in ("", "0")
            made = polygon(points, fixed, int(card[2])).rstrip().splitlines()
            out += made if name == "CREATE" else [line, *made[1:]]
        elif name == "WATER":
            out.append(line)
            points = [turn(*numbers(2), shift) for _ in range(int(real(card, 2)))]
            out += [f"{x:.17g}, {y:.17g}" for x, y in points]
        elif name == "JWATER":
            card += [""] * (10 - len(card))
            for first in (2, 5):
                card[first:first + 2] = (f"{v:.17g}" for v in turn(real(card, first), real(card, first + 1), shift))
            out.append(", ".join(card))
        elif name == "JSET":
            card += [""] * (12 - len(card))
            card[2] = f"{real(card, 2) + degrees:.15g}"
            card[10:12] = (f"{v:.15g}" for v in turn(real(card, 10), real(card, 11), shift))
            out.append(", ".join(card))
        elif name == "INSITU":
            if any(real(card, k) for k in range(4, 7)):
                raise ValueError(f"a gradient cannot be turned: {line}")
            xx, yy, xy = (real(card, k) for k in (1, 2, 3))
            mean, half, shear = (xx + yy) / 2, (xx - yy) / 2, xy
            c2, s2 = c * c - s * s, 2 * s * c
            half, shear = c2 * half - s2 * shear, s2 * half + c2 * shear
            out.append(f"INSITU, {mean + half:.15g}, {mean - half:.15g}, {shear:.15g}")
        elif name in pairs:
            first, count, points = pairs[name]
            if points and len(card) < first + 2 * count:
                raise ValueError(f"{name} continues on the next line: {line}")
            out.append(with_pairs(card, first, count, shift if points else (0.0, 0.0)))
        elif name in ("XLIMITS", "YLIMITS"):
            limits += [float(word) for word in card[1:]]
            out.append(name)
        elif name in FRAMELESS or not name or re.match(r"[-+.\d]", name):
            out.append(line)
            if name == "START":  # The next line is the title.
                out.append(lines[at])
                at += 1
        else:
            raise ValueError(f"no frame is known for {name}: {line}")
    reach = math.hypot(max(map(abs, limits[:2])), max(map(abs, limits[2:])))
    for name, middle in (("XLIMITS", shift[0]), ("YLIMITS", shift[1])):
        out[out.index(name)] = f"{name}, {middle - reach:.15g}, {middle + reach:.15g}"
    return "\n".join(out) + "\n"


def mirrored(text):
    """Returns the deck with left and right exchanged, x to -x. It mirrors the corners of CREATE,
    whose first corner stays the first one, GRAVITY, FORCE, WATER and JWATER. Raises ValueError for other cards
    that it cannot mirror."""
    lines, out, at = text.splitlines(), [], 0
    while at < len(lines):
        line = lines[at]
        card = [word.strip() for word in re.split(r"[$!]", line)[0].split(",")]
        name = card[0].upper()
        at += 1
        if name == "CREATE":
            xs, ys = ([float(word) for word in lines[at + k].split(",")] for k in (0, 1))
            at += 2
            points = [(-x, y) for x, y in zip(xs, ys)]
            fixed = len(card) > 3 and card[3] not in ("", "0")
            out += polygon([points[0], *points[:0:-1]], fixed, int(card[2])).splitlines()
        elif name == "WATER":
            points = [[float(word) for word in row.split(",")] for row in lines[at:at + int(card[2])]]
            at += len(points)
            out += [line, *(f"{-x:.17g}, {y:.17g}" for x, y in reversed(points))]
        elif name == "JWATER":
            for field in (2, 5):
                if len(card) > field and card[field]:
                    card[field] = f"{-float(card[field]):.17g}"
            out.append(", ".join(card))
        elif name in ("GRAVITY", "FORCE"):
            field = 1 if name == "GRAVITY" else 2
            card[field] = f"{-float(card[field]):.15g}"
            out.append(", ".join(card))
        elif name == "XLIMITS":
            out.append(f"XLIMITS, {-float(card[2]):.15g}, {-float(card[1]):.15g}")
        elif name in FRAMELESS or name == "YLIMITS" or not name or re.match(r"[-+.\d]", name):
            out.append(line)
            if name == "START":  # The next line is the title.
                out.append(lines[at])
                at += 1
        else:
            raise ValueError(f"no mirror image is known for {name}: {line}")
    return "\n".join(out) + "\n"
