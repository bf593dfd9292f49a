/** Questions on the drawn position, one after another. Only answers are compared here: all of them come with the page. */
import { button, choice, html, setAttributes, takeEvent } from "./dom.js";
import { directionOf, modulo, numberIn } from "./numbers.js";
import { dragged, svg } from "./svg.js";
import { inEachLanguage, say, spoken, typeset } from "./words.js";

/** @import { Both } from "./words.js" */
/** `wrong`: what mistakes give, and their numbers; `turn`: a value begins anew after so much of its unit.
 * @typedef {{kind: "line" | "arrow" | "value", plane: string, act: number, name: string, right: number, wrong: [number,
 * number[]][], point?: string, from?: string, words?: Both, dimension?: string, unit?: string,
 * sense?: "turn" | "sign" | "", tolerance?: number, turn?: number}} Question */
/** `at`: the drivers' values [rad, m]; `tolerance`: of a direction [deg].
 * @typedef {{questions: Question[], mistakes: Both[], at: number[], tolerance: number, units: {name: string,
 * kind: string, times: number}[]}} Quiz */
/** @typedef {{verdict: "right" | "wrong" | "unread", words: string, off?: number, mistakes?: number[]}} Judged */

const QUIZ_NEAR = 0.005; // an answer is a mistake's that differs from it by so small a part, or by what paper allows
const QUIZ_REACH = 70; // of a line to both sides [mm]
const QUIZ_ARROW = 30; // the length of an arrow [mm]
const QUIZ_HANDLE = 22; // the distance of the handle from the point [mm]
/** @type {Record<string, number>} the degrees that a key turns it */
const QUIZ_KEYS = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

/** The quiz as a part of the page. */
export class QuizPart {
  /** @param {Quiz} quiz @param {import("./player.js").Player} player */
  constructor(quiz, player) {
    this.quiz = quiz;
    this.player = player;
    this.element = html("section", { class: "quiz", "data-quiz": "off" });
    this.number = -1; // of the question that is asked
    this.tries = 0;
    this.done = false;
    this.score = 0; // questions that were answered right at once
    /** @type {SVGElement | null} */
    this.direction = null;
    inEachLanguage(() => this.draw());
  }

  ask() {
    const question = this.quiz.questions[this.number];
    this.player.showUpTo(question.kind === "value" ? question.act : question.act - 1);
    this.player.drawing(question.plane).parentElement?.scrollIntoView({ block: "nearest", inline: "start" });
    this.tries = 0;
    this.done = false;
    this.draw();
    /** @type {HTMLElement | null} */ (this.element.querySelector("[data-quiz-question]"))?.focus({ preventScroll: true });
  }

  /** @param {HTMLElement} place @param {string} verdict @param {Node[]} [words] */
  tell(place, verdict, words = []) {
    place.dataset.quizVerdict = verdict;
    place.replaceChildren(...words);
  }

  draw() {
    this.direction?.remove();
    this.direction = null;
    const question = this.quiz.questions[this.number];
    this.element.dataset.quiz = question ? question.kind : "off";
    this.element.replaceChildren(html("h2", {}, say("quiz.title")), ...(question ? this.asked(question) : this.beginning()));
  }

  /** @returns {Node[]} */
  beginning() {
    const again = this.number >= this.quiz.questions.length;
    const score = { right: this.score, count: this.quiz.questions.length };
    const words = again ? say("quiz.score", score) : say("quiz.about");
    const start = button({ "data-action": "quiz" }, () => {
      this.number = this.score = 0;
      this.ask();
    }, say("quiz.start"));
    return [html("p", { "data-quiz-score": again }, words), start];
  }

