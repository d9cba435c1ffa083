#!/usr/bin/python3
"""The picture of the page: view.py subsidence.html docs/images/view.png (needs chromium).

The page is `blocks view subsidence.vtkhdf --mirror 0 --units m,kg,s` of decks/subsidence.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "tests/post"))
import browser  # noqa: E402

page = browser.Browser(1200, 720)
page.open(Path(sys.argv[1]).resolve())
page.wait("document.documentElement?.dataset.ready === 'yes'")
page.evaluate("colour_by('displacement'); choose(817); state.followed = 'dy'; show(nearest(2))")
page.drawn()
page.picture(Path(sys.argv[2]))
page.close()
