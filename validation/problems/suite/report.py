"""Writes one report of the results of all problems: REPORT.md and REPORT.html."""

import base64
import re
from html import escape

from .program import describe as describe_program

COLUMNS = ["quantity", "expected", "ours", "error", "tolerance", "reason of the tolerance",
           "verdict"]


def verdict(row):
    """Returns whether a row holds, misses, or misses as known; - if there is no known answer."""
    if row["holds"] is False and row["note"]:
        return "known miss"
    return {True: "holds", False: "MISSES", None: "-"}[row["holds"]]


def cells(row):
    text = row["reason"] + (f". Why it misses: {row['note']}" if row["note"] else "")
    return [row["quantity"], row["expected"], row["ours"], row["error"], row["tolerance"], text,
            verdict(row)]


def title(readme):
    return readme.splitlines()[0].lstrip("# ")


def count(results):
    """Returns a sentence with the numbers of rows that hold and miss."""
    rows = [row for result in results for row in result["rows"] if row["holds"] is not None]
    missed = [row for row in rows if not row["holds"]]
    known = sum(bool(row["note"]) for row in missed)
    text = f"{len(results)} problems, {len(rows)} verdicts: {len(rows) - len(missed)} hold, "
    if not missed:
        return text + "none misses."
    return text + f"{len(missed)} miss; {known} of them {'is' if known == 1 else 'are'} known."


def misses(results):
    """Lists the misses and their reasons: (problem, quantity, text)."""
    return [(title(result["readme"]), row["quantity"],
             f"{row['ours']}, expected {row['expected']}. " +
             (f"Known: {row['note']}" if row["note"] else "New: not explained."))
            for result in results for row in result["rows"] if row["holds"] is False]


def measured_by(results):
    """Returns a sentence on the program that measured all rows, or on the several that did."""
    by = {}
    for result in results:
        who = result.get("program")
        by.setdefault(who["numerics"] if who else "", []).append(result)
    if len(by) == 1 and "" not in by:
        return ("All rows were measured by programs of the same arithmetic; the line of a problem "
                "says by which.")
    text = "; ".join(f"numerics {numerics or 'not recorded'}: " +
                     ", ".join(result["problem"] for result in group)
                     for numerics, group in by.items())
    return f"**Rows of different programs** ({text}): `./go validate problems` measures all."


HEAD = """Written by `./go validate problems`; do not edit. Each problem is a folder in
`validation/problems` with its decks, the derivation of its answer, and its check. No tolerance was
widened to pass: a miss is shown as a miss and explained. Known misses have their reasons in
`known_misses.json` of their problem. Rows without a verdict are measurements without a known
answer, or with the answer of another model, as the reason says. Numerics is a fingerprint of what
the program computes (`suite/program.py`): programs with the same numerics agree to the last bit in
five short runs."""


def markdown(results):
    """Returns the report as Markdown, with figures by their paths."""
    out = ["# Validation", "", HEAD, "", measured_by(results), "", count(results), ""]
    out += [f"- **{name}**: {quantity}: {text}" for name, quantity, text in misses(results)] + [""]
    for result in results:
        name = result["problem"]
        out += [f"## {title(result['readme'])}", "",
                f"[{name}](problems/{name}/README.md), {result['runs']} "
                f"run{'s' if result['runs'] > 1 else ''} of {describe_program(result.get('program'))}", "",
                "| " + " | ".join(COLUMNS) + " |", "|" + "---|" * len(COLUMNS)]
        for row in result["rows"]:
            line = [text.replace("|", "\\|") for text in cells(row)]
            if row["holds"] is False:
                line[-1] = f"**{line[-1]}**"
            out.append("| " + " | ".join(line) + " |")
        out.append("")
        out += [f"![{name}](problems/{name}/{figure})" for figure in result["figures"]]
        out.append("")
    return "\n".join(out)


