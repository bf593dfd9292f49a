/** A figure: its marks as elements, which go along with the drivers. */
import { partOf, setAttributes } from "./dom.js";

/** @import { PlaneData, Row, Shown } from "./state.js" */
/** @typedef {{group: SVGElement, element: SVGElement, grasp?: SVGElement, head?: SVGElement, row: Row, hidden: boolean,
 * at: number[]}} Piece */

const TIP = 2.8; // of an arrow head; half of it on arrows that are too short for it [mm]
const ZOOM_MARGIN = 8; // about the points of a polygon, for their letters [mm]

/** @param {number} value */
function coordinate(value) {
  return String(Math.round(value * 1e4) / 1e4);
}

/** One plane of a mechanism on a paper of its own. */
export class PlaneFigure {
  /** @param {Shown} shown @param {PlaneData} plane @param {HTMLElement} section which holds its drawing */
  constructor(shown, plane, section) {
    this.shown = shown;
    this.plane = plane;
    this.section = section;
    /** @type {SVGSVGElement} */
    this.drawing = partOf(section, "svg");
    this.drawing.style.aspectRatio = `${plane.width} / ${plane.height}`;
    this.box = "";
    this.letters = 1;
    /** @type {number[][]} where something is turned, and how far it reaches: x, y, r */
    this.turning = [];
    /** @type {SVGElement} */
    this.figure = partOf(this.drawing, "g");
    this.pieces = plane.rows.map((row, k) => pieceOf(row, /** @type {SVGElement} */ (this.figure.children[k])));
  }

  /** All marks where they are now. */
  move() {
    const { plane: { mask, cells }, shown: { tracks } } = this;
    const drawn = tracks.isShown(mask, cells);
    this.section.classList.toggle("empty", !drawn);
    this.section.classList.toggle("between", typeof cells === "number" && !tracks.atKnot && tracks.isBeside(mask));
    this.figure.toggleAttribute("hidden", !drawn);
    if (!drawn) return;
    for (const piece of this.pieces) {
      const { row } = piece;
      const hidden = !tracks.isNear(row.mask);
      if (hidden !== piece.hidden) {
        piece.hidden = hidden;
        piece.group.style.visibility = hidden ? "hidden" : "";
      }
      if (!hidden) moveTo(piece, row.numbers.map((number) => tracks.value(number, row.mask)), this.letters);
    }
    this.zoom();
  }

  /** A paper that is larger where the polygon is larger than usual, or where there is room to be for what is turned. */
  zoom() {
    const { width, height, plane } = this.plane;
    let [left, top, right, bottom] = [0, 0, width, height];
    const points = plane === "position" ? [] : this.pieces.filter(({ row, at }) => row.kind === "point" && at.length);
    for (const [x, y, margin] of [...points.map(({ at }) => [...at, ZOOM_MARGIN]), ...this.turning]) {
      [left, top] = [Math.min(left, x - margin), Math.min(top, y - margin)];
      [right, bottom] = [Math.max(right, x + margin), Math.max(bottom, y + margin)];
    }
    const [wide, high] = [right - left, bottom - top];
    const box = [left, top, wide, high].map((side) => side.toFixed(2)).join(" ");
    if (box === this.box) return;
    this.box = box;
    this.letters = Math.max(wide / width, high / height); // and arrows' heads and lines are as large as ever
    for (const piece of this.pieces) piece.at = [];
    this.drawing.style.setProperty("--letters", String(this.letters));
    this.drawing.setAttribute("viewBox", box);
    this.drawing.style.setProperty("--wide", `${wide.toFixed(2)}mm`);
    this.drawing.style.setProperty("--high", `${high.toFixed(2)}mm`);
    this.move();
  }

  /** Marks after a step are hidden, those before it grey; 0 shows the whole. @param {number} step */
  showStep(step) {
    this.drawing.classList.toggle("stepping", step > 0);
    for (const { group, row } of this.pieces) {
      const own = row.step ?? 0;
      group.classList.toggle("later", step > 0 && own > step);
      group.classList.toggle("earlier", step > 0 && own > 0 && own < step);
      group.classList.toggle("new", step > 0 && own === step);
    }
  }
}

/** The element of a row; an arrow's are its room for a pointer, its head and its line. @param {Row} row
 * @param {SVGElement} group @returns {Piece} */
function pieceOf(row, group) {
  const [grasp, head, line] = /** @type {SVGElement[]} */ (row.kind === "vector" ? [...group.children] : []);
  return { group, element: line ?? group, grasp, head, row, hidden: false, at: [] };
}

/** @param {Piece} piece @param {number[]} at its numbers now @param {number} letters how large they are */
function moveTo(piece, at, letters) {
  if (piece.at.length && at.every((value, k) => value === piece.at[k])) return;
  piece.at = at;
  const { element, grasp, head, row } = piece;
  const place = placeOf(row, at, letters);
  setAttributes(element, place);
  if (grasp) setAttributes(grasp, place);
  head?.setAttribute("d", headPath(at, letters));
}

/** A mark's attributes where it is. @param {Row} row @param {number[]} at @param {number} letters
 * @returns {Record<string, string>} */
function placeOf(row, at, letters) {
  const [a, b, c, d, e] = at.map(coordinate);
  switch (row.kind) {
    case "vector":
    case "segment":
      return { x1: a, y1: b, x2: c, y2: d };
    case "body":
      return { transform: turned(at, row.base ?? [0, 0, 1, 0]) };
    case "arc":
      return { d: `M${a} ${b}A${e} ${e} 0 ${row.flags} ${c} ${d}` };
    case "circle":
      return { cx: a, cy: b, r: c };
    case "point":
      return { cx: a, cy: b };
    case "text":
      return { transform: `translate(${a} ${b}) scale(${letters})` };
    default:
      return { d: cornersPath(at) + (row.closed ? "Z" : "") };
  }
}

/** @param {number[]} at */
function cornersPath(at) {
  return at.map((number, k) => `${k % 2 ? " " : k ? "L" : "M"}${coordinate(number)}`).join("");
}

/** The turn and the shift that bring one line to where it is now. @param {number[]} at its ends now
 * @param {[number, number, number, number]} base its ends as the form was drawn */
function turned([ax = 0, ay = 0, bx = 0, by = 0], [cx, cy, dx, dy]) {
  const [ox, oy, nx, ny] = [dx - cx, dy - cy, bx - ax, by - ay];
  const square = ox * ox + oy * oy;
  const cos = (nx * ox + ny * oy) / square;
  const sin = (ny * ox - nx * oy) / square;
  const numbers = [cos, sin, -sin, cos, ax - cos * cx + sin * cy, ay - sin * cx - cos * cy];
  return `matrix(${numbers.map((number) => number.toFixed(6)).join(" ")})`;
}

/** The head of an arrow, its tip at the arrow's end. @param {number[]} ends @param {number} letters how large they are */
function headPath([x1, y1, x2, y2], letters) {
  const length = Math.hypot(x2 - x1, y2 - y1);
  if (length < 0.05) return "";
  const size = TIP * letters * (length > 1.6 * TIP * letters ? 1 : 0.5);
  const [ex, ey] = [(x2 - x1) / length, (y2 - y1) / length];
  const [fx, fy] = [x2 - size * ex, y2 - size * ey];
  const half = (0.5 * size) / TIP;
  return `${cornersPath([x2, y2, fx - half * ey, fy + half * ex, fx + half * ey, fy - half * ex])}Z`;
}
