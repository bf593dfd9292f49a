/** The hand on the papers: what a press with the tool of the moment draws, measures, letters or erases. */
import { litReading, litStep } from "./board_drawing.js";
import { apart } from "./board_geometry.js";
import { BoardPaper } from "./board_paper.js";
import { BOARD, redraw, undoStep, work } from "./board_state.js";
import {
  letterAt, lineWords, nextPlace, placeWords, snapped, stepNear, stepsWithout, stepWords,
} from "./board_steps.js";
import {
  allLines, isFreeName, lettered, lineAt, lineThrough, needsOnePlace, reading, stepOf, TOOL_FIELDS,
} from "./board_tools.js";
import { byId } from "./dom.js";
import { numberIn, within } from "./numbers.js";
import { placeOn, svg } from "./svg.js";
import { say } from "./words.js";

/** @import { Spot } from "./board_geometry.js" */
/** @import { Snap } from "./board_steps.js" */
/** @import { Step } from "./board_state.js" */

/** Where a hand points: exactly, and where the pencil is set. @typedef {{at: Spot, snap: Snap}} Pointed */

const MOUSE_REACH = 9;
const FINGER_REACH = 16; // [px]
const DRAGGED = 6; // so far a press and its release are apart [px]

/** The tool in the hand. */
export let tool = "line";
/** The first of two places. @type {{paper: BoardPaper, spot: Spot} | null} */
let pending = null;
/** Fingers and mice that are down. @type {Map<number, Spot>} */
const pointers = new Map();
/** @type {Pointed | null} */
let pressed = null;
let pressedAt = { x: 0, y: 0 };
let reachPixels = MOUSE_REACH;
/** What was drawn without a name, and may be given one. @type {Step | null} */
let unnamed = null;

/** @param {string} name @returns {HTMLInputElement | HTMLSelectElement} */
export function toolField(name) {
  return /** @type {HTMLInputElement | HTMLSelectElement} */ (byId(`field-${name}`));
}

function toolFields() {
  const line = allLines().find(({ name }) => name === toolField("line").value) ?? null;
  const [length, angle] = ["length", "angle"].map((name) => numberIn(toolField(name).value));
  return { line, kind: toolField("kind").value, length, angle };
}

/** @param {string} key @param {Record<string, string | number>} [values] */
export function tell(key, values = {}) {
  byId("said").textContent = say(key, values);
}

/** @param {string} name */
export function setTool(name) {
  tool = name;
  forget();
  for (const button of document.querySelectorAll("[data-tool]")) {
    button.setAttribute("aria-pressed", String(button.getAttribute("data-tool") === name));
  }
  showFields();
  for (const paper of papers) paper.element.classList.toggle("pans", name === "pan");
  if (name === "parallel" || name === "perpendicular") toolField("line").value = "";
  tell(`hint ${name}`);
}

/** The fields that the tool has; an arrow's, by what tells its direction. */
export function showFields() {
  const kind = toolField("kind").value;
  const shown = (TOOL_FIELDS[tool] ?? []).filter((field) => tool !== "vector"
    || (field !== "line" && field !== "angle") || (field === "angle") === (kind === "angle") && kind !== "");
  for (const field of ["kind", "line", "length", "angle", "name"]) byId(`for-${field}`).hidden = !shown.includes(field);
  byId("offers").hidden = !shown.includes("name");
  byId("offers").dataset.offered = tool;
}

/** True while a line is to be chosen. */
function lacksLine() {
  const { kind, line } = toolFields();
  const squared = tool === "vector" ? kind : tool;
  return (squared === "parallel" || squared === "perpendicular") && !line;
}

function forget() {
  pending = null;
  for (const paper of papers) paper.aids.replaceChildren();
}

/** Where a press is, was, or would be: what is seen there, as the pencil is set. @param {BoardPaper} paper
 * @param {Spot} at @returns {Pointed} */
function pointed(paper, at) {
  const { left, right, low, high } = paper.box;
  const kept = { x: within(at.x, left, right), y: within(at.y, low, high) };
  return { at: kept, snap: snapped(paper.plane, kept, reachOn(paper)) };
}

/** @param {BoardPaper} paper @param {{clientX: number, clientY: number}} event */
function pointedBy(paper, event) {
  const { x, y } = placeOn(paper.element, event);
  return pointed(paper, { x, y: -y });
}

/** How near the hand must come to something [mm]. @param {BoardPaper} paper */
function reachOn(paper) {
  return reachPixels * paper.pixel;
}

