// Pairs of opposite words, in an order of its own for each person, so that no scale is seen as one.
"use strict";

const kWords = {
  en: {how: "Please mark for each pair of words what fits better.", send: "Done", thanks: "Thank you!",
       error: "That could not be saved. Please tell somebody of the staff."},
  de: {how: "Bitte kreuzen Sie bei jedem Wortpaar an, was eher zutrifft.", send: "Fertig", thanks: "Vielen Dank!",
       error: "Das konnte nicht gespeichert werden. Bitte sagen Sie jemandem Bescheid."}};

const element = id => document.getElementById(id);
let questions = null, language = "en", marks = [], order = [];

async function call(body) {
  const reply = await fetch("/call", {method: "POST", body});
  return reply.ok ? reply.json() : {error: String(reply.status)};
}

function shuffled(count) {
  const numbers = [...Array(count).keys()];
  for (let i = count - 1; i > 0; --i) {
    const k = Math.floor(Math.random() * (i + 1));
    [numbers[i], numbers[k]] = [numbers[k], numbers[i]];
  }
  return numbers;
}

function addItem(index) {
  const item = questions.items[index], row = document.createElement("fieldset");
  const word = text => Object.assign(document.createElement("span"), {textContent: text});
  row.append(word(item.low[language]));
  for (let mark = 1; mark <= questions.points; ++mark) {
    const input = Object.assign(document.createElement("input"), {
      type: "radio", name: "item" + index, value: mark, checked: marks[index] === mark,
      ariaLabel: `${item.low[language]} – ${item.high[language]}: ${mark}`});
    input.addEventListener("change", () => { marks[index] = mark; });
    const label = document.createElement("label");
    label.append(input);
    row.append(label);
  }
  row.append(word(item.high[language]));
  element("items").append(row);
}

function show() {
  document.documentElement.lang = language;
  element("title").textContent = questions.title[language];
  for (const id of ["how", "send"]) element(id).textContent = kWords[language][id];
  element("items").replaceChildren();
  order.forEach(addItem);
}

function begin() {
  marks = Array(questions.items.length).fill(0);
  order = shuffled(questions.items.length);
  element("form").hidden = element("how").hidden = false;
  element("told").hidden = true;
  show();
}

async function send(event) {
  event.preventDefault();
  const reply = await call(JSON.stringify({marks}));
  element("told").textContent = reply.error ? kWords[language].error : kWords[language].thanks;
  element("told").hidden = false;
  if (reply.error) return;
  element("form").hidden = element("how").hidden = true;
  scrollTo(0, 0);
  setTimeout(begin, 5000);
}

for (const wanted of ["en", "de"])
  element(wanted).addEventListener("click", () => { language = wanted; show(); });
element("form").addEventListener("submit", send);
call("").then(reply => { questions = reply; begin(); });
