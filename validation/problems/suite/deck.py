"""Decks made from decks: values replaced, the whole scene turned and shifted."""

import math
import re


def polygon(corners, fixed=False, material=1):
    """CREATE with these corners, clockwise."""
    xs = ", ".join(f"{x:.15g}" for x, _ in corners)
    ys = ", ".join(f"{y:.15g}" for _, y in corners)
    return f"CREATE, {len(corners)}, {material}, {int(fixed)}\n{xs}\n{ys}\n"


def rectangle(left, bottom, right, top, fixed=False, material=1):
    """CREATE of a rectangle."""
    return polygon([(left, bottom), (left, top), (right, top), (right, bottom)], fixed, material)


def with_lines(text, **lines):
    """The deck with the card of each keyword replaced: MOTION="MOTION, 3"."""
    for card, line in lines.items():
        text, count = re.subn(rf"^{card}\b.*$", line, text, flags=re.M)
        assert count, f"the deck has no card {card}"
    return text


def turned(text, degrees, shift=(0.0, 0.0)):
    """The deck in a frame turned anticlockwise and then shifted: CREATE, CLOOP, SETVEL,
    GRAVITY, SPLANE; the domain grows around it."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def turn(x, y, by=(0.0, 0.0)):
        return c * x - s * y + by[0], s * x + c * y + by[1]

    def words(line):
        return [word.strip() for word in re.split(r"[$!]", line)[0].split(",")]

    lines, out, limits = text.splitlines(), [], []
    at = 0
    while at < len(lines):
        line = lines[at]
        card = words(line)
        name = card[0].upper()
        at += 1
        if name == "CREATE":
            xs, ys = ([float(word) for word in words(lines[at + k])] for k in (0, 1))
            at += 2
            points = [turn(x, y, shift) for x, y in zip(xs, ys)]
            fixed = len(card) > 3 and card[3] not in ("", "0")
            out.append(polygon(points, fixed, int(card[2])).rstrip())
        elif name in ("CLOOP", "GRAVITY"):
            x, y = turn(*(float(word) for word in card[-2:]))
            out.append(", ".join([*card[:-2], f"{x:.15g}", f"{y:.15g}"]))
        elif name == "SETVEL":
            x, y = turn(float(card[3]), float(card[4]))
            out.append(", ".join([*card[:3], f"{x:.15g}", f"{y:.15g}", *card[5:]]))
        elif name == "SPLANE":
            ends = [float(word) for word in card[1:]]
            both = (*turn(*ends[:2], shift), *turn(*ends[2:], shift))
            out.append(", ".join(["SPLANE", *(f"{v:.15g}" for v in both)]))
        elif name in ("XLIMITS", "YLIMITS"):
            limits += [float(word) for word in card[1:]]
            out.append(name)
        else:
            out.append(line)
    reach = math.hypot(max(map(abs, limits[:2])), max(map(abs, limits[2:])))
    for name, middle in (("XLIMITS", shift[0]), ("YLIMITS", shift[1])):
        out[out.index(name)] = f"{name}, {middle - reach:.15g}, {middle + reach:.15g}"
    return "\n".join(out) + "\n"