STYLE = """body { font: 15px/1.45 "DejaVu Sans", "Helvetica Neue", Arial, sans-serif; color: #222;
  max-width: 1100px; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 26px; } h2 { font-size: 19px; margin-top: 2.2em; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; font-size: 13px; width: 100%; margin: 1em 0; }
th, td { text-align: left; vertical-align: top; padding: 4px 8px;
  border-bottom: 1px solid #e2e2e2; }
th { border-bottom: 2px solid #999; } td.number { white-space: nowrap; }
.holds { color: #2a7a3f; } .misses { color: #b3261e; font-weight: bold; }
pre { background: #f5f5f2; padding: 0.7em 1em; overflow-x: auto; } code { font-size: 92%; }
figure { display: inline-block; margin: 0.5em 1em 0.5em 0; width: 47%; min-width: 320px;
  vertical-align: top; }
figure svg, figure img { width: 100%; height: auto; }
nav { columns: 3; font-size: 13px; }
nav a { display: block; color: #1f6fb2; text-decoration: none; }"""


def prose(text):
    """Converts the Markdown that our pages use: paragraphs, lists, tables, code, headings."""
    out = []
    for part in re.split(r"\n\s*\n", text.strip()):
        lines = part.splitlines()
        if part.startswith("!["):
            continue  # Figures are shown below the table.
        if all(line.startswith("    ") for line in lines):
            out.append("<pre>" + escape("\n".join(line[4:] for line in lines)) + "</pre>")
        elif part.startswith("#"):
            out.append(f"<h3>{words(part.lstrip('# '))}</h3>")
        elif part.startswith("|"):
            out.append("<table>")
            for k, line in enumerate(lines):
                if k != 1:
                    tag = "th" if k == 0 else "td"
                    out.append("<tr>" + "".join(f"<{tag}>{words(c.strip())}</{tag}>"
                                                for c in line.strip("|").split("|")) + "</tr>")
            out.append("</table>")
        elif part.startswith("- "):
            items = re.split(r"^- ", part, flags=re.M)[1:]
            out.append("<ul>" + "".join(f"<li>{words(item)}</li>" for item in items) + "</ul>")
        else:
            out.append(f"<p>{words(part)}</p>")
    return "\n".join(out)


def words(text):
    text = escape(text, quote=False)
    text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*([^*]+)\*\*", r"<b>\1</b>", text)
    text = re.sub(r"\*([^*\s][^*]*)\*", r"<i>\1</i>", text)
    return re.sub(r"\[([^\]]+)\]\([^)]*\)", r"\1", text)


def picture(path):
    if path.suffix == ".svg":
        return f"<figure>{path.read_text()}</figure>"
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<figure><img alt="{path.stem}" src="data:image/png;base64,{data}"></figure>'


def html(results, folder):
    """Returns the report as one page that includes everything."""
    out = ['<!DOCTYPE html>', '<html lang="en"><head><meta charset="utf-8">',
           "<title>Validation of BLOCKS</title>", f"<style>{STYLE}</style></head><body>",
           "<h1>Validation of BLOCKS</h1>", f"<p>{words(HEAD)}</p>",
           f"<p>{words(measured_by(results))}</p>", f"<p><b>{count(results)}</b></p>", "<ul>",
           *(f"<li><b>{words(name)}</b>: {words(quantity)}: {words(text)}</li>"
             for name, quantity, text in misses(results)), "</ul>", "<nav>"]
    for result in results:
        missed = any(row["holds"] is False for row in result["rows"])
        mark = ' <span class="misses">misses</span>' if missed else ""
        out.append(f'<a href="#{result["problem"]}">{words(title(result["readme"]))}{mark}</a>')
    out.append("</nav>")
    for result in results:
        name, readme = result["problem"], result["readme"]
        out += [f'<h2 id="{name}">{words(title(readme))}</h2>',
                prose(readme.partition("\n")[2]),
                f"<p>{result['runs']} run{'s' if result['runs'] > 1 else ''} of "
                f"{describe_program(result.get('program'))}</p>", "<table><tr>" +
                "".join(f"<th>{column}</th>" for column in COLUMNS) + "</tr>"]
        for row in result["rows"]:
            line = [words(text) for text in cells(row)]
            kind = {True: "holds", False: "misses", None: ""}[row["holds"]]
            out.append("<tr>" + "".join(
                f'<td class="{kind if k == 6 else "number" if 0 < k < 5 and len(text) < 30 else ""}">'
                f"{text}</td>"
                for k, text in enumerate(line)) + "</tr>")
        out.append("</table>")
        out += [picture(folder / name / figure) for figure in result["figures"]]
    return "\n".join([*out, "</body></html>", ""])
