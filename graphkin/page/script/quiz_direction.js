/** A line or an arrow over a drawing that the student turns about its point. */
import { setAttributes, takeEvent } from "./dom.js";
import { directionOf, modulo } from "./numbers.js";
import { dragged, svg } from "./svg.js";

const QUIZ_REACH = 70; // of a line to both sides [mm]
const QUIZ_ARROW = 30; // the length of an arrow [mm]
const QUIZ_HANDLE = 22; // the distance of the handle from the point [mm]
/** @type {Record<string, number>} the degrees that a key turns it */
const QUIZ_KEYS = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

export class TurnedDirection {
  /** @param {import("./quiz.js").Question} question @param {SVGSVGElement} drawing
   * @param {{x: number, y: number}} at the place of its point
   * @param {HTMLInputElement} field shows the angle, and takes it @param {string} label for a screen reader */
  constructor(question, drawing, at, field, label) {
    this.at = at;
    this.field = field;
    this.turn = question.kind === "line" ? 180 : 360;
    this.lines = [svg("line", { class: "quiz-wide" }), svg("line", { class: "quiz-line" })];
    this.head = svg("path", { class: "quiz-head", d: this.turn === 180 ? "" : `M${QUIZ_ARROW} 0l-4 1.2v-2.4Z` });
    this.handle = svg("circle", {
      class: "quiz-handle", r: 3, tabindex: 0, role: "slider", "aria-label": label, "aria-valuemin": 0, "aria-valuemax": this.turn,
    });
    this.group = svg("g", { class: "quiz-direction", "data-quiz-direction": question.kind }, ...this.lines, this.head, this.handle);
    this.listen();
    this.show(Math.abs(((question.right + 20) % 90) - 20) < 10 ? 45 : 0);
    drawing.append(this.group);
  }

  listen() {
    const { group, handle, field } = this;
    dragged(group, handle, true, ({ x, y }) => this.turnTo(directionOf(x - this.at.x, this.at.y - y)));
    handle.addEventListener("keydown", (event) => {
      const way = QUIZ_KEYS[event.key];
      if (!way) return;
      takeEvent(event);
      this.turnTo(Number(field.value) + way);
    });
    field.addEventListener("input", () => {
      const typed = field.value;
      if (typed && Number.isFinite(Number(typed))) this.show(Number(typed));
      field.value = typed;
    });
  }

  /** @param {number} angle */
  turnTo(angle) {
    const within = Math.round(modulo(angle, this.turn) * 10) / 10;
    this.show(within >= this.turn ? 0 : within);
    this.field.form?.dispatchEvent(new Event("input"));
  }

  /** @param {number} angle [deg] */
  show(angle) {
    const { at, turn } = this;
    const along = { x: Math.cos((angle * Math.PI) / 180), y: -Math.sin((angle * Math.PI) / 180) };
    const [from, to] = turn === 180 ? [-QUIZ_REACH, QUIZ_REACH] : [0, QUIZ_ARROW];
    const ends = { x1: at.x + from * along.x, y1: at.y + from * along.y, x2: at.x + to * along.x, y2: at.y + to * along.y };
    for (const line of this.lines) setAttributes(line, ends);
    const grip = { cx: at.x + QUIZ_HANDLE * along.x, cy: at.y + QUIZ_HANDLE * along.y };
    setAttributes(this.handle, { ...grip, "aria-valuenow": angle, "aria-valuetext": `${angle}°` });
    this.head.setAttribute("transform", `translate(${at.x} ${at.y}) rotate(${-angle})`);
    this.field.value = String(angle);
  }

  remove() {
    this.group.remove();
  }
}
