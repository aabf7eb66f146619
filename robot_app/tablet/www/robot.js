// What the page asks of the robot, and the robot's face.
"use strict";

async function ask(call) {
  try {
    const reply = await fetch("/call", {method: "POST", headers: {"Content-Type": "application/json"},
                                        body: JSON.stringify(call)});
    return reply.ok ? await reply.json() : {error: String(reply.status)};
  } catch (error) {
    return {error: "offline"};
  }
}

// Pixels as hexadecimal digits, red, green and blue of each.
function drawFace(canvas, pixels) {
  const context = canvas.getContext("2d");
  const image = context.createImageData(64, 32);
  for (let i = 0; i < 64 * 32; ++i) {
    for (let k = 0; k < 3; ++k)
      image.data[4 * i + k] = parseInt(pixels.substr(6 * i + 2 * k, 2), 16);
    image.data[4 * i + 3] = 255;
  }
  context.putImageData(image, 0, 0);
}
