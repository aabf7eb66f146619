"""A person helps the robot from a phone, then from a desktop: Chromium, by touch and by mouse.

usage: supervisor_story.py LINK_OF_THE_MESSAGE FOLDER_FOR_PICTURES
"""
import base64
import os
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../../editor/web"))
from page_test import Browser, wait_for  # noqa: E402


class Person:
    def __init__(self, browser, folder):
        self.browser, self.folder = browser, folder

    def phone(self):
        self.browser.call("Emulation.setDeviceMetricsOverride", width=390, height=844,
                          deviceScaleFactor=1, mobile=True)
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)

    def desktop(self):
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=False)
        self.browser.call("Emulation.setDeviceMetricsOverride", width=1280, height=800,
                          deviceScaleFactor=1, mobile=False)

    def sees(self, what, script):
        # What is not there yet is not seen yet.
        return wait_for(what, lambda: self.browser.evaluate(
            "(() => { try { return Boolean(%s); } catch (error) { return false; } })()" % script))

    def place(self, selector):
        self.sees(selector, "Boolean(document.querySelector('%s')?.getClientRects().length)"
                  % selector)
        return self.browser.evaluate(
            "(box => [box.x + box.width / 2, box.y + box.height / 2, box.width])"
            "(document.querySelector('%s').getBoundingClientRect())" % selector)

    def touch(self, kind, x=None, y=None):
        points = [] if x is None else [{"x": x, "y": y}]
        self.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=points)

    def mouse(self, kind, x, y):
        self.browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left",
                          buttons=0 if kind == "mouseReleased" else 1, clickCount=1)

    def tap(self, selector):
        x, y, _ = self.place(selector)
        self.touch("touchStart", x, y)
        self.touch("touchEnd")

    def click(self, selector):
        x, y, _ = self.place(selector)
        self.mouse("mousePressed", x, y)
        self.mouse("mouseReleased", x, y)

    def photograph(self, name):
        shot = self.browser.call("Page.captureScreenshot", format="png")["data"]
        with open(os.path.join(self.folder, name + ".png"), "wb") as file:
            file.write(base64.b64decode(shot))

    def has_moved(self, start):
        self.sees("the robot has moved",
                  "Math.hypot(map.pose.x - %f, map.pose.y - %f) > 0.3" % tuple(start))

    def where(self):
        self.sees("a pose", "Boolean(map.pose)")
        return self.browser.evaluate("[map.pose.x, map.pose.y]")


def stands_still(person):
    person.browser.evaluate("globalThis.lastPose = null")
    person.sees("the robot stands", """(() => {
        const still = lastPose && Math.hypot(map.pose.x - lastPose.x, map.pose.y - lastPose.y) < 0.005;
        lastPose = map.pose;
        return still;
    })()""")


def drive_by_touch(person):
    start = person.where()
    x, y, width = person.place("#stick")
    person.touch("touchStart", x, y)
    person.touch("touchMove", x, y - 0.3 * width)
    person.sees("the wheel", "wheel.driver === hello.client")
    person.has_moved(start)
    person.photograph("phone_drive")
    person.touch("touchEnd")
    stands_still(person)


def lose_contact_while_driving(person):
    start = person.where()
    x, y, width = person.place("#stick")
    person.touch("touchStart", x, y)
    person.touch("touchMove", x, y - 0.3 * width)
    person.has_moved(start)
    person.browser.evaluate("connection.socket.close()")
    person.sees("contact again", "isLive && wheel.driver !== hello.client")
    person.touch("touchEnd")
    stands_still(person)


def set_position(person):
    person.tap("nav button[data-tab=map_tab]")
    person.tap("#set_pose")
    person.sees("a map", "Boolean(map.image)")
    x, y, _ = person.place("#map")
    person.touch("touchStart", x, y)
    person.touch("touchMove", x, y - 80)  # looks north
    person.sees("an arrow to the north", "Math.abs(map.arrow.yaw - Math.PI / 2) < 0.05")
    person.touch("touchMove", x, y - 80)  # rests, as a finger does
    person.touch("touchEnd")
    person.photograph("phone_map")
    person.tap("#pose_ok")
    person.sees("a word of thanks", "document.getElementById('told').textContent.includes('position')")


def look_at_the_state(person):
    person.tap("nav button[data-tab=state_tab]")
    person.sees("an alarm", "document.getElementById('alarms').textContent.includes('/scan')")
    person.tap("#groups li button")
    person.sees("a question before the restart", "Boolean(document.querySelector('button.sure'))")
    person.photograph("phone_robot")


def drive_by_mouse(person):
    person.desktop()
    person.sees("a picture of the camera", "Boolean(document.querySelector('#pictures img'))")
    start = person.where()
    x, y, width = person.place("#stick")
    person.mouse("mousePressed", x, y)
    person.mouse("mouseMoved", x, y + 0.3 * width)
    person.has_moved(start)
    person.photograph("desktop")
    person.mouse("mouseReleased", x, y + 0.3 * width)
    stands_still(person)
    person.click("#leave")
    person.sees("the wheel is free", "wheel.driver === 0")


def help_the_robot(person, link):
    person.phone()
    person.browser.call("Page.navigate", url=link)
    person.sees("the question", "document.getElementById('requests').textContent.includes('pallet')")
    assert "#" not in person.browser.evaluate("location.href"), "the token stays in the address"
    person.sees("a picture of the camera", "Boolean(document.querySelector('#pictures img'))")
    drive_by_touch(person)
    lose_contact_while_driving(person)
    set_position(person)
    look_at_the_state(person)
    drive_by_mouse(person)
    person.phone()
    person.tap("nav button[data-tab=drive]")
    person.tap("button.fixed")
    person.sees("that it is fixed", "Boolean(document.querySelector('.request.closed'))")
    person.photograph("phone_fixed")


def main(link, folder):
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        browser = Browser(scratch)
        try:
            help_the_robot(Person(browser, folder), link)
        except BaseException:
            Person(browser, folder).photograph("failure")
            raise
        finally:
            browser.close()


if __name__ == "__main__":
    main(*sys.argv[1:])
