/** Colors of a face. */
export interface FaceLook {
  /** Top, middle, bottom. */
  readonly iris: readonly [string, string, string];
  readonly brow: string;
}

const kInk = "#3b2a3a";
const kDrawnAt = 1024; // pixels a side that the numbers below are written for

function openLid(context: CanvasRenderingContext2D): void {
  context.beginPath();
  context.moveTo(-88, 20);
  context.bezierCurveTo(-76, -62, 60, -84, 88, -6);
}

type Fill = string | CanvasGradient;

function fillOval(context: CanvasRenderingContext2D, color: Fill, x: number, y: number, width: number, height: number, turn = 0): void {
  context.fillStyle = color;
  context.beginPath();
  context.ellipse(x, y, width, height, turn, 0, 2 * Math.PI);
  context.fill();
}

/** Start, control point, end. */
type Arc = readonly [number, number, number, number, number, number];

function strokeArc(context: CanvasRenderingContext2D, color: string, width: number, [x0, y0, x1, y1, x2, y2]: Arc): void {
  context.strokeStyle = color;
  context.lineWidth = width;
  context.lineCap = context.lineJoin = "round";
  context.beginPath();
  context.moveTo(x0, y0);
  context.quadraticCurveTo(x1, y1, x2, y2);
  context.stroke();
}

/** White, iris, pupil, lights: all clipped to the opening. */
function drawEyeball(context: CanvasRenderingContext2D, iris: FaceLook["iris"]): void {
  context.save();
  openLid(context);
  context.bezierCurveTo(84, 60, 50, 96, 0, 98);
  context.bezierCurveTo(-50, 98, -78, 70, -88, 20);
  context.clip();
  context.fillStyle = "#ffffff";
  context.fillRect(-120, -120, 240, 240);
  const shade = context.createLinearGradient(0, -60, 0, 100);
  shade.addColorStop(0.1, iris[0]);
  shade.addColorStop(0.55, iris[1]);
  shade.addColorStop(1, iris[2]);
  fillOval(context, shade, 2, 18, 58, 84);
  fillOval(context, iris[0], 2, 14, 24, 40);
  context.fillStyle = "rgb(60 30 60 / 35%)";
  context.fillRect(-120, -120, 240, 92);
  fillOval(context, "#ffffff", -20, -14, 18, 22, -0.3);
  fillOval(context, "#ffffff", 26, 62, 10, 12);
  context.restore();
}

function drawEye(context: CanvasRenderingContext2D, { iris, brow }: FaceLook): void {
  drawEyeball(context, iris);
  context.strokeStyle = kInk;
  context.lineCap = context.lineJoin = "round";
  context.lineWidth = 20;
  openLid(context);
  context.lineTo(104, -18);
  context.stroke();
  strokeArc(context, kInk, 7, [-34, 101, 10, 108, 52, 88]);
  strokeArc(context, kInk, 6, [-62, -72, 10, -106, 76, -66]);
  strokeArc(context, brow, 15, [-84, -140, 10, -186, 92, -142]);
}

/** Draws a friendly face, flat and from the front, over the whole of a square canvas; the rest is transparent. */
export function drawFace(context: CanvasRenderingContext2D, look: FaceLook): void {
  const { width } = context.canvas;
  context.clearRect(0, 0, width, width);
  context.save();
  context.scale(width / kDrawnAt, width / kDrawnAt);
  context.translate(kDrawnAt / 2, 0);
  for (const side of [-1, 1]) {
    context.save();
    context.translate(side * 215, 470);
    context.scale(side * 1.12, 1.12);
    drawEye(context, look);
    context.restore();
    fillOval(context, "rgb(240 120 120 / 30%)", side * 262, 650, 58, 30);
  }
  strokeArc(context, "#9a4a4a", 10, [-52, 772, 0, 806, 52, 772]);
  fillOval(context, "#d98f80", 4, 625, 11, 8);
  context.restore();
}
