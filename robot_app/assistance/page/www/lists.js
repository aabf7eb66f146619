// Requests, alarms, programs and trees as lists. Texts of the robot are texts, never markup.
"use strict";

function make(tag, className, text) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  if (text !== undefined) element.textContent = text;
  return element;
}

function ago(seconds) {
  return seconds < 90 ? `${seconds} s` : `${Math.round(seconds / 60)} min`;
}

// The open requests, and the one that brought this person here.
function showRequests(place, requests, own, mayAnswer, answer) {
  const shown = requests.filter(one => one.state === "open" || one.id === own);
  const key = JSON.stringify(shown.map(one => [one.id, one.state, one.question, one.taken_by]));
  for (const one of shown) {
    const about = document.getElementById("about_" + one.id);
    if (about) about.textContent = aboutRequest(one);
  }
  if (place.dataset.key === key) return;  // a button that is pressed stays
  place.dataset.key = key;
  place.replaceChildren(...shown.map(one => {
    const isOpen = one.state === "open";
    const card = make("div", isOpen ? "request" : "request closed");
    const about = make("div", "about", aboutRequest(one));
    about.id = "about_" + one.id;
    card.append(about, make("p", "", isOpen ? one.question : one.message));
    if (isOpen && mayAnswer) {
      const buttons = make("div", "buttons");
      const fixed = make("button", "good fixed", "Fixed");
      const notFixed = make("button", "not_fixed", "Not fixed");
      fixed.onclick = () => answer(one.id, true);
      notFixed.onclick = () => answer(one.id, false);
      buttons.append(fixed, notFixed);
      card.append(buttons);
    }
    return card;
  }));
}

function aboutRequest(one) {
  const taken = one.taken_by ? `, ${one.taken_by} looks at it` : "";
  return one.state === "open"
      ? `${one.subject} \u00b7 for ${ago(one.age)}, ${ago(one.left)} left${taken}`
      : `${one.subject} \u00b7 ${one.state}`;
}

function showAlarms(place, entries) {
  const bad = entries.filter(entry => entry.level !== "ok");
  const items = bad.map(entry => {
    const item = make("li");
    const text = make("div", "grow");
    text.append(make("div", "", `${entry.monitor}: ${entry.subject}`),
                make("div", "about", entry.message));
    item.append(make("span", "light " + entry.level), text);
    return item;
  });
  const rest = make("li");
  rest.append(make("span", "light ok"), make("div", "grow", `${entries.length - bad.length} OK`));
  place.replaceChildren(...items, rest);
  return bad;
}

function worstOf(groupProcesses) {
  const order = ["given up", "unreachable", "backing off", "starting", "stopped", "ready"];
  const states = groupProcesses.map(process => process.state);
  return order.find(state => states.includes(state)) || "stopped";
}

const kLights = {"ready": "ok", "stopped": "", "starting": "warn", "backing off": "warn"};

// Pressed twice within four seconds.
function sureButton(label, question, act) {
  const button = make("button", "", label);
  let timer = null;
  const calm = () => {
    timer = null;
    button.textContent = label;
    button.className = "";
  };
  button.onclick = () => {
    if (timer === null) {
      button.textContent = question;
      button.className = "sure";
      timer = setTimeout(calm, 4000);
    } else {
      clearTimeout(timer);
      calm();
      act();
    }
  };
  return button;
}

function showGroups(place, groups, mayRestart, restart) {
  const key = JSON.stringify(groups);
  if (place.dataset.key === key) return;
  place.dataset.key = key;
  place.replaceChildren(...groups.map(group => {
    const state = worstOf(group.processes);
    const item = make("li");
    const text = make("div", "grow");
    const names = group.processes.map(process => process.name).join(", ");
    text.append(make("div", "", group.name),
                make("div", "about", names === group.name ? state : `${state} \u00b7 ${names}`));
    item.append(make("span", "light " + (state in kLights ? kLights[state] : "error")), text);
    if (mayRestart)
      item.append(sureButton("Restart", "Really?", () => restart(group.name)));
    return item;
  }));
}

function showTrees(place, trees) {
  place.replaceChildren(...trees.map(tree => {
    const line = make("div");
    const what = !tree.live ? "is not there" : tree.path.slice(1).join(" \u203a ") || "rests";
    line.append(make("b", "", tree.name + ": "), make("span", "", what));
    return line;
  }));
}
