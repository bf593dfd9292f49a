/** Questions on the drawn position, one after another. Only answers are compared here: all of them come with the page. */
import { button, choice, html } from "./dom.js";
import { TurnedDirection } from "./quiz_direction.js";
import { judgeAngle, judgeValue } from "./quiz_judge.js";
import { inEachLanguage, say, spoken, typeset } from "./words.js";

/** @import { Both } from "./words.js" */
/** `wrong`: what mistakes give, and their numbers; `turn`: a value begins anew after so much of its unit.
 * @typedef {{kind: "line" | "arrow" | "value", plane: string, act: number, name: string, right: number, wrong: [number,
 * number[]][], point?: string, from?: string, words?: Both, dimension?: string, unit?: string,
 * sense?: "turn" | "sign" | "", tolerance?: number, turn?: number}} Question */
/** `at`: the drivers' values [rad, m]; `tolerance`: of a direction [deg].
 * @typedef {{questions: Question[], mistakes: Both[], at: number[], tolerance: number, units: {name: string,
 * kind: string, times: number}[]}} Quiz */
/** What the page shows of the drawn position. `showUpTo`: its acts up to one; all, as the page was, at the end; `look`:
 * bring a plane into view; `place`: of a point of a plane.
 * @typedef {{showUpTo: (act: number | null) => void, drawing: (plane: string) => SVGSVGElement | null,
 * look: (plane: string) => void, place: (plane: string, name: string) => {x: number, y: number} | null}} QuizHost */

/** The quiz as a part of the page. */
export class QuizPart {
  /** @param {Quiz} quiz @param {QuizHost} host */
  constructor(quiz, host) {
    this.quiz = quiz;
    this.host = host;
    this.element = html("section", { class: "quiz", "data-quiz": "off" });
    this.number = -1; // of the question that is asked
    this.tries = 0;
    this.done = false;
    this.score = 0; // questions that were answered right at once
    /** @type {TurnedDirection | null} */
    this.direction = null;
    inEachLanguage(() => this.draw());
  }

  ask() {
    const question = this.quiz.questions[this.number];
    this.host.showUpTo(question.kind === "value" ? question.act : question.act - 1);
    this.host.look(question.plane);
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
    const drawing = this.host.drawing(question.plane), at = this.host.place(question.plane, question.point ?? "");
    if (drawing && at) this.direction = new TurnedDirection(question, drawing, at, angle, label);
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
    this.host.showUpTo(question.act);
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
    this.host.showUpTo(null);
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
