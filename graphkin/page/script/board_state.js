/** The state of a student's work: what is drawn, in its order, and what is filled in; kept in the browser. */
import { byId, heldData } from "./dom.js";

/** @import { Sign } from "./signs.js" */
/** @typedef {{kind: string, line?: string, angle?: number}} StepDirection */
/** One act of the pencil. `at` are places [mm from the pole, y up]; `point` is where a set square lay.
 * @typedef {{plane: string, tool: string, at: [number, number][], name?: string, line?: string, point?: [number,
 * number], direction?: StepDirection | null, length?: number, angle?: number}} Step */
/** @typedef {{term: string, direction: string, magnitude: string}} FilledTerm */
/** @typedef {{plane: string, equation: number, terms: FilledTerm[]}} FilledEquation */
/** @typedef {{value: string, unit: string, sense: string}} Answer */
/** @typedef {{student: string, scales: Record<string, number | null>, answers: Record<string, Answer>,
 * equations: FilledEquation[], steps: Step[]}} Work */
/** A line of the mechanism; where it lies on its paper, of one that is given there; and whether it is drawn there.
 * @typedef {{name: string, angle: number | null, at: [[number, number], [number, number]] | null,
 * drawn: boolean}} GivenLine */
/** What a set square is laid to; where the figure's corner and its points are on its paper [mm].
 * @typedef {{lines: GivenLine[], pairs: string[], points: Record<string, [number, number]>, corner: [number,
 * number] | null}} GivenMechanism */
/** A paper: `given` of the mechanism's own, whose scale is that of the figure. `near`: how much nearer it is seen at
 * first than from where all of it is seen; `points`: letters that are offered; `of`: what these belong to; `vectors`:
 * names that are offered.
 * @typedef {{plane: string, pole: string, unit: string, scale: number | null, box: import("./board_geometry.js").Box,
 * near: number, points: string[], of: Record<string, string>, vectors: string[]}} GivenPaper */
/** What the page holds.
 * @typedef {{key: string, name: string, title: {en: string, zh: string}, problem: Record<string, unknown>,
 * papers: GivenPaper[], given: GivenMechanism, empty: Work, letters: Record<string, Sign[]>}} HeldBoard */

/** @type {HeldBoard} */
export const BOARD = heldData("board");

/** The signs of a name; the student's own stands as it is. @param {string} name @returns {Sign[]} */
export function lettersOf(name) {
  return BOARD.letters[name] ?? [[name.replaceAll("'", "′"), 1]];
}

/** @param {string} plane @returns {GivenPaper} */
export function paperOf(plane) {
  const paper = BOARD.papers.find((each) => each.plane === plane);
  if (!paper) throw new Error(`no paper ${plane}`);
  return paper;
}

/** @type {Work} */
export let work = structuredClone(BOARD.empty);
/** @type {Step[][]} */
let pastSteps = [];
/** @type {(() => void)[]} */
const workWatchers = [];
export const WORK_PLACE = `graphkin board ${BOARD.key}`;

/** Do something whenever what is drawn has changed, or all of it. @param {() => void} act */
export function onWork(act) {
  workWatchers.push(act);
}

/** What cannot be drawn, as of a file that is not whole, is not kept either: the page would not open with it again.
 * @param {Work} next @param {Step[][]} past what was drawn before, one after another */
function changeWork(next, past) {
  const before = work;
  work = next;
  try {
    for (const act of workWatchers) act();
  } catch (fault) {
    work = before;
    for (const act of workWatchers) act();
    throw fault;
  }
  pastSteps = past;
  keepWork();
}

/** Remember the work for the next time this page is opened. Where a browser forbids it, or has no room, it is said. */
export function keepWork() {
  const warning = byId("not-kept");
  try {
    localStorage.setItem(WORK_PLACE, JSON.stringify(work));
    warning.hidden = true;
  } catch {
    warning.hidden = false;
  }
}

/** Take up the work where it was left. */
export function recallWork() {
  try {
    const text = localStorage.getItem(WORK_PLACE);
    if (text) takeUp(JSON.parse(text));
  } catch {
    // nothing was kept
  }
}

/** Other work instead of this; what is missing in it, or is something else, is empty. @param {Partial<Work>} other */
export function takeUp(other) {
  changeWork({ ...inForm(BOARD.empty, other), steps: other.steps ?? [] }, []);
}

/** What has the form of something empty: its texts, its positive numbers; of lists what is there, by its names.
 * @param {any} empty @param {any} other @returns {any} */
function inForm(empty, other) {
  if (Array.isArray(empty)) {
    const names = (/** @type {any} */ one) => JSON.stringify([one?.plane, one?.equation, one?.term]);
    const there = Array.isArray(other) ? other : [];
    return empty.map((one) => inForm(one, there.find((each) => names(each) === names(one))));
  }
  if (empty === null || typeof empty === "number") return Number.isFinite(other) && other > 0 ? other : empty;
  if (typeof empty !== "object") return typeof other === typeof empty ? other : empty;
  return Object.fromEntries(Object.entries(empty).map(([key, value]) => [key, inForm(value, other?.[key])]));
}

/** Change what is drawn, so that it can be undone. @param {Step[]} steps */
export function redraw(steps) {
  changeWork({ ...work, steps }, [...pastSteps, structuredClone(work.steps)]);
}

/** Take back the last change of the drawing; false if there is none. */
export function undoStep() {
  const steps = pastSteps.pop();
  if (steps) changeWork({ ...work, steps }, pastSteps);
  return Boolean(steps);
}
