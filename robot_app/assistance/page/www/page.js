// The supervisor page: what the robot tells goes to its places, what the person does to the robot.
"use strict";

const at = id => document.getElementById(id);
const kPicture = 1, kMap = 2;  // first byte of what is binary

let hello = null;
let wheel = {driver: 0, name: "", held: ""};
let beat = null;  // the robot's newest: what is older when it comes back is not obeyed
let isLive = false;
const watched = new Set();
const pictures = new Map();

const connection = new Connection({
  live: is => {
    isLive = is;
    at("link").textContent = is ? "online" : "offline";
    at("link").className = is ? "on" : "off";
    if (!is) stick.release();
    showWheel();
  },
  text: message => (handlers[message.type] || (() => {}))(message),
  bytes: buffer => {
    const kind = new DataView(buffer).getUint8(0);
    if (kind === kMap) map.setCells(buffer);
    if (kind === kPicture) showPicture(new DataView(buffer).getUint8(1), buffer.slice(2));
  },
  needLogin: refusal => {
    at("login").hidden = false;
    at("main").hidden = at("tabs").hidden = true;
    at("refusal").textContent = refusal;
  },
});

const stick = new Stick(at("stick"), at("knob"), (ahead, left, isHeld) => {
  if (!hello || !hello.operator) return;
  if (isHeld && wheel.driver !== hello.client) connection.send({do: "take", over: false});
  if (isHeld || wheel.driver === hello.client) {
    const turn = ahead < 0 ? -left : left;  // backwards, the stick shows where the tail goes
    const command = {linear: ahead * hello.linear, angular: turn * hello.angular};
    if (beat !== null) connection.send({do: "drive", ...command, beat});
  }
});

const map = new RobotMap(at("map"), arrow => {
  at("pose_ok").hidden = false;
  at("pose_text").textContent = `x ${arrow.x.toFixed(1)} m, y ${arrow.y.toFixed(1)} m, ` +
      `${Math.round(arrow.yaw * 180 / Math.PI)}\u00b0`;
});

const handlers = {
  hello: message => {
    hello = message;
    at("login").hidden = true;
    at("main").hidden = at("tabs").hidden = false;
    at("robot").textContent = document.title = hello.robot;
    at("who").textContent = hello.name + (hello.operator ? "" : " (watches)");
    at("stick").hidden = at("set_pose").hidden = !hello.operator;
    showEditor(hello.editor);
    showCameraButtons();
    if (watched.size === 0 && hello.cameras.length > 0) watched.add(hello.cameras[0]);
    sendCameras();
    map.draw();
  },
  place: message => map.setPlace(message.pose, message.scan),
  requests: message => showRequests(at("requests"), message.requests, hello.request, hello.operator,
                                    (request, fixed) => connection.send({do: "answer", request, fixed})),
  health: message => {
    const bad = showAlarms(at("alarms"), message.entries);
    const has = level => bad.some(entry => entry.level === level);
    at("alarm_count").textContent = bad.length || "";
    at("light").className = "light " + (has("error") ? "error" : bad.length ? "warn" : "ok");
  },
  processes: message => {
    at("configuration").textContent =
        message.configuration + (message.safe_stop ? ", stopped for safety" : "");
    showGroups(at("groups"), message.groups, hello.operator,
               name => connection.send({do: "restart", name}));
  },
  trees: message => showTrees(at("trees"), message.trees),
  beat: message => {
    beat = message.beat;
  },
  wheel: message => {
    wheel = message;
    showWheel();
  },
  wheel_taken: () => {
    at("take_over").hidden = false;
  },
  told: message => tell(message.text, message.ok),
};

let toldTimer = null;
function tell(text, ok) {
  at("told").textContent = text;
  at("told").className = ok ? "" : "bad";
  at("told").hidden = false;
  clearTimeout(toldTimer);
  toldTimer = setTimeout(() => at("told").hidden = true, 8000);
}

function showWheel() {
  const mine = hello && wheel.driver === hello.client;
  const others = wheel.driver !== 0 && !mine;
  const text = !isLive ? "No connection: the robot stands still."
      : wheel.held && mine ? wheel.held
      : mine ? "You drive. The robot waits for you."
      : others ? wheel.name + " drives." : "The robot drives by itself.";
  at("wheel").textContent = text;
  at("wheel").className = wheel.held && mine ? "held" : "";
  at("stick").classList.toggle("blocked", Boolean(wheel.held && mine));
  at("leave").hidden = !mine;
  if (!others) at("take_over").hidden = true;
}

function showCameraButtons() {
  at("cameras").replaceChildren(...hello.cameras.map(name => {
    const button = make("button", watched.has(name) ? "on" : "", name);
    button.onclick = () => {
      if (!watched.delete(name)) watched.add(name);
      sendCameras();
    };
    return button;
  }));
}

function sendCameras() {
  connection.send({do: "cameras", names: [...watched]});
  showCameraButtons();
  for (const [name, image] of pictures) {
    if (watched.has(name)) continue;
    image.remove();
    pictures.delete(name);
  }
}

function showPicture(number, jpeg) {
  const name = hello.cameras[number];
  if (!watched.has(name)) return;
  if (!pictures.has(name)) {
    if (pictures.size === 0) at("pictures").replaceChildren();
    const image = make("img");
    image.alt = name + " camera";
    at("pictures").append(image);
    pictures.set(name, image);
  }
  const image = pictures.get(name);
  const old = image.src;
  image.src = URL.createObjectURL(new Blob([jpeg], {type: "image/jpeg"}));
  if (old) URL.revokeObjectURL(old);
}

function showEditor(address) {
  if (!address || at("editor")) return;
  const link = make("a", "", "Open the trees in the editor");
  link.id = "editor";
  link.href = address;
  link.rel = "noreferrer";
  at("trees").after(link);
}

function showTab(id) {
  for (const tab of document.querySelectorAll(".tab")) tab.classList.toggle("shown", tab.id === id);
  for (const button of at("tabs").children) button.classList.toggle("on", button.dataset.tab === id);
  stick.release();
  map.draw();
}

function endSetting() {
  map.endSetting();
  at("pose_bar").hidden = true;
  at("set_pose").classList.remove("on");
}

for (const button of at("tabs").children) button.onclick = () => showTab(button.dataset.tab);
at("take_over").onclick = () => connection.send({do: "take", over: true});
at("leave").onclick = () => connection.send({do: "leave"});
at("nearer").onclick = () => map.zoom(1.4);
at("farther").onclick = () => map.zoom(1 / 1.4);
at("follow").onclick = () => map.follow();
at("set_pose").onclick = () => {
  map.beginSetting();
  at("set_pose").classList.add("on");
  at("pose_bar").hidden = false;
  at("pose_ok").hidden = true;
  at("pose_text").textContent = "Press where the robot is and drag to where it looks.";
};
at("pose_cancel").onclick = endSetting;
at("pose_ok").onclick = () => {
  const {x, y, yaw} = map.arrow;
  connection.send({do: "set_pose", x, y, yaw});
  endSetting();
};
at("logout").onclick = () => connection.logOut();
at("login_form").onsubmit = async event => {
  event.preventDefault();
  const refusal = await connection.logIn(at("token").value);
  at("token").value = "";
  at("refusal").textContent = refusal;
  if (!refusal) connection.connect();
};

showTab("drive");
connection.begin();
