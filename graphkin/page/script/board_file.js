/** The file of a board: the drawing as drawing files are, with answers, equations and the order of steps in it. */
import { decimals, drawnSteps } from "./board_drawing.js";
import { BOARD, paperOf, takeUp, work } from "./board_state.js";
import { letterAt, shapeOf, spotOf, stepsOf } from "./board_steps.js";
import { saveFile } from "./dom.js";
import { LETTER_FONT, svg } from "./svg.js";
import { language, say } from "./words.js";

/** @import { Step } from "./board_state.js" */

const FILE_MARGIN = 12;
const HEADING = 8;
const OVER = 6; // so far lines go beyond what they cross [mm]

/** The record that stands in the file's metadata. */
export function boardRecord() {
  return {
    kind: "graphkin board", format: 1, lang: language(), problem: { ...BOARD.problem, student: work.student },
    scales: work.scales, equations: work.equations, answers: work.answers,
    steps: work.steps.map((step, k) => ({ step: k + 1, ...step, through: throughOf(step) })),
  };
}

/** The letter of the point that a line without ends goes through. @param {Step} step */
function throughOf({ plane, tool, at, point }) {
  const place = tool === "protractor" ? at[0] : point;
  return place ? letterAt(plane, spotOf(place)) || null : null;
}

/** The whole file. The figure stands at its own place, the polygons under it; no transform is on anything.
 * @param {SVGSVGElement | null} figure @returns {string} */
export function boardFile(figure) {
  const parts = /** @type {Node[]} */ ([]);
  const room = { left: 0, top: 0, right: 120, bottom: 0 };
  if (figure) {
    const { width, height } = figure.viewBox.baseVal;
    for (const child of figure.children) if (child.tagName !== "title") parts.push(child.cloneNode(true));
    Object.assign(room, { right: Math.max(room.right, width), bottom: height });
  }
  const corner = BOARD.given.corner;
  for (const { plane } of BOARD.papers) {
    const over = plane === "position" && corner !== null;
    const box = drawnBox(plane);
    const under = { x: FILE_MARGIN - box.left, y: room.bottom + FILE_MARGIN + HEADING + box.high };
    const pole = over ? { x: corner[0], y: corner[1] } : under;
    parts.push(svg("g", {}, ...drawnSteps(plane, { pole, pixel: 0.2, letters: 4.2, box })));
    const heading = { x: FILE_MARGIN, y: room.bottom + FILE_MARGIN, "font-size": 4.2 };
    if (!over) parts.push(svg("text", heading, headingOf(plane)));
    Object.assign(room, {
      left: Math.min(room.left, pole.x + box.left), right: Math.max(room.right, pole.x + box.right + FILE_MARGIN),
      top: Math.min(room.top, pole.y - box.high), bottom: Math.max(room.bottom, pole.y - box.low + FILE_MARGIN),
    });
  }
  const [left, top, wide, high] = [room.left, room.top, room.right - room.left, room.bottom - room.top].map(decimals);
  const record = svg("metadata", { id: "graphkin-board" }, JSON.stringify(boardRecord()));
  const root = svg("svg", {
    width: `${wide}mm`, height: `${high}mm`, viewBox: `${left} ${top} ${wide} ${high}`, "stroke-linecap": "round",
    "font-family": LETTER_FONT, "xml:lang": language(),
  }, svg("title", {}, document.title), record, ...parts);
  return `<?xml version="1.0" encoding="utf-8"?>\n${new XMLSerializer().serializeToString(root)}\n`;
}

/** @param {string} plane */
function headingOf(plane) {
  const scale = work.scales[plane];
  return scale ? `${say(plane)}, 1 mm = ${scale} ${paperOf(plane).unit}` : say(plane);
}

/** The room that is drawn on, about the pole, as far as lines without an end are drawn. @param {string} plane */
function drawnBox(plane) {
  const [xs, ys] = [[-10, 10], [-10, 10]];
  for (const step of stepsOf(plane)) {
    const shape = shapeOf(step);
    const places = step.point ? [spotOf(step.point)] : step.at.map(spotOf);
    const reach = shape?.kind === "circle" ? shape.radius : 0;
    for (const { x, y } of step.tool === "protractor" || reach ? [places[0]] : places) {
      xs.push(x - reach, x + reach);
      ys.push(y - reach, y + reach);
    }
  }
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return { left: left - OVER, right: right + OVER, low: low - OVER, high: high + OVER };
}

/** The name of the file: who hands it in, else the problem's; what no disk takes is left out. @param {string} end */
export function boardFileName(end) {
  const name = (work.student || BOARD.name).replace(/[\\/:*?"<>|\p{Cc}]/gu, "").trim().replace(/^\.+/, "");
  return `${name || "board"}${end}`;
}

/** @param {string} end what stands behind the name @param {SVGSVGElement | null} figure */
export function saveBoard(end, figure) {
  const name = boardFileName(end);
  saveFile(name, boardFile(figure), "image/svg+xml");
  return name;
}

/** Work from a file of a board. Gives the key of what is said of it. @param {string} text */
export function openBoard(text) {
  try {
    const held = new DOMParser().parseFromString(text, "text/html").getElementById("graphkin-board");
    const record = JSON.parse(held?.textContent ?? "");
    if (record.kind !== "graphkin board") return "no board";
    if (record.problem.mechanism !== BOARD.problem.mechanism) return "other problem";
    const steps = record.steps.filter(isStep).map((/** @type {Step} */ step) => {
      const { plane, tool, at, name, line, point, direction, length, angle } = step;
      return { plane, tool, at, name, line, point, direction, length, angle };
    });
    takeUp({ ...record, student: String(record.problem.student ?? ""), steps });
    return "opened";
  } catch {
    return "no board";
  }
}

/** @param {any} step */
function isStep(step) {
  const isPlace = (/** @type {any} */ place) =>
    Array.isArray(place) && place.length === 2 && place.every(Number.isFinite);
  return BOARD.papers.some(({ plane }) => plane === step?.plane) && Array.isArray(step.at) && step.at.every(isPlace)
    && step.at.length === (step.tool === "point" ? 1 : 2);
}