/** One finger draws; two, or the hand as a tool, move the paper. @param {BoardPaper} paper */
function listenToPointers(paper) {
  const { element } = paper;
  const isDragged = (/** @type {PointerEvent} */ event) => apart(placeOfEvent(event), pressedAt) > DRAGGED;
  element.addEventListener("pointerdown", (event) => {
    if (event.button > 1) return;
    element.setPointerCapture(event.pointerId);
    reachPixels = event.pointerType === "touch" ? FINGER_REACH : MOUSE_REACH;
    pressedAt = placeOfEvent(event);
    pointers.set(event.pointerId, pressedAt);
    pressed = pointers.size > 1 || event.button === 1 || tool === "pan" ? null : pointedBy(paper, event);
    if (pressed) hover(paper, null, pressed);
  });
  element.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before || pressed) return hover(paper, isDragged(event) ? pressed : null, pointedBy(paper, event));
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    const after = placeOfEvent(event);
    const pixel = paper.pixel / pointers.size;
    if (other) {
      const middle = { clientX: (after.x + other.x) / 2, clientY: (after.y + other.y) / 2 };
      paper.zoom((apart(after, other) || 1) / (apart(before, other) || 1), placeOn(element, middle));
    }
    paper.pan((after.x - before.x) * pixel, (after.y - before.y) * pixel);
    pointers.set(event.pointerId, after);
    return undefined;
  });
  element.addEventListener("pointerup", (event) => {
    const from = pressed;
    letGo(event);
    if (!from) return;
    const to = pointedBy(paper, event);
    paper.cursor = to.snap.spot;
    finish(paper, from, to, isDragged(event));
  });
  element.addEventListener("pointercancel", letGo);
  element.addEventListener("pointerleave", () => !pressed && paper.aids.replaceChildren());
}

/** On the screen [px]. @param {PointerEvent} event @returns {Spot} */
function placeOfEvent({ clientX, clientY }) {
  return { x: clientX, y: clientY };
}

/** @param {PointerEvent} event */
function letGo(event) {
  pointers.delete(event.pointerId);
  pressed = null;
}

/** @param {BoardPaper} paper @param {KeyboardEvent} event */
function keyOn(paper, event) {
  const step = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
  const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
  const next = { n: 1, N: -1 }[event.key];
  if (by) moveCursor(paper, { x: paper.cursor.x + by[0] * step, y: paper.cursor.y + by[1] * step });
  else if (next) moveCursor(paper, nextPlace(paper.plane, paper.cursor, next));
  else if (event.key === "Enter" || event.key === " ") {
    const here = pointed(paper, paper.cursor);
    finish(paper, here, here, false);
  } else if (event.key === "Escape") {
    forget();
    tell(`hint ${tool}`);
  } else if (event.key === "+" || event.key === "-") paper.zoom(event.key === "+" ? 1.5 : 1 / 1.5);
  else return;
  event.preventDefault();
}

/** @param {BoardPaper} paper @param {Spot} to */
function moveCursor(paper, to) {
  reachPixels = 2;
  const there = pointed(paper, to);
  paper.cursor = there.at;
  const [x, y, view] = [there.at.x, -there.at.y, paper.view];
  if (x < view.x || y < view.y || x > view.x + view.wide || y > view.y + view.high) {
    paper.pan(view.x + view.wide / 2 - x, view.y + view.high / 2 - y);
  }
  hover(paper, null, there);
  paper.aids.append(svg("path", { class: "cursor", d: `M${x - 3} ${y}h6M${x} ${y - 3}v6` }));
  tell("cursor", { place: placeWords(paper.plane, there.snap.spot), kind: say(`place ${there.snap.kind}`) });
}

/** @param {BoardPaper} paper @param {Pointed | null} from @param {Pointed} to */
function hover(paper, from, to) {
  const start = from ? from.snap.spot : pending?.paper === paper ? pending.spot : null;
  paper.aids.replaceChildren(...preview(paper, start, to));
}

/** @param {BoardPaper} paper @param {Pointed} from @param {Pointed} to @param {boolean} dragged */
function finish(paper, from, to, dragged) {
  for (const other of papers) other.aids.replaceChildren();
  if (tool === "erase") erase(stepNear(paper.plane, to.at, reachOn(paper)));
  else if (tool === "letter") letterAtPlace(paper, to.at);
  else if (lacksLine()) pickLine(paper, from, to, dragged);
  else if (dragged && !needsOnePlace(tool, toolFields())) complete(paper, from.snap.spot, to.snap.spot);
  else if (needsOnePlace(tool, toolFields())) complete(paper, to.snap.spot, to.snap.spot);
  else if (pending?.paper === paper) complete(paper, pending.spot, to.snap.spot);
  else {
    pending = { paper, spot: to.snap.spot };
    hover(paper, null, to);
    tell("second place", { place: placeWords(paper.plane, pending.spot) });
  }
}

/** @param {{angle: number | null}} fields */
function readsOnly({ angle }) {
  return tool === "measure" || (tool === "protractor" && angle === null);
}

/** @param {BoardPaper} paper @param {Spot} from @param {Spot} to @returns {SVGElement[]} */
function readOff(paper, from, to) {
  const { length, angle, size, unit } = reading(paper.plane, from, to);
  return litReading(from, to, tool === "measure" ? `${length} mm${size ? ` ≙ ${size} ${unit}` : ""}` : `${angle}°`, paper.pen);
}

/** The pencil's place, and what would be drawn. @param {BoardPaper} paper @param {Spot | null} start
 * @param {Pointed} to @returns {SVGElement[]} */
