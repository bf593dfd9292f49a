/** Questions on the drawn position, one after another. Only answers are compared here: all of them come with the page. */
import { html, partOf, setAttributes, takeEvent } from "./dom.js";
import { directionOf, modulo, numberIn } from "./numbers.js";
import { dragged, svg } from "./svg.js";
import { inEachLanguage, say, spoken, typeset } from "./words.js";

/** @import { Both } from "./words.js" */
/** `wrong`: what mistakes give, and their numbers; `turn`: a value begins anew after so much of its unit.
 * @typedef {{kind: "line" | "arrow" | "value", plane: string, act: number, name: string, right: number, wrong: [number,
 * number[]][], point?: string, from?: string, words: Both, dimension?: string, unit?: string,
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
  /** @param {Quiz} quiz @param {import("./player.js").Player} player @param {HTMLElement} element */
  constructor(quiz, player, element) {
    this.quiz = quiz;
    this.player = player;
    this.element = element;
    /** @type {HTMLFormElement} */
    this.form = partOf(element, "form");
    /** @type {HTMLElement} */
    this.verdict = partOf(element, ".quiz-verdict");
    this.number = -1; // of the question that is asked
    this.tries = 0;
    this.done = false;
    this.score = 0; // questions that were answered right at once
    /** @type {SVGElement | null} */
    this.direction = null;
    this.form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.judge(this.quiz.questions[this.number]);
    });
    this.form.addEventListener("input", () => this.done || this.tell(""));
    this.acts = {
      quiz: () => this.ask(this.score = 0), "show-answer": () => this.reveal("shown"),
      "next-question": () => this.ask(this.number + 1), "leave-quiz": () => this.ask(-1),
    };
    inEachLanguage(() => this.showWords());
  }

  /** Ask a question, or begin and end where there is none. @param {number} number */
  ask(number) {
    this.number = number;
    const question = this.quiz.questions[number];
    this.direction?.remove();
    for (const figure of this.player.figures) figure.turning = [];
    this.player.showUpTo(question ? question.act - Number(question.kind !== "value") : null);
    this.element.dataset.quiz = question ? question.kind : "off";
    this.tries = 0;
    this.done = false;
    this.form.reset();
    this.showWords();
    if (!question) return;
    partOf(this.form, ".quiz-sense").hidden = question.sense !== "turn";
    const figure = this.player.figureOf(question.plane);
    figure.section.scrollIntoView({ block: "nearest", inline: "start" });
    const point = figure.drawing.querySelector(`circle.point[data-name="${CSS.escape(question.point ?? "")}"]`);
    if (point) this.turn(question, figure, point);
    partOf(this.element, "[data-quiz-question]").focus({ preventScroll: true });
  }

  /** @param {Question} question @param {import("./figure.js").PlaneFigure} figure @param {Element} point */
  turn(question, figure, point) {
    const [x, y] = ["cx", "cy"].map((side) => Number(point.getAttribute(side)));
    this.direction = turnedDirection(question, x, y, partOf(this.form, "[data-quiz-angle]"));
    figure.drawing.append(this.direction);
    figure.turning = [[x, y, QUIZ_ARROW + 2]];
    figure.zoom();
  }

  /** What is asked, in the page's language. */
  showWords() {
    const question = this.quiz.questions[this.number];
    const [count, score, asked] = [".quiz-count", "[data-quiz-score]", "[data-quiz-question]"].map((part) => partOf(this.element, part));
    const all = this.quiz.questions.length;
    score.textContent = this.number < all ? say("quiz.about") : say("quiz.score", { right: this.score, count: all });
    this.tell("");
    if (!question) return;
    count.textContent = say("quiz.count", { number: this.number + 1, count: all });
    asked.dataset.quizQuestion = String(this.number);
    asked.replaceChildren(...typeset(say(`quiz.${question.kind}`, { name: question.name, from: question.from })));
  }

  /** @param {string} verdict @param {Node[]} words */
  tell(verdict, ...words) {
    this.verdict.dataset.quizVerdict = verdict;
    this.verdict.replaceChildren(...words);
  }

  /** @param {Question} question */
  judge(question) {
    const judged = (question.kind === "value" ? judgeValue : judgeAngle)(this.quiz, question, this.form);
    this.tell(judged.verdict, ...typeset(say(`quiz.${judged.words}`, { name: question.name, off: judged.off })));
    (judged.mistakes ?? []).forEach((mistake, k) => {
      const or = k ? [html("em", {}, say("quiz.or")), " "] : [];
      const told = typeset(spoken(this.quiz.mistakes[mistake]));
      this.verdict.append(html("p", { "data-quiz-mistake": mistake }, ...or, ...told));
    });
    if (judged.verdict === "unread" || this.done) return;
    if (judged.verdict === "right") this.reveal("right", ...this.verdict.childNodes);
    else this.tries += 1;
  }

  /** The answer in words, and the act that it belongs to. @param {"right" | "shown"} verdict @param {Node[]} words */
  reveal(verdict, ...words) {
    const question = this.quiz.questions[this.number];
    if (verdict === "right" && this.tries === 0) this.score += 1;
    this.tries += 1;
    this.done = true;
    this.tell(verdict, ...words, html("p", { "data-quiz-answer": true }, ...typeset(spoken(question.words))));
    this.player.showUpTo(question.act);
  }
}

/** A line or an arrow over a drawing that the student turns about its point. @param {Question} question
 * @param {number} x @param {number} y @param {HTMLInputElement} field shows the angle, and takes it @returns {SVGElement} */
function turnedDirection(question, x, y, field) {
  const turn = question.kind === "line" ? 180 : 360;
  const lines = [svg("line", { class: "quiz-wide" }), svg("line", { class: "quiz-line" })];
  const head = svg("path", { class: "quiz-head", d: turn === 180 ? "" : `M${QUIZ_ARROW} 0l-4 1.2v-2.4Z` });
  const handle = svg("circle", {
    class: "quiz-handle", r: 3, tabindex: 0, role: "slider", "aria-labelledby": "quiz-question", "aria-valuemin": 0, "aria-valuemax": turn,
  });
  const show = (/** @type {number} */ angle) => {
    const along = { x: Math.cos((angle * Math.PI) / 180), y: -Math.sin((angle * Math.PI) / 180) };
    const [from, to] = turn === 180 ? [-QUIZ_REACH, QUIZ_REACH] : [0, QUIZ_ARROW];
    const ends = { x1: x + from * along.x, y1: y + from * along.y, x2: x + to * along.x, y2: y + to * along.y };
    for (const line of lines) setAttributes(line, ends);
    const grip = { cx: x + QUIZ_HANDLE * along.x, cy: y + QUIZ_HANDLE * along.y };
    setAttributes(handle, { ...grip, "aria-valuenow": angle, "aria-valuetext": `${angle}°` });
    head.setAttribute("transform", `translate(${x} ${y}) rotate(${-angle})`);
  };
  const turnTo = (/** @type {number} */ angle) => {
    field.value = String(modulo(Math.round(angle * 10) / 10, turn));
    field.dispatchEvent(new Event("input", { bubbles: true }));
  };
  const group = svg("g", { class: "quiz-direction", "data-quiz-direction": question.kind }, ...lines, head, handle);
  dragged(group, handle, true, (to) => turnTo(directionOf(to.x - x, y - to.y)));
  handle.addEventListener("keydown", (event) => {
    const way = QUIZ_KEYS[event.key];
    if (!way) return;
    takeEvent(event);
    turnTo(Number(field.value) + way);
  });
  field.oninput = () => {
    const typed = numberIn(field.value);
    if (typed !== null) show(typed);
  };
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
