// A friendly face, drawn flat and laid on the head from the front.
import * as THREE from "three";

const kSize = 1024; // pixels a side
const kInk = "#3b2a3a";

function drawEye(context, iris) {
  const lid = () => {
    context.beginPath();
    context.moveTo(-88, 20);
    context.bezierCurveTo(-76, -62, 60, -84, 88, -6);
  };
  // White, iris, pupil, lights: all clipped to the opening.
  context.save();
  lid();
  context.bezierCurveTo(84, 60, 50, 96, 0, 98);
  context.bezierCurveTo(-50, 98, -78, 70, -88, 20);
  context.clip();
  context.fillStyle = "#ffffff";
  context.fillRect(-120, -120, 240, 240);
  const shade = context.createLinearGradient(0, -60, 0, 100);
  shade.addColorStop(0.1, iris[0]);
  shade.addColorStop(0.55, iris[1]);
  shade.addColorStop(1, iris[2]);
  context.fillStyle = shade;
  context.beginPath();
  context.ellipse(2, 18, 58, 84, 0, 0, 7);
  context.fill();
  context.fillStyle = iris[0];
  context.beginPath();
  context.ellipse(2, 14, 24, 40, 0, 0, 7);
  context.fill();
  context.fillStyle = "rgb(60 30 60 / 35%)";
  context.fillRect(-120, -120, 240, 92);
  context.fillStyle = "#ffffff";
  context.beginPath();
  context.ellipse(-20, -14, 18, 22, -0.3, 0, 7);
  context.ellipse(26, 62, 10, 12, 0, 0, 7);
  context.fill();
  context.restore();
  context.strokeStyle = kInk;
  context.lineCap = context.lineJoin = "round";
  context.lineWidth = 20;
  lid();
  context.lineTo(104, -18);
  context.stroke();
  context.lineWidth = 7;
  context.beginPath();
  context.moveTo(-34, 101);
  context.quadraticCurveTo(10, 108, 52, 88);
  context.stroke();
  context.lineWidth = 6;
  context.beginPath();
  context.moveTo(-62, -72);
  context.quadraticCurveTo(10, -106, 76, -66);
  context.stroke();
}

function drawBrow(context, color) {
  context.strokeStyle = color;
  context.lineWidth = 15;
  context.lineCap = "round";
  context.beginPath();
  context.moveTo(-84, -140);
  context.quadraticCurveTo(10, -186, 92, -142);
  context.stroke();
}

/** @param look  iris (three colors, top first), brow (a color) */
export function faceTexture({ iris, brow }) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = kSize;
  const context = canvas.getContext("2d");
  for (const side of [-1, 1]) {
    context.save();
    context.translate(kSize / 2 + side * 215, 470);
    context.scale(side * 1.12, 1.12);
    drawEye(context, iris);
    drawBrow(context, brow);
    context.restore();
    context.fillStyle = "rgb(240 120 120 / 30%)";
    context.beginPath();
    context.ellipse(kSize / 2 + side * 262, 650, 58, 30, 0, 0, 7);
    context.fill();
  }
  context.strokeStyle = "#9a4a4a";
  context.lineWidth = 10;
  context.lineCap = "round";
  context.beginPath();
  context.moveTo(kSize / 2 - 52, 772);
  context.quadraticCurveTo(kSize / 2, 806, kSize / 2 + 52, 772);
  context.stroke();
  context.fillStyle = "#d98f80";
  context.beginPath();
  context.ellipse(kSize / 2 + 4, 625, 11, 8, 0, 0, 7);
  context.fill();
  const texture = new THREE.CanvasTexture(canvas);
  texture.anisotropy = 4;
  return texture;
}