function preview(paper, start, to) {
  if (tool === "pan") return [];
  if (tool === "erase" || tool === "letter") {
    const step = (tool === "erase" ? stepNear : lettered)(paper.plane, to.at, reachOn(paper));
    return step ? litStep(step, paper.pen) : [];
  }
  const spot = to.snap.spot;
  if (lacksLine()) {
    const line = to.snap.name ? null : lineAt(paper.plane, to.at, reachOn(paper));
    if (line) byId("said").textContent = lineWords(line.name);
  }
  const marks = [svg("circle", { class: `place ${to.snap.kind}`, cx: spot.x, cy: -spot.y, r: 5 * paper.pixel })];
  const fields = toolFields();
  if (!start && !needsOnePlace(tool, fields)) return marks;
  const from = start ?? spot;
  if (readsOnly(fields)) return [...marks, ...readOff(paper, from, spot)];
  const step = tool === "point" ? "" : stepOf(tool, paper.plane, from, spot, fields);
  return typeof step === "string" ? marks : [...marks, ...litStep(step, paper.pen)];
}

/** @param {BoardPaper} paper @param {Spot} from @param {Spot} to */
function complete(paper, from, to) {
  pending = null;
  const fields = toolFields();
  if (readsOnly(fields)) {
    const read = reading(paper.plane, from, to);
    paper.aids.replaceChildren(...readOff(paper, from, to));
    return tell(read.size && tool === "measure" ? "read measure scaled" : `read ${tool}`, read);
  }
  const step = stepOf(tool, paper.plane, from, to, fields);
  if (typeof step === "string") {
    if (step === "second place") pending = { paper, spot: from };
    return tell(step, { place: placeWords(paper.plane, from) });
  }
  const name = TOOL_FIELDS[tool]?.includes("name") ? toolField("name").value.trim() : "";
  if (name && !isFreeName(step, name)) return tell("name taken", { name });
  if (name) step.name = name;
  toolField("name").value = "";
  redraw([...work.steps, step]);
  unnamed = !name && (tool === "vector" || tool === "point") ? step : null;
  if (tool === "vector") toolField("length").value = "";
  toolField("line").value = "";
  byId("said").textContent = `${stepWords(step)}. ${unnamed ? say("give name") : ""}`;
  if (unnamed && tool === "point") askName();
}

/** The field of names is ready to be typed in, but where that would bring a phone's keyboard up. */
function askName() {
  if (matchMedia("(pointer: fine)").matches) toolField("name").focus();
}

/** The line for the set square: one that is drawn there, or through two points. @param {BoardPaper} paper
 * @param {Pointed} from @param {Pointed} to @param {boolean} dragged */
function pickLine(paper, from, to, dragged) {
  const first = dragged ? from.snap.name : pending?.paper === paper ? letterAt(paper.plane, pending.spot) : "";
  const line = (first && to.snap.name ? lineThrough(paper.plane, first, to.snap.name) : null)
    ?? (to.snap.name ? null : lineAt(paper.plane, to.at, reachOn(paper)));
  pending = null;
  if (line) {
    takeLine(line.name);
  } else if (to.snap.name) {
    pending = { paper, spot: to.snap.spot };
    tell("second point", { point: to.snap.name });
  } else tell("choose line");
}

/** @param {string} name */
export function takeLine(name) {
  toolField("line").value = name;
  tell(tool === "vector" ? "hint vector" : "now point", { line: name });
}

/** @param {Step | null} step */
export function erase(step) {
  if (!step) return tell("nothing there");
  const words = stepWords(step);
  redraw(stepsWithout(step));
  tell("erased", { step: words });
}

/** @param {BoardPaper} paper @param {Spot} at */
function letterAtPlace(paper, at) {
  unnamed = lettered(paper.plane, at, reachOn(paper));
  const name = toolField("name").value.trim();
  if (!unnamed) tell("nothing to letter");
  else if (name) nameStep(name);
  else {
    tell("give name");
    askName();
  }
}

/** A name for what has none yet, or for the next. @param {string} name */
export function nameStep(name) {
  const step = unnamed && work.steps.includes(unnamed) ? unnamed : null;
  if (!step || !name) return;
  if (!isFreeName(step, name)) return tell("name taken", { name });
  const renamed = { ...step, name };
  unnamed = null;
  redraw(work.steps.map((each) => (each === step ? renamed : each)));
  toolField("name").value = "";
  byId("said").textContent = stepWords(renamed);
}

export function takeBack() {
  forget();
  tell(undoStep() ? "undone" : "nothing to undo");
}

export const papers = BOARD.papers.map(({ plane }) => {
  const paper = new BoardPaper(plane);
  byId(`paper-${plane}`).append(paper.element);
  listenToPointers(paper);
  paper.element.addEventListener("keydown", (event) => keyOn(paper, event));
  paper.element.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && !event.metaKey) return; // the page scrolls
    event.preventDefault();
    paper.zoom(Math.exp(-event.deltaY / 300), placeOn(paper.element, event));
  }, { passive: false });
  return paper;
});
