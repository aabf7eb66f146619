// The page of the robot's tablet. Who goes away leaves nothing behind: after 45 s it is as new.
"use strict";

// What the page has other buttons for.
const kElsewhere = new Set(["language", "back", "yes", "no"]);
const kIdle = 45000;      // ms
const kStatePeriod = 250;  // ms
const kTalkPeriod = 500;   // ms

const kWords = {
  en: {title: "How can I help you?", home: "Start", find: "Search", guide: "Guide me there", stop: "Stop guiding",
       talk: "Hold to talk", talking: "I am listening", question: "Name, room, place …", back: "Back",
       coming: "Please follow me.", lost: "I could not lead you to the end. Please ask again.",
       error: "Not now, please. Try again in a moment."},
  de: {title: "Wie kann ich Ihnen helfen?", home: "Anfang", find: "Suchen", guide: "Bringen Sie mich hin",
       stop: "Nicht mehr führen", talk: "Halten und sprechen", talking: "Ich höre zu",
       question: "Name, Raum, Ort …", back: "Zurück", coming: "Bitte folgen Sie mir.",
       lost: "Ich konnte Sie nicht bis ans Ziel bringen. Fragen Sie gern noch einmal.",
       error: "Gerade geht das nicht. Bitte gleich noch einmal."}};

const element = id => document.getElementById(id);
const plan = makeFloor(element("floor"));
let homeLanguage = "en", language = homeLanguage;
let path = [];
let place = "";          // to which the visitor can be led
let isAsked = false;     // the buttons are those of a question
let isUsed = false;      // since the last start
let idleTimer = 0, talkTimer = 0;
let faceNumber = -1, saidNumber = -1;
const words = () => kWords[language];
const call = (what, more = {}) => ask({do: what, language, ...more});

// In three dimensions where the page has three.js and the browser WebGL.
function makeFloor(canvas) {
  try {
    if (window.THREE) return new Floor3d(canvas);
  } catch (error) {
    console.info("no WebGL here: " + error);
  }
  return new Floor(canvas);
}

function showWords() {
  document.documentElement.lang = language;
  for (const id of ["title", "home", "find", "guide", "stop", "talk"]) element(id).textContent = words()[id];
  element("question").placeholder = words().question;
  element("english").classList.toggle("on", language === "en");
  element("german").classList.toggle("on", language === "de");
}

function tell(text, mood = "answered") {
  element("answer").hidden = !text;
  element("answer").textContent = text;
  element("answer").classList.toggle("unknown", mood === "unknown");
}

function showAnswer(answer) {
  if (answer.error) return tell(words().error, "unknown");
  tell(answer.text + (answer.way && answer.way.words && !answer.text.includes(answer.way.words)
                      ? "\n" + answer.way.words : ""), answer.mood);
  place = answer.way ? answer.place : "";
  plan.setWay(answer.way);
  element("guide").hidden = !place;
  element("stop").hidden = true;
  if (answer.choices.length) return showChoices(answer.choices);
  if (isAsked) go([]);
}

// The robot has asked back.
function showChoices(labels) {
  isAsked = true;
  element("buttons").replaceChildren();
  labels.forEach((label, number) =>
    addButton(label, async () => {
      await start();
      showAnswer(await call("choose", {number}));
    }));
}

function addButton(label, onPress) {
  const button = document.createElement("button");
  button.textContent = label;
  button.addEventListener("click", onPress);
  element("buttons").append(button);
}

// A path with buttons goes on; one that means something is answered.
async function go(next) {
  const screen = await call("screen", {path: next});
  if (screen.error) return tell(words().error, "unknown");
  if (screen.answers) showAnswer(await call("press", {path: next}));
  if (!screen.buttons.length) return;
  path = next;
  isAsked = false;
  element("buttons").replaceChildren();
  if (path.length) addButton("← " + words().back, () => go(path.slice(0, -1)));
  for (const {step, label} of screen.buttons) {
    if (path.length || !kElsewhere.has(step)) addButton(label, () => go([...path, step]));
  }
  element("buttons").scrollTop = 0;
}

function start() {
  tell("");
  place = "";
  plan.setWay(null);
  element("guide").hidden = element("stop").hidden = true;
  element("question").value = "";
  showWords();
  return go([]);
}

function leave() {
  isUsed = false;
  language = homeLanguage;
  endTalk();
  call("leave");
  start();
}

function use() {
  clearTimeout(idleTimer);
  idleTimer = setTimeout(leave, kIdle);
  if (isUsed) return;
  isUsed = true;
  call("touched");
}

function setLanguage(wanted) {
  language = wanted;
  start();
}

async function guide() {
  const reply = await call("guide", {place});
  if (reply.error) return tell(words().error, "unknown");
  tell(words().coming);
  element("guide").hidden = true;
  element("stop").hidden = false;
}

function beginTalk() {
  element("talk").classList.add("on");
  element("talk").textContent = words().talking;
  clearInterval(talkTimer);
  const say = () => call("talk", {on: true});
  talkTimer = setInterval(say, kTalkPeriod);
  say();
}

function endTalk() {
  if (!element("talk").classList.contains("on")) return;
  clearInterval(talkTimer);
  element("talk").classList.remove("on");
  element("talk").textContent = words().talk;
  call("talk", {on: false});
}

async function look() {
  const state = await call("state", {face: faceNumber, said: saidNumber});
  if (!state.error) {
    if (state.language !== homeLanguage) {
      homeLanguage = state.language;
      if (!isUsed) setLanguage(homeLanguage);
    }
    if (state.face) drawFace(element("face"), state.face);
    faceNumber = state.face_number;
    plan.setPose(state.pose);
    if (state.said && saidNumber >= 0) {
      use();
      showAnswer(state.said);
    }
    saidNumber = state.said_number;
    if (!element("stop").hidden && state.outcome) {
      element("stop").hidden = true;
      if (state.outcome !== "arrived") tell(words().lost);
    }
  }
  if (!plan.info || !plan.info.width) {
    const map = await call("map");
    if (!map.error && map.width) plan.setMap(map);
  }
  setTimeout(look, kStatePeriod);
}

addEventListener("pointerdown", use, {capture: true});
addEventListener("keydown", use, {capture: true});
element("english").addEventListener("click", () => setLanguage("en"));
element("german").addEventListener("click", () => setLanguage("de"));
element("home").addEventListener("click", start);
element("guide").addEventListener("click", guide);
element("stop").addEventListener("click", () => { call("stop"); start(); });
element("talk").addEventListener("pointerdown", beginTalk);
for (const end of ["pointerup", "pointercancel", "pointerleave"])
  element("talk").addEventListener(end, endTalk);
element("talk").addEventListener("contextmenu", event => event.preventDefault());
element("search").addEventListener("submit", async event => {
  event.preventDefault();
  const text = element("question").value.trim();
  if (text) showAnswer(await call("ask", {text}));
});
start();
look();
