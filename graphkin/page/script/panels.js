/** What is told beside the figures: the construction step by step, in the sentences of the solution, whose terms and the
 * figures' arrows light up together; results; the arrow that is pointed at. */
import { html, partOf } from "./dom.js";
import { directionOf, modulo } from "./numbers.js";
import { measured, printed, signNodes } from "./signs.js";
import { language, say } from "./words.js";

/** @import { Shown, Template } from "./state.js" */

const FIRST = 0xe100;
const NOISE = 4; // smaller numbers are none [of the least that a track tells apart]

/** The panel of steps. */
export class StepsPanel {
  /** @param {Shown} shown @param {HTMLElement} element */
  constructor(shown, element) {
    this.shown = shown;
    this.numbers = shown.mechanism.steps.map(({ step }) => step);
    this.count = Math.max(0, ...this.numbers);
    /** @type {HTMLElement} */
    this.number = partOf(element, ".step-number");
    /** @type {HTMLElement} */
    this.text = partOf(element, ".step-text");
  }

  /** The step after the one shown; the last is followed by itself. */
  after() {
    return this.numbers.find((number) => number > this.shown.step) ?? this.count;
  }

  before() {
    return this.numbers.filter((number) => number < (this.shown.step || this.count + 1)).pop() ?? 0;
  }

  /** The sentences of the step shown, with the numbers of the place where the drivers are. */
  show() {
    const { step, mechanism } = this.shown;
    this.number.textContent = step ? say("page.step", { step, count: this.count }) : "";
    const own = mechanism.steps.find((each) => each.step === step);
    const held = document.activeElement?.closest(".step-text") ? document.activeElement.getAttribute("data-vector") : null;
    this.text.replaceChildren(...(own ? this.entries(own[language()]) : [html("p", { class: "hint" }, say("page.all steps"))]));
    if (held) /** @type {HTMLElement | null} */ (this.text.querySelector(`[data-vector="${CSS.escape(held)}"]`))?.focus();
  }

  /** @param {Template[][]} entries */
  entries(entries) {
    const chosen = entries.map((templates) => this.chosen(templates)).filter((template) => template !== null);
    const values = chosen.map((template) => this.values(template));
    const isWhole = values.flat().every(Number.isFinite);
    return [...chosen.map((template, k) => entryElement(template, values[k])),
      ...(isWhole ? [] : [html("p", { class: "hint" }, say("page.not told"))])];
  }

  /** What is said here: the template of the nearest knot; another one where a number of that has passed 0 since, or
   * where it is said at that knot alone, of those in a row. @param {Template[]} templates */
  chosen(templates) {
    const { words } = this.shown;
    const near = templates.find((template) => words.isNear(template.mask));
    if (!near) return null;
    const numbers = this.values(near);
    const track = (/** @type {number} */ number) => words.track(number)[words.nearest] ?? 0;
    const passed = (near.numbers ?? []).some((number, k) => !near.sizes?.includes(k) && track(number) * (numbers[k] ?? 0) < 0);
    const alone = near.mask !== undefined && words.axes.length === 1 && words.isAlone(near.mask);
    if (!passed && !alone) return near;
    return templates.find((one) => one !== near && words.isBeside(one.mask)) ?? near;
  }

  /** @param {Template} template */
  values(template) {
    const { words } = this.shown;
    return (template.numbers ?? []).map((number, k) => {
      const turn = template.turns?.includes(k) ? 360 : 0;
      const signed = words.sure([number], template.mask, turn);
      const size = template.sizes?.includes(k) ? Math.abs(signed) : signed;
      const value = turn ? modulo(size, turn) : size;
      return Math.abs(value) < NOISE * words.packed[number][0] ? 0 : value;
    });
  }
}

/** @param {Template} template @param {number[]} numbers */
function entryElement(template, numbers) {
  const filled = (/** @type {string} */ text) =>
    text.replace(/[\ue100-\uf8ff]/g, (letter) => printed(numbers[letter.charCodeAt(0) - FIRST] ?? NaN));
  const lines = template.words.map((line) => signNodes(line, filled));
  if (template.kind === "heading") return html("h3", {}, ...lines[0]);
  if (template.kind === "equation") {
    const wide = lines.length / 3;
    const cells = lines.map((cell) => html("td", {}, ...cell));
    const rows = [0, 1, 2].map((row) => html("tr", {}, ...cells.slice(row * wide, (row + 1) * wide)));
    return html("div", { class: "equation" }, html("table", {}, html("tbody", {}, ...rows)));
  }
  const isStep = template.kind === "step";
  return html("p", { class: isStep ? "step-sentence" : template.kind, "data-step-sentence": isStep }, ...lines[0]);
}

const UNITS = { velocity: "m/s", acceleration: "m/s²" };

/** The results where the drivers are. @param {Shown} shown @param {NodeListOf<HTMLElement>} cells */
export function showResults({ mechanism: { values }, tracks }, cells) {
  values.forEach((value, k) => {
    const text = measured(tracks.isNear(value.mask) ? quantityAt(value, tracks) : NaN, value.unit);
    if (cells[k].textContent !== text) cells[k].textContent = text;
  });
}

/** A quantity where the tracks are, NaN where it is not sure; an angle that turns on and on rises each time the driver comes round.
 * @param {import("./state.js").ValueData} value @param {import("./tracks.js").Tracks} tracks */
export function quantityAt(value, tracks) {
  const [axis] = tracks.axes;
  const turns = axis?.period ? (tracks.us[0] - axis.u[0]) / axis.period : 0;
  const number = tracks.sure(value.value, value.mask, value.turn) + (value.rise ?? 0) * turns;
  return value.size ? Math.abs(number) : number;
}

/** An arrow's size and direction, as words are filled with. @param {SVGLineElement} line @param {number} scale */
export function arrowSize(line, scale) {
  const [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map((name) => Number(line.getAttribute(name)));
  const [x, y] = [x2 - x1, y1 - y2];
  const length = Math.hypot(x, y);
  const plane = line.getAttribute("data-plane") === "velocity" ? "velocity" : "acceleration";
  return { size: printed(length * scale), unit: UNITS[plane], angle: directionOf(x, y).toFixed(1), none: length < 0.02 };
}

