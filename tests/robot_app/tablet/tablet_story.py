"""A visitor at the robot's tablet, in Chromium: finds a room by its category, is led there, speaks,
searches somebody with a misspelt name, is asked back whom of two he means, changes the language, and
goes away.

usage: tablet_story.py URL FOLDER_FOR_PICTURES
"""
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../assistance"))
from supervisor_story import Person, Browser  # noqa: E402


def button(label):
    return "[...document.querySelectorAll('#buttons button')].find(b => b.textContent.toLowerCase().includes('%s'))" % label.lower()


def press(visitor, label):
    visitor.sees("a button " + label, button(label))
    visitor.browser.evaluate("%s.dataset.pressed = 1" % button(label))
    visitor.tap("#buttons button[data-pressed]")


def is_told(visitor, words):
    visitor.sees("the words " + words, "document.getElementById('answer').textContent.includes('%s')" % words)


def find_a_room(visitor):
    visitor.sees("the face", "faceNumber > 0")
    visitor.sees("the floor", "plan.info && plan.info.width > 100 && plan.pose")
    visitor.sees("its walls in three dimensions",
                 "plan instanceof Floor3d && plan.renderer.info.render.triangles > 400")
    visitor.photograph("start")
    press(visitor, "Places")
    press(visitor, "office")
    press(visitor, "office 103")
    is_told(visitor, "103")
    visitor.sees("the way from here", "plan.way && plan.way.there && plan.way.points.length > 2")
    visitor.photograph("way")


def is_flat_without_three_dimensions(visitor):
    assert visitor.browser.evaluate("""(() => {
      const canvas = document.createElement("canvas"), three = window.THREE;
      canvas.style.cssText = "position: fixed; width: 200px; height: 100px";
      document.body.append(canvas);
      window.THREE = undefined;
      const flat = makeFloor(canvas);
      window.THREE = three;
      flat.setMap(plan.info);
      const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
      canvas.remove();
      return pixels.some((value, i) => i % 4 < 3 && value > 100);
    })()"""), "no flat map"


# Whoever plays the trees gives it up at once.
def is_led_there(visitor):
    visitor.tap("#guide")
    is_told(visitor, "could not lead you")
    visitor.sees("no button to stop any more", "document.getElementById('stop').hidden")


def talks(visitor):
    x, y, _ = visitor.place("#talk")
    visitor.touch("touchStart", x, y)
    visitor.sees("that it listens", "document.getElementById('talk').classList.contains('on')")
    visitor.sees("its green eyes", "(() => { const p = document.getElementById('face').getContext('2d')"
                 ".getImageData(0, 0, 64, 32).data; let green = 0; for (let i = 0; i < p.length; i += 4)"
                 " green += p[i + 1] > 200 && p[i] < 100; return green > 100; })()")
    visitor.photograph("talk")
    visitor.touch("touchEnd")
    visitor.sees("that it has stopped", "!document.getElementById('talk').classList.contains('on')")


def searches_somebody(visitor):
    visitor.tap("#german")
    visitor.sees("German", "document.getElementById('title').textContent.includes('Wie kann ich')")
    visitor.tap("#question")
    visitor.browser.call("Input.insertText", text="Annna Weeber")
    visitor.tap("#find")
    is_told(visitor, "Anna Weber")
    visitor.photograph("person")


def is_asked_back(visitor):
    visitor.browser.evaluate("document.getElementById('question').value = ''")
    visitor.tap("#question")
    visitor.browser.call("Input.insertText", text="wo sitzt Weber")
    visitor.tap("#find")
    is_told(visitor, "Meinen Sie")
    visitor.photograph("choice")
    press(visitor, "Paul Weber")
    is_told(visitor, "203")
    visitor.sees("the buttons of the start", button("Personen"))


def asks_what_nobody_knows(visitor):
    visitor.browser.evaluate("document.getElementById('question').value = ''")
    visitor.tap("#question")
    visitor.browser.call("Input.insertText", text="wo ist das Schwimmbad")
    visitor.tap("#find")
    visitor.sees("that it is sorry", "document.querySelector('#answer.unknown')")


def goes_away(visitor):
    visitor.browser.evaluate("clearTimeout(idleTimer); idleTimer = setTimeout(leave, 10)")
    visitor.sees("the start", "document.getElementById('title').textContent.includes('How can I')"
                 " && document.getElementById('answer').hidden")
    assert visitor.browser.evaluate("document.getElementById('question').value") == "", "his question stays"


def is_readable_from_afar(visitor):
    small = visitor.browser.evaluate(
        "[...document.querySelectorAll('button, input')].filter(e => e.getClientRects().length &&"
        " (e.getBoundingClientRect().height < 70 || parseFloat(getComputedStyle(e).fontSize) < 24))"
        ".map(e => e.id || e.textContent)")
    assert not small, "too small: %s" % small


def cannot_leave_the_page(visitor, url):
    elsewhere = url.replace("localhost", "127.0.0.1")
    for script in ("fetch('http://127.0.0.1:8090/')", "fetch('%s', {mode: 'no-cors'})" % elsewhere):
        refused = visitor.browser.evaluate(
            "(async () => { try { await (%s); return false; } catch (error) { return true; } })()" % script)
        assert refused, script + " is not refused"


def visit(visitor, url):
    visitor.browser.call("Emulation.setDeviceMetricsOverride", width=1280, height=800,
                         deviceScaleFactor=1, mobile=False)
    visitor.browser.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)
    visitor.browser.call("Page.navigate", url=url)
    find_a_room(visitor)
    is_flat_without_three_dimensions(visitor)
    is_readable_from_afar(visitor)
    is_led_there(visitor)
    talks(visitor)
    searches_somebody(visitor)
    is_asked_back(visitor)
    asks_what_nobody_knows(visitor)
    goes_away(visitor)
    cannot_leave_the_page(visitor, url)


def main(url, folder):
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        browser = Browser(scratch)
        visitor = Person(browser, folder)
        try:
            visit(visitor, url)
        except BaseException:
            visitor.photograph("failure")
            raise
        finally:
            browser.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