  /** @param {Question} question @returns {Node[]} */
  asked(question) {
    const count = { number: this.number + 1, count: this.quiz.questions.length };
    const words = say(`quiz.${question.kind}`, { name: question.name, from: question.from ?? "" });
    const verdict = html("div", { class: "quiz-verdict", role: "status", "data-quiz-verdict": "" });
    const form = question.kind === "value" ? quizValueForm(this.quiz, question) : this.directionForm(question);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.judge(question, form, verdict);
    });
    form.addEventListener("input", () => {
      if (!this.done) this.tell(verdict, "");
    });
    return [
      html("p", { class: "quiz-count" }, say("quiz.count", count)),
      html("p", { "data-quiz-question": this.number, tabindex: -1 }, ...typeset(words)), form, verdict, this.buttons(question, verdict),
    ];
  }

  /** @param {Question} question */
  directionForm(question) {
    const angle = html("input", { type: "number", step: "any", value: "0", "data-quiz-angle": true });
    const label = typeset(say("quiz.handle", { name: question.name })).map((node) => node.textContent).join("");
    const drawing = this.player.drawing(question.plane);
    const point = drawing.querySelector(`circle.point[data-name="${CSS.escape(question.point ?? "")}"]`);
    if (point) {
      const at = { x: Number(point.getAttribute("cx")), y: Number(point.getAttribute("cy")) };
      this.direction = turnedDirection(question, at, angle, label);
      drawing.append(this.direction);
    }
    return html("form", {}, html("label", {}, say("quiz.angle"), " ", angle, " °"), " ", quizSubmit());
  }

  /** @param {Question} question @param {HTMLFormElement} form @param {HTMLElement} verdict */
  judge(question, form, verdict) {
    const judged = question.kind === "value" ? judgeValue(this.quiz, question, form) : judgeAngle(this.quiz, question, form);
    const words = say(`quiz.${judged.words}`, { name: question.name, off: judged.off ?? "" });
    this.tell(verdict, judged.verdict, typeset(words));
    (judged.mistakes ?? []).forEach((mistake, k) => {
      const or = k ? [html("em", {}, say("quiz.or")), " "] : [];
      const told = typeset(spoken(this.quiz.mistakes[mistake]));
      verdict.append(html("p", { "data-quiz-mistake": mistake }, ...or, ...told));
    });
    if (judged.verdict === "unread" || this.done) return;
    this.tries += 1;
    if (judged.verdict !== "right") return;
    this.score += this.tries === 1 ? 1 : 0;
    this.reveal(question, verdict);
  }

  /** The answer in words, and the act that it belongs to. @param {Question} question @param {HTMLElement} verdict */
  reveal(question, verdict) {
    this.done = true;
    const answer = question.words ? spoken(question.words) : quizValueInWords(question);
    verdict.append(html("p", { "data-quiz-answer": true }, ...typeset(answer)));
    this.player.showUpTo(question.act);
  }

  /** @param {Question} question @param {HTMLElement} verdict */
  buttons(question, verdict) {
    const show = button({ "data-action": "show-answer" }, () => {
      this.tell(verdict, "shown");
      this.tries += 1;
      this.reveal(question, verdict);
    }, say("quiz.show"));
    const next = button({ "data-action": "next-question" }, () => {
      this.number += 1;
      if (this.number < this.quiz.questions.length) this.ask();
      else this.leave(this.number);
    }, say("quiz.next"));
    const leave = button({ "data-action": "leave-quiz" }, () => this.leave(-1), say("quiz.leave"));
    return html("p", { class: "quiz-buttons" }, show, " ", next, " ", leave);
  }

  /** @param {number} number */
  leave(number) {
    this.number = number;
    this.player.showUpTo(null);
    this.draw();
  }
}

/** @param {Quiz} quiz @param {Question} question */
function quizValueForm(quiz, question) {
  const number = html("input", { type: "text", inputmode: "decimal", autocomplete: "off", "data-quiz-number": true });
  const unit = choice({ "data-quiz-unit": true }, say("quiz.choose"), quiz.units.map(({ name }) => [name, name]));
  const ways = /** @type {[string, string][]} */ (["ccw", "cw"].map((way) => [way, say(`quiz.${way}`)]));
  const sense = choice({ "data-quiz-sense": true }, say("quiz.choose"), ways);
  const fields = { number, unit, ...(question.sense === "turn" ? { sense } : {}) };
  const labels = Object.entries(fields).flatMap(([word, field]) =>
    [html("label", {}, say(`quiz.${word}`), " ", field), " "]);
  return html("form", {}, ...labels, quizSubmit());
}

function quizSubmit() {
  return html("button", { type: "submit", "data-action": "check" }, say("quiz.check"));
}

/** `ω3 = 3.92 rad/s, clockwise` @param {Question} question @returns {string} */
function quizValueInWords(question) {
  const size = question.sense === "turn" ? Math.abs(question.right) : question.right;
  const unit = question.unit === "°" || !question.unit ? question.unit : ` ${question.unit}`;
  const sense = question.sense === "turn" ? `, ${say(question.right > 0 ? "quiz.ccw" : "quiz.cw")}` : "";
  const shown = `${Number(size.toPrecision(4))}`.replace("-", "−");
  return say("quiz.answer", { answer: `${question.name} = ${shown}${unit}${sense}` });
}

/** A line or an arrow over a drawing that the student turns about its point. @param {Question} question
 * @param {{x: number, y: number}} at the place of its point @param {HTMLInputElement} field shows the angle, and takes it
 * @param {string} label for a screen reader @returns {SVGElement} */
