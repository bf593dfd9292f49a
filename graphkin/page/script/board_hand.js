/** The hand on the papers: what a press with the tool of the moment draws, measures, letters or erases. */
import { arrow, auxiliaryLine, lineEnds } from "./board_drawing.js";
import { BoardPaper } from "./board_paper.js";
import { BOARD, redraw, undoStep, work } from "./board_state.js";
import { letterAt, shapeOf, spotOf, stepNear, stepsWithout } from "./board_steps.js";
import {
  allLines, isFreeName, lettered, lineAt, lineThrough, needsOnePlace, reading, stepOf, TOOL_FIELDS,
} from "./board_tools.js";
import { lineWords, placeWords, stepWords } from "./board_words.js";
import { byId } from "./dom.js";
import { numberIn } from "./numbers.js";
import { svg } from "./svg.js";
import { say } from "./words.js";

/** @import { Spot } from "./board_geometry.js" */
/** @import { Pointed } from "./board_paper.js" */
/** @import { Step } from "./board_state.js" */

/** The tool in the hand. */
export let tool = "line";
/** The first of two places. @type {{paper: BoardPaper, spot: Spot} | null} */
let pending = null;
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

/** @type {import("./board_paper.js").HandActs} */
const acts = {
  pans: () => tool === "pan",
  hover(paper, from, to) {
    const start = from ? from.snap.spot : pending?.paper === paper ? pending.spot : null;
    paper.aids.replaceChildren(...preview(paper, start, to));
  },
  finish(paper, from, to, dragged) {
    for (const other of papers) other.aids.replaceChildren();
    if (tool === "erase") erase(stepNear(paper.plane, to.at, paper.reach));
    else if (tool === "letter") letterAtPlace(paper, to.at);
    else if (lacksLine()) pickLine(paper, from, to, dragged);
    else if (dragged && !needsOnePlace(tool, toolFields())) complete(paper, from.snap.spot, to.snap.spot);
    else if (needsOnePlace(tool, toolFields())) complete(paper, to.snap.spot, to.snap.spot);
    else if (pending?.paper === paper) complete(paper, pending.spot, to.snap.spot);
    else {
      pending = { paper, spot: to.snap.spot };
      paper.aids.replaceChildren(...preview(paper, null, to));
      tell("second place", { place: placeWords(paper.plane, pending.spot) });
    }
  },
  cancel() {
    forget();
    tell(`hint ${tool}`);
  },
  moved(paper, pointed) {
    acts.hover(paper, null, pointed);
    const { x, y } = pointed.at;
    paper.aids.append(svg("path", { class: "cursor", d: `M${x - 3} ${-y}h6M${x} ${-y - 3}v6` }));
    tell("cursor", { place: placeWords(paper.plane, pointed.snap.spot), kind: say(`place ${pointed.snap.kind}`) });
  },
};

/** @param {{angle: number | null}} fields */
function readsOnly({ angle }) {
  return tool === "measure" || (tool === "protractor" && angle === null);
}

/** The pencil's place, and what would be drawn. @param {BoardPaper} paper @param {Spot | null} start
 * @param {Pointed} to @returns {SVGElement[]} */
function preview(paper, start, to) {
  if (tool === "pan") return [];
  if (tool === "erase" || tool === "letter") {
    const step = (tool === "erase" ? stepNear : lettered)(paper.plane, to.at, paper.reach);
    return step ? lit(step, paper) : [];
  }
  const spot = to.snap.spot;
  if (lacksLine()) {
    const line = to.snap.name ? null : lineAt(paper.plane, to.at, paper.reach);
    if (line) byId("said").textContent = lineWords(line.name);
  }
  const marks = [svg("circle", { class: `place ${to.snap.kind}`, cx: spot.x, cy: -spot.y, r: 5 * paper.pixel })];
  const fields = toolFields();
  if (!start && !needsOnePlace(tool, fields)) return marks;
  const from = start ?? spot;
  if (readsOnly(fields)) return [...marks, ...readOff(paper, from, spot)];
  const step = tool === "point" ? "" : stepOf(tool, paper.plane, from, spot, fields);
  return typeof step === "string" ? marks : [...marks, ...lit(step, paper)];
}

/** @param {Step} step @param {BoardPaper} paper @returns {SVGElement[]} */
function lit(step, paper) {
  const shape = shapeOf(step);
  const { x, y } = spotOf(step.at[0]);
  if (!shape) return [svg("circle", { class: "lit", cx: x, cy: -y, r: 5 * paper.pixel })];
  const marks = step.tool === "vector" ? arrow(step, paper.pen) : [auxiliaryLine(step, paper.pen)];
  for (const mark of marks) mark.setAttribute("class", "lit");
  return marks;
}

/** @param {BoardPaper} paper @param {Spot} from @param {Spot} to @returns {SVGElement[]} */
function readOff(paper, from, to) {
  const { length, angle, size, unit } = reading(paper.plane, from, to);
  const words = tool === "measure" ? `${length} mm${size ? ` ≙ ${size} ${unit}` : ""}` : `${angle}°`;
  const letters = svg("text", {
    class: "reading", x: to.x + 10 * paper.pixel, y: -to.y - 10 * paper.pixel, "font-size": 14 * paper.pixel,
  }, words);
  return [svg("line", { class: "lit", ...lineEnds(paper.pen, from, to), "stroke-width": paper.pixel }), letters];
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
    ?? (to.snap.name ? null : lineAt(paper.plane, to.at, paper.reach));
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
  unnamed = lettered(paper.plane, at, paper.reach);
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
  const paper = new BoardPaper(plane, acts);
  byId(`paper-${plane}`).append(paper.element);
  return paper;
});
