#!/usr/bin/python3
"""The page of `blocks report` in a browser: page_test.py PROGRAM SOURCE [FOLDER].

It opens from the file system, loads nothing, and is complete without scripts. Every link leads to a page
that opens. It is skipped (77) without chromium.
"""

import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "post/page"))
from view_pages import with_browser  # noqa: E402

DECK = """START, 60, 4
BLOCKS OF RANDOM WIDTH ABOVE A GAP
XLIMITS, -20, 20
YLIMITS, -20, 20
BOXES, 10, 10, 0.1
STIFF, 1.E7, 1.E7
FRACTION, 0.02
MATERIAL, 1, 1.E9, 4.E8, 1000
UNITS, m, kg, s
RIGID
END
CREATE, 4, 1, 1
-6, -6, -2, -2
-1, 0, 0, -1
CREATE, 4, 1, 1
2, 2, 6, 6
-1, 0, 0, -1
LAYER, -20, 1, -5,0, -5,1, 5,1, 5,0, RANDOM
GRAVITY, 0, -10
FRICTN, 0.5
PLOTS, 0.02
MOTION, 0.1
"""


def opens(page, path):
    page.open(path)
    page.wait("document.readyState === 'complete'")
    assert page.faults() == [] and page.requests() == [], (path, page.faults(), page.requests())


def overflows(page):
    return page.evaluate("document.documentElement.scrollWidth > document.documentElement.clientWidth")


def check_figures(page):
    """All figures have a size, and no clip of another figure."""
    sizes = page.evaluate("[...document.querySelectorAll('figure svg')].map((s) => s.getBoundingClientRect().height)")
    assert len(sizes) > 6 and min(sizes) > 100, sizes
    assert page.evaluate("(() => { const ids = [...document.querySelectorAll('[id]')].map((e) => e.id);"
                         "return new Set(ids).size === ids.length; })()"), "identifiers repeat"


def column(page, number):
    return page.evaluate(f"[...document.querySelectorAll('#runs tbody tr')].map((r) => r.cells[{number}].textContent)")


def check_sorting(page):
    page.evaluate("document.querySelectorAll('#runs th')[1].click()")
    assert column(page, 1) == sorted(column(page, 1))
    page.evaluate("document.querySelectorAll('#runs th')[2].click()")
    page.evaluate("document.querySelectorAll('#runs th')[2].click()")
    assert column(page, 2) == sorted(column(page, 2), reverse=True)


def check(page, program, source, folder):
    (folder / "layer.deck").write_text(DECK)
    for words in (["sweep", "layer.deck", "--seeds", "1-5", "--set", "FRICTN.fric=.2,.5", "-o", "a sweep", "-q"],
                  ["report", "a sweep", "--quiet", "--pages", "6"]):
        subprocess.run([program, *words], cwd=folder, check=True, capture_output=True)
    # A run that failed has its message in the table, and no markup of it acts.
    (folder / "a sweep/runs/000/000002/outcome.json").write_text(
        '{"code": 4, "status": "unsound", "message": "<b>block 3</b> turned over"}')
    subprocess.run([program, "report", "a sweep", "--quiet"], cwd=folder, check=True, capture_output=True)
    report = folder / "a sweep/report.html"

    page.call("Emulation.setScriptExecutionDisabled", value=True)
    page.size(1200, 900)
    opens(page, report)
    page.call("Emulation.setScriptExecutionDisabled", value=False)
    check_figures(page)
    assert len(column(page, 0)) == 10

    opens(page, report)
    check_sorting(page)
    assert page.evaluate("document.querySelector('#runs').textContent.includes('<b>block 3</b> turned over')")
    for width in (1200, 400):
        page.size(width, 900)
        page.drawn()
        assert not overflows(page), width
    links = page.evaluate("[...document.querySelectorAll('#runs a')].map((a) => a.href)")
    assert len(links) == 10
    for link in links[:3]:
        page.call("Page.navigate", url=link)
        page.wait("document.readyState === 'complete' && document.body.textContent.length > 100")


if __name__ == "__main__":
    with_browser(check)