function turnedDirection(question, at, field, label) {
  const turn = question.kind === "line" ? 180 : 360;
  const lines = [svg("line", { class: "quiz-wide" }), svg("line", { class: "quiz-line" })];
  const head = svg("path", { class: "quiz-head", d: turn === 180 ? "" : `M${QUIZ_ARROW} 0l-4 1.2v-2.4Z` });
  const handle = svg("circle", {
    class: "quiz-handle", r: 3, tabindex: 0, role: "slider", "aria-label": label, "aria-valuemin": 0, "aria-valuemax": turn,
  });
  const show = (/** @type {number} */ angle) => {
    const along = { x: Math.cos((angle * Math.PI) / 180), y: -Math.sin((angle * Math.PI) / 180) };
    const [from, to] = turn === 180 ? [-QUIZ_REACH, QUIZ_REACH] : [0, QUIZ_ARROW];
    const ends = { x1: at.x + from * along.x, y1: at.y + from * along.y, x2: at.x + to * along.x, y2: at.y + to * along.y };
    for (const line of lines) setAttributes(line, ends);
    const grip = { cx: at.x + QUIZ_HANDLE * along.x, cy: at.y + QUIZ_HANDLE * along.y };
    setAttributes(handle, { ...grip, "aria-valuenow": angle, "aria-valuetext": `${angle}°` });
    head.setAttribute("transform", `translate(${at.x} ${at.y}) rotate(${-angle})`);
  };
  const turnTo = (/** @type {number} */ angle) => {
    const within = Math.round(modulo(angle, turn) * 10) / 10;
    field.value = String(within >= turn ? 0 : within);
    field.dispatchEvent(new Event("input", { bubbles: true }));
  };
  const group = svg("g", { class: "quiz-direction", "data-quiz-direction": question.kind }, ...lines, head, handle);
  dragged(group, handle, true, ({ x, y }) => turnTo(directionOf(x - at.x, at.y - y)));
  handle.addEventListener("keydown", (event) => {
    const way = QUIZ_KEYS[event.key];
    if (!way) return;
    takeEvent(event);
    turnTo(Number(field.value) + way);
  });
  field.addEventListener("input", () => {
    const typed = numberIn(field.value);
    if (typed !== null) show(typed);
  });
  field.value = String(Math.abs(((question.right + 20) % 90) - 20) < 10 ? 45 : 0); // not where the answer is
  show(Number(field.value));
  return group;
}

// --- answers beside the right one and those that mistakes give

/** @param {Quiz} quiz @param {Question} question @param {HTMLFormElement} form @returns {Judged} */
function judgeAngle(quiz, question, form) {
  const given = numberIn(quizField(form, "[data-quiz-angle]"));
  if (given === null) return { verdict: "unread", words: "not a number" };
  const off = (/** @type {number} */ value) => anglesApart(given, value, question.kind === "line" ? 180 : 360);
  const judged = judgedBy(off, question, quiz.tolerance, () => quiz.tolerance);
  if (judged.words !== "wrong") return judged;
  const close = off(question.right) <= 3 * quiz.tolerance;
  return { verdict: "wrong", words: close ? "close" : "wrong", off: Math.round(off(question.right) * 10) / 10 };
}

/** @param {Quiz} quiz @param {Question} question @param {HTMLFormElement} form @returns {Judged} */
function judgeValue(quiz, question, form) {
  const number = numberIn(quizField(form, "[data-quiz-number]"));
  if (number === null) return { verdict: "unread", words: "not a number" };
  const unit = quiz.units.find(({ name }) => name === quizField(form, "[data-quiz-unit]"));
  if (!unit && question.unit) return { verdict: "unread", words: "no unit" };
  if (unit && unit.kind !== question.dimension) return { verdict: "wrong", words: "other unit" };
  const sense = quizField(form, "[data-quiz-sense]");
  if (question.sense === "turn" && !sense) return { verdict: "unread", words: "no sense" };
  const signed = number * (unit?.times ?? 1);
  const size = question.sense === "" || sense ? Math.abs(signed) : signed;
  const given = sense === "cw" ? -size : size;
  const { right, tolerance = 0, turn = 0 } = question;
  const off = (/** @type {number} */ value) => (turn ? anglesApart(given, value, turn) : Math.abs(given - value));
  return judgedBy(off, question, tolerance, (value) =>
    Math.max(QUIZ_NEAR * Math.abs(value), right ? tolerance * Math.abs(value / right) : tolerance));
}

/** An answer that is off by so much of a value: right, that of the nearest mistakes if it is near enough, or wrong.
 * @param {(value: number) => number} off @param {Question} question @param {number} tolerance
 * @param {(value: number) => number} allowed off a mistake's value @returns {Judged} */
function judgedBy(off, { right, wrong }, tolerance, allowed) {
  if (off(right) <= tolerance) return { verdict: "right", words: "right" };
  const near = wrong.filter(([value]) => off(value) <= allowed(value)).sort(([one], [other]) => off(one) - off(other));
  const mistakes = near[0]?.[1] ?? [];
  return { verdict: "wrong", words: mistakes.length ? "mistake" : "wrong", mistakes };
}

/** @param {number} one @param {number} other @param {number} turn @returns {number} */
function anglesApart(one, other, turn) {
  const off = Math.abs(one - other) % turn;
  return Math.min(off, turn - off);
}

/** @param {HTMLFormElement} form @param {string} which @returns {string} */
function quizField(form, which) {
  const field = form.querySelector(which);
  return field instanceof HTMLInputElement || field instanceof HTMLSelectElement ? field.value : "";
}
