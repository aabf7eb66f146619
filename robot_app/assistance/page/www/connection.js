// The connection to the robot: logs in with the token behind "#", keeps a WebSocket, comes back.
"use strict";

class Connection {
  constructor(handlers) {
    this.handlers = handlers;  // text(message), bytes(buffer), live(is_live), needLogin(reason)
    this.socket = null;
  }

  async begin() {
    const token = decodeURIComponent(location.hash.slice(1));
    if (token) {
      history.replaceState(null, "", location.pathname);  // works once; nobody should copy it
      const refusal = await this.logIn(token);
      this.refusal = refusal;
    }
    this.connect();
  }

  // Empty, or why not.
  async logIn(token) {
    try {
      const reply = await fetch("login", {method: "POST", body: JSON.stringify({token})});
      return reply.ok ? "" : await reply.text();
    } catch (error) {
      return "The robot does not answer.";
    }
  }

  async logOut() {
    await fetch("logout", {method: "POST"});
    if (this.socket) this.socket.close();
  }

  connect() {
    const scheme = location.protocol === "https:" ? "wss://" : "ws://";
    const socket = new WebSocket(scheme + location.host + "/live");
    let wasOpen = false;
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      wasOpen = true;
      this.socket = socket;
      this.handlers.live(true);
    };
    socket.onmessage = event => {
      if (typeof event.data === "string") this.handlers.text(JSON.parse(event.data));
      else this.handlers.bytes(event.data);
    };
    socket.onclose = () => {
      this.socket = null;
      this.handlers.live(false);
      if (!wasOpen) return this.findOutWhy();
      setTimeout(() => this.connect(), 1000);
    };
  }

  // A browser does not say whether it was refused or nobody was there.
  async findOutWhy() {
    try {
      await fetch("page.css", {cache: "no-store"});
      this.handlers.needLogin(this.refusal || "");
    } catch (error) {
      setTimeout(() => this.connect(), 1000);
    }
  }

  send(command) {
    if (this.socket && this.socket.readyState === WebSocket.OPEN) {
      this.socket.send(JSON.stringify(command));
      return true;
    }
    return false;
  }
}
