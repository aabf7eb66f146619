// The map with the robot: pan, zoom, and an arrow that says where the robot really is.
"use strict";

class RobotMap {
  constructor(canvas, onArrow) {
    this.canvas = canvas;
    this.onArrow = onArrow;  // ({x, y, yaw}) while it is dragged
    this.image = null;
    this.info = null;
    this.pose = null;
    this.scan = [];
    this.arrow = null;
    this.isSetting = false;
    this.isFollowing = true;
    this.center = {x: 0, y: 0};
    this.scale = 30;  // pixels for a metre
    this.pointers = new Map();
    canvas.addEventListener("pointerdown", event => this.down(event));
    canvas.addEventListener("pointermove", event => this.move(event));
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, event => this.pointers.delete(event.pointerId));
    canvas.addEventListener("touchstart", event => event.preventDefault(), {passive: false});
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      this.zoom(event.deltaY < 0 ? 1.15 : 1 / 1.15);
    }, {passive: false});
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  setCells(buffer) {
    const view = new DataView(buffer);
    const width = view.getInt32(4, true), height = view.getInt32(8, true);
    this.info = {width, height, resolution: view.getFloat32(12, true), x: view.getFloat32(16, true),
                 y: view.getFloat32(20, true), yaw: view.getFloat32(24, true)};
    const cells = new Int8Array(buffer, 28);
    this.image = document.createElement("canvas");
    this.image.width = width;
    this.image.height = height;
    const context = this.image.getContext("2d");
    const pixels = context.createImageData(width, height);
    for (let row = 0; row < height; ++row) {
      for (let column = 0; column < width; ++column) {
        const cell = cells[row * width + column];
        const at = 4 * ((height - 1 - row) * width + column);
        const grey = cell < 0 ? 70 : cell >= 50 ? 15 : 225 - 1.5 * cell;
        pixels.data[at] = pixels.data[at + 1] = pixels.data[at + 2] = grey;
        pixels.data[at + 3] = 255;
      }
    }
    context.putImageData(pixels, 0, 0);
    this.draw();
  }

  setPlace(pose, scan) {
    this.pose = pose && {x: pose[0], y: pose[1], yaw: pose[2]};
    this.scan = scan;
    if (this.isFollowing && this.pose && this.pointers.size === 0 && !this.isSetting)
      this.center = {x: this.pose.x, y: this.pose.y};
    this.draw();
  }

  follow() {
    this.isFollowing = true;
    if (this.pose) this.center = {x: this.pose.x, y: this.pose.y};
    this.draw();
  }

  beginSetting() {
    this.isSetting = true;
    this.arrow = null;
    this.draw();
  }

  endSetting() {
    this.isSetting = false;
    this.arrow = null;
    this.draw();
  }

  zoom(factor) {
    this.scale = Math.min(200, Math.max(4, this.scale * factor));
    this.draw();
  }

  toMap(event) {
    const box = this.canvas.getBoundingClientRect();
    return {x: this.center.x + (event.clientX - box.left - box.width / 2) / this.scale,
            y: this.center.y - (event.clientY - box.top - box.height / 2) / this.scale};
  }

  down(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    if (!this.isSetting || this.pointers.size > 1) return;
    const at = this.toMap(event);
    this.arrow = {x: at.x, y: at.y, yaw: this.pose ? this.pose.yaw : 0};
    this.onArrow(this.arrow);
    this.draw();
  }

  move(event) {
    const last = this.pointers.get(event.pointerId);
    if (!last) return;
    if (this.pointers.size === 2) {
      this.pinch(event, last);
    } else if (this.isSetting) {
      const at = this.toMap(event);
      if (Math.hypot(at.x - this.arrow.x, at.y - this.arrow.y) * this.scale > 12)
        this.arrow.yaw = Math.atan2(at.y - this.arrow.y, at.x - this.arrow.x);
      this.onArrow(this.arrow);
    } else {
      this.isFollowing = false;
      this.center.x -= (event.clientX - last.x) / this.scale;
      this.center.y += (event.clientY - last.y) / this.scale;
    }
    this.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    this.draw();
  }

  pinch(event, last) {
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)[1];
    const before = Math.hypot(last.x - other.x, last.y - other.y);
    const after = Math.hypot(event.clientX - other.x, event.clientY - other.y);
    if (before > 0 && after > 0) this.zoom(after / before);
  }

  draw() {
    const ratio = window.devicePixelRatio || 1;
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (width === 0 || height === 0) return;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    const context = this.canvas.getContext("2d");
    context.setTransform(ratio * this.scale, 0, 0, -ratio * this.scale,
                         ratio * (width / 2 - this.center.x * this.scale),
                         ratio * (height / 2 + this.center.y * this.scale));  // metres, y up
    if (this.image) this.drawImage(context);
    if (this.pose) this.drawRobot(context);
    if (this.arrow) this.drawArrow(context);
  }

  drawImage(context) {
    const {width, height, resolution, x, y, yaw} = this.info;
    context.save();
    context.translate(x, y);
    context.rotate(yaw);
    context.translate(0, height * resolution);
    context.scale(resolution, -resolution);
    context.imageSmoothingEnabled = false;
    context.drawImage(this.image, 0, 0, width, height);
    context.restore();
  }

  drawRobot(context) {
    context.save();
    context.translate(this.pose.x, this.pose.y);
    context.rotate(this.pose.yaw);
    context.fillStyle = "#e5544b";
    const size = 3 / this.scale;
    for (let i = 0; i + 1 < this.scan.length; i += 2)
      context.fillRect(this.scan[i] - size / 2, this.scan[i + 1] - size / 2, size, size);
    context.fillStyle = "#3f9ae0";
    context.beginPath();
    context.arc(0, 0, 0.33, 0, 7);
    context.fill();
    context.fillStyle = "#ffffff";
    context.beginPath();
    context.moveTo(0.28, 0);
    context.lineTo(-0.12, 0.16);
    context.lineTo(-0.12, -0.16);
    context.fill();
    context.restore();
  }

  drawArrow(context) {
    const unit = 1 / this.scale;
    context.save();
    context.translate(this.arrow.x, this.arrow.y);
    context.rotate(this.arrow.yaw);
    context.strokeStyle = context.fillStyle = "#e07b00";
    context.lineWidth = 4 * unit;
    context.beginPath();
    context.arc(0, 0, 0.33, 0, 7);
    context.moveTo(0, 0);
    context.lineTo(60 * unit, 0);
    context.stroke();
    context.beginPath();
    context.moveTo(78 * unit, 0);
    context.lineTo(56 * unit, 13 * unit);
    context.lineTo(56 * unit, -13 * unit);
    context.fill();
    context.restore();
  }
}
