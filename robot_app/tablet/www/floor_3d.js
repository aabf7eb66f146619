// The same floor as a model seen from above, its walls cut at the height of a table: for three.js.
"use strict";

const kWallHeight = 1.1;            // m: low enough to look into every room
const kTilt = 50 * Math.PI / 180;   // of the view against the floor
const kOpening = 22;                // degrees, of the camera
const kColours = {wall: 0xb6c6d6, floor: 0x202a34, way: 0x48c8ff, end: 0xffd040, robot: 0x35c26b, nose: 0xffffff};

// Rectangles [column, row, columns, rows] that cover the occupied cells: runs of a row, joined with
// equal ones of the rows above.
function wallsOf({width, height, cells}) {
  const walls = [];
  let open = new Map();  // those that reach the row before, by where they begin and how wide they are
  for (let row = 0; row < height; ++row) {
    const reached = new Map();
    for (let column = 0; column < width; ++column) {
      if (cells[row * width + column] !== "#") continue;
      const first = column;
      while (column < width && cells[row * width + column] === "#") ++column;
      const key = first + ":" + (column - first);
      const wall = open.get(key) || [first, row, column - first, 0];
      if (!wall[3]++) walls.push(wall);
      reached.set(key, wall);
    }
    open = reached;
  }
  return walls;
}

class Floor3d extends Floor {
  // Throws where the browser has no WebGL.
  constructor(canvas) {
    super(canvas);
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    this.renderer.setClearColor(0x0b0e11);
    this.camera = new THREE.PerspectiveCamera(kOpening, 1, 0.1, 1000);
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x303a44, 0.75));
    const sun = new THREE.DirectionalLight(0xffffff, 0.5);
    sun.position.set(-2, -4, 6);
    this.scene.add(sun);
    this.robot = this.makeRobot();
    this.scene.add(this.robot);
    this.path = new THREE.Group();
    this.scene.add(this.path);
  }

  setMap(map) {
    super.setMap(map);
    const {width, height, resolution, x, y} = map;
    const ground = new THREE.Mesh(
        new THREE.PlaneBufferGeometry(width * resolution, height * resolution),
        new THREE.MeshBasicMaterial({map: new THREE.CanvasTexture(this.image), transparent: true}));
    ground.position.set(x + width * resolution / 2, y + height * resolution / 2, 0);
    const box = new THREE.BoxBufferGeometry(1, 1, 1);
    const rectangles = wallsOf(map);
    const walls = new THREE.InstancedMesh(
        box, new THREE.MeshLambertMaterial({color: kColours.wall}), rectangles.length);
    const matrix = new THREE.Matrix4();
    rectangles.forEach(([column, row, columns, rows], i) => {
      matrix.makeScale(columns * resolution, rows * resolution, kWallHeight);
      matrix.setPosition(x + (column + columns / 2) * resolution,
                         y + (row + rows / 2) * resolution, kWallHeight / 2);
      walls.setMatrixAt(i, matrix);
    });
    walls.frustumCulled = false;  // it knows the place of one wall only
    this.scene.add(ground, walls);
    this.draw();
  }

  setWay(way) {
    this.path.children.slice().forEach(part => {
      part.geometry.dispose();
      part.material.dispose();
      this.path.remove(part);
    });
    if (way) this.addWay(way);
    super.setWay(way);
  }

  // Seen through walls.
  addWay(way) {
    const material = colour =>
        new THREE.MeshBasicMaterial({color: colour, depthTest: false, transparent: true});
    const add = (geometry, colour, [x, y], z) => {
      const part = new THREE.Mesh(geometry, material(colour));
      part.position.set(x, y, z);
      part.renderOrder = 1;
      this.path.add(part);
      return part;
    };
    const blue = kColours.way, radius = 0.14;
    way.points.forEach((point, i) => {
      add(new THREE.SphereBufferGeometry(radius, 12, 8), blue, point, radius);
      if (i === 0) return;
      const [x, y] = way.points[i - 1], dx = point[0] - x, dy = point[1] - y;
      const length = Math.hypot(dx, dy);
      const leg = add(new THREE.CylinderBufferGeometry(radius, radius, length, 12), blue,
                      [x + dx / 2, y + dy / 2], radius);
      leg.rotation.z = Math.atan2(dy, dx) - Math.PI / 2;  // a cylinder lies along y
    });
    const end = way.points[way.points.length - 1], colour = way.there ? kColours.end : blue;
    const pin = add(new THREE.ConeBufferGeometry(0.4, 1.6, 20), colour, end, 0.8);
    pin.rotation.x = -Math.PI / 2;  // upside down
    add(new THREE.SphereBufferGeometry(0.42, 20, 14), colour, end, 1.75);
  }

  makeRobot() {
    const robot = new THREE.Group();
    const body = new THREE.Mesh(new THREE.CylinderBufferGeometry(0.33, 0.33, 1.2, 24),
                                new THREE.MeshLambertMaterial({color: kColours.robot}));
    body.rotation.x = Math.PI / 2;
    body.position.z = 0.6;
    const nose = new THREE.Mesh(new THREE.ConeBufferGeometry(0.2, 0.5, 20),
                                new THREE.MeshLambertMaterial({color: kColours.nose}));
    nose.rotation.z = -Math.PI / 2;  // a cone points along y
    nose.position.set(0.45, 0, 1);
    robot.add(body, nose);
    robot.visible = false;
    return robot;
  }

  draw() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!this.renderer || !this.info || width === 0 || height === 0) return;
    this.renderer.setPixelRatio(window.devicePixelRatio || 1);
    this.renderer.setSize(width, height, false);
    const distance = this.look(width / height);
    this.robot.visible = Boolean(this.pose);
    if (this.pose) {
      this.robot.position.set(this.pose[0], this.pose[1], 0);
      this.robot.rotation.z = this.pose[2];
      this.robot.scale.setScalar(Math.max(1, distance / 30));  // to be seen
    }
    this.renderer.render(this.scene, this.camera);
  }

  // From the south, as near as all of the area is in sight. Returns how far that is [m].
  look(aspect) {
    const {left, right, low, high} = this.area(), camera = this.camera;
    camera.aspect = aspect;
    camera.updateProjectionMatrix();
    camera.up.set(0, 0, 1);
    const x = (left + right) / 2, y = (low + high) / 2;
    const place = distance => {
      camera.position.set(x, y - distance * Math.cos(kTilt), distance * Math.sin(kTilt));
      camera.lookAt(x, y, 0);
      camera.updateMatrixWorld();
    };
    const isInSight = ([x, y, z]) => {
      const seen = new THREE.Vector3(x, y, z).project(camera);
      return Math.abs(seen.x) < 0.97 && Math.abs(seen.y) < 0.97;
    };
    const corners = [0, kWallHeight].flatMap(
        z => [[left, low, z], [right, low, z], [left, high, z], [right, high, z]]);
    let near = 1, far = 500;
    while (far - near > 0.05) {
      const middle = (near + far) / 2;
      place(middle);
      if (corners.every(isInSight)) far = middle; else near = middle;
    }
    place(far);
    return far;
  }
}
