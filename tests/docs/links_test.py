#!/usr/bin/env python3
"""What docs/site/check_links.py finds, on a site of two pages."""
import pathlib
import subprocess
import sys
import tempfile

CHECK = pathlib.Path(__file__).parents[2] / "docs/site/check_links.py"

GOOD = """<a href="b.html#there">1</a><a href="#here">2</a><p id="here"></p><a href="sub/">3</a>
<a href="https://example.org/x">4</a>"""
BAD = """<a href="c.html">5</a>
<img src="no.png"><a href="b.html#nowhere">6</a>"""


def check(text):
    with tempfile.TemporaryDirectory() as folder:
        site = pathlib.Path(folder)
        (site / "sub").mkdir()
        (site / "sub/index.html").write_text("")
        (site / "a.html").write_text(text)
        (site / "b.html").write_text('<h1 id="there"></h1>')
        done = subprocess.run([sys.executable, CHECK, site], capture_output=True, text=True)
        return done.returncode, done.stdout


def expect(text, code, printed):
    found = check(text)
    if found != (code, printed):
        sys.exit(f"expected {(code, printed)}\ngot {found}")


expect(GOOD, 0, "no link leads nowhere\n")
expect(BAD, 1, "a.html:1: c.html does not exist\na.html:2: no.png does not exist\n"
               "a.html:2: b.html#nowhere names no place of that page\n")
