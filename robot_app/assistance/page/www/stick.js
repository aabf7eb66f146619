// The stick that drives: as long as it is held it repeats what is wished, ten times a second; the
// robot stops by itself when that ceases.
"use strict";

class Stick {
  constructor(element, knob, drive) {
    this.element = element;
    this.knob = knob;
    this.drive = drive;  // (ahead, left, isHeld), both from -1 to 1
    this.pointer = null;
    this.timer = null;
    this.ahead = 0;
    this.left = 0;
    element.addEventListener("pointerdown", event => this.hold(event));
    element.addEventListener("pointermove", event => this.move(event));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
      element.addEventListener(end, event => {
        if (event.pointerId === this.pointer) this.release();
      });
    element.addEventListener("touchstart", event => event.preventDefault(), {passive: false});
    element.addEventListener("contextmenu", event => event.preventDefault());
    window.addEventListener("blur", () => this.release());
    window.addEventListener("pagehide", () => this.release());
    document.addEventListener("visibilitychange", () => {
      if (document.hidden) this.release();
    });
  }

  hold(event) {
    if (this.pointer !== null) return;
    event.preventDefault();
    this.pointer = event.pointerId;
    this.element.setPointerCapture(event.pointerId);
    this.element.classList.add("held");
    this.move(event);
    this.timer = setInterval(() => this.drive(this.ahead, this.left, true), 100);
  }

  move(event) {
    if (event.pointerId !== this.pointer) return;
    const box = this.element.getBoundingClientRect();
    const reach = box.width / 2 - this.knob.offsetWidth / 2;
    let x = event.clientX - box.left - box.width / 2;
    let y = event.clientY - box.top - box.height / 2;
    const length = Math.hypot(x, y);
    if (length > reach) {
      x *= reach / length;
      y *= reach / length;
    }
    this.knob.style.transform = `translate(${x}px, ${y}px)`;
    this.ahead = Stick.soft(-y / reach);
    this.left = Stick.soft(-x / reach);
    this.drive(this.ahead, this.left, true);
  }

  release() {
    if (this.pointer === null) return;
    this.pointer = null;
    clearInterval(this.timer);
    this.ahead = this.left = 0;
    this.knob.style.transform = "";
    this.element.classList.remove("held");
    this.drive(0, 0, false);
  }

  // Nothing near the middle, fine below, full at the edge.
  static soft(value) {
    const size = Math.max(0, Math.abs(value) - 0.12) / 0.88;
    return Math.sign(value) * size * (0.4 + 0.6 * size);
  }
}
