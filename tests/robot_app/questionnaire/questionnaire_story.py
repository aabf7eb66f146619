"""Somebody fills in the questionnaire in Chromium; his marks are in the file, and nothing else of him.

usage: questionnaire_story.py coppice-questionnaire
"""
import csv
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../assistance"))
from supervisor_story import Person, Browser  # noqa: E402

PAIRS = 24


def fill_in(person, url):
    person.browser.call("Page.navigate", url=url)
    person.sees("all pairs of words", "document.querySelectorAll('fieldset').length === %d" % PAIRS)
    person.browser.evaluate("document.getElementById('de').click()")
    person.sees("German words", "document.getElementById('items').textContent.includes('Freundlich')")
    person.browser.evaluate("document.querySelectorAll('fieldset').forEach("
                            "row => row.querySelectorAll('input')[3].click())")
    person.browser.evaluate("document.getElementById('send').click()")
    person.sees("thanks", "document.getElementById('told').textContent.includes('Dank')")


def main(program):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        answers = os.path.join(scratch, "answers.csv")
        server = subprocess.Popen([program, answers, "--port", "0"], stdout=subprocess.PIPE, text=True)
        browser = Browser(scratch)
        try:
            url = server.stdout.readline().strip().replace("127.0.0.1", "localhost")
            fill_in(Person(browser, scratch), url)
        finally:
            browser.close()
            server.terminate()
            server.wait()
        with open(answers, newline="") as file:
            header, row = csv.reader(file)
        assert len(header) == PAIRS and row == ["4"] * PAIRS, row


if __name__ == "__main__":
    main(sys.argv[1])
