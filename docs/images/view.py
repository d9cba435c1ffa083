#!/usr/bin/python3
"""The picture of the page: view.py subsidence.html docs/images/view.png (needs chromium).

The page is `blocks view subsidence.vtkhdf --mirror 0` of decks/subsidence.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "tests/post/page"))
import browser  # noqa: E402

page = browser.Browser(1300, 800)
page.open(Path(sys.argv[1]).resolve())
page.wait("document.documentElement?.dataset.ready === 'yes'")
page.scheme("light")
page.evaluate("colour_by('displacement'); set_picked([816, 825]); follow('dy'); show(nearest(2))")
page.evaluate("state.view = {x: 0, y: 25, scale: model.clientWidth / 112}; redraw()")  # the trough
page.move(420, 230)
page.drawn()
page.picture(Path(sys.argv[2]))
page.close()
