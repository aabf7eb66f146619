// The floor with the walls, the robot and the way to a place.
"use strict";

class Floor {
  constructor(canvas) {
    this.canvas = canvas;
    this.image = null;
    this.info = null;
    this.pose = null;
    this.way = null;
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  setMap(map) {
    this.info = map;
    this.image = document.createElement("canvas");
    this.image.width = map.width;
    this.image.height = map.height;
    const context = this.image.getContext("2d");
    const pixels = context.createImageData(map.width, map.height);
    const colours = {"#": [150, 170, 190, 255], ".": [32, 42, 52, 255], " ": [11, 14, 17, 0]};
    for (let i = 0; i < map.cells.length; ++i) {
      const row = map.height - 1 - Math.floor(i / map.width);
      pixels.data.set(colours[map.cells[i]], 4 * (row * map.width + i % map.width));
    }
    context.putImageData(pixels, 0, 0);
    this.draw();
  }

  setPose(pose) {
    this.pose = pose;
    this.draw();
  }

  setWay(way) {
    this.way = way;
    this.draw();
  }

  // What is to be seen: the way with the robot, or the whole floor [m].
  area() {
    if (!this.way || this.way.points.length < 2) {
      const {x, y, width, height, resolution} = this.info;
      return {left: x, right: x + width * resolution, low: y, high: y + height * resolution};
    }
    const points = this.pose ? [...this.way.points, this.pose] : this.way.points;
    const xs = points.map(point => point[0]), ys = points.map(point => point[1]);
    return {left: Math.min(...xs) - 3, right: Math.max(...xs) + 3,
            low: Math.min(...ys) - 3, high: Math.max(...ys) + 3};
  }

  draw() {
    const ratio = window.devicePixelRatio || 1;
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!this.info || width === 0 || height === 0) return;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    const area = this.area();
    this.scale = Math.min(width / (area.right - area.left), height / (area.high - area.low));
    const context = this.canvas.getContext("2d");
    context.setTransform(ratio * this.scale, 0, 0, -ratio * this.scale,
                         ratio * (width / 2 - (area.left + area.right) / 2 * this.scale),
                         ratio * (height / 2 + (area.low + area.high) / 2 * this.scale));
    this.drawWalls(context);
    if (this.way) this.drawWay(context);
    if (this.pose) this.drawRobot(context);
  }

  drawWalls(context) {
    const {width, height, resolution, x, y} = this.info;
    context.save();
    context.translate(x, y + height * resolution);
    context.scale(resolution, -resolution);
    context.imageSmoothingEnabled = this.scale * resolution < 1;  // else thin walls are lost
    context.drawImage(this.image, 0, 0, width, height);
    context.restore();
  }

  drawWay(context) {
    const pixel = 1 / this.scale, points = this.way.points;
    context.strokeStyle = "#48c8ff";
    context.lineWidth = 6 * pixel;
    context.lineJoin = context.lineCap = "round";
    context.beginPath();
    points.forEach(([x, y], i) => i ? context.lineTo(x, y) : context.moveTo(x, y));
    context.stroke();
    const [x, y] = points[points.length - 1];
    context.fillStyle = this.way.there ? "#ffd040" : "#48c8ff";
    context.beginPath();
    context.arc(x, y, 12 * pixel, 0, 7);
    context.fill();
  }

  drawRobot(context) {
    const [x, y, yaw] = this.pose;
    context.save();
    context.translate(x, y);
    context.rotate(yaw);
    context.scale(Math.max(1, 30 / this.scale), Math.max(1, 30 / this.scale));  // to be seen
    context.fillStyle = "#35c26b";
    context.beginPath();
    context.arc(0, 0, 0.33, 0, 7);
    context.fill();
    context.fillStyle = "#ffffff";
    context.beginPath();
    context.moveTo(0.28, 0);
    context.lineTo(-0.14, 0.18);
    context.lineTo(-0.14, -0.18);
    context.fill();
    context.restore();
  }
}
