/** Answers to questions beside the right one and those that mistakes give. */
import { numberIn } from "./numbers.js";

/** @import { Question, Quiz } from "./quiz.js" */
/** @typedef {{verdict: "right" | "wrong" | "unread", words: string, off?: number, mistakes?: number[]}} Judged */

const QUIZ_NEAR = 0.005; // an answer is a mistake's that differs from it by so small a part, or by what paper allows

/** @param {Quiz} quiz @param {Question} question @param {HTMLFormElement} form @returns {Judged} */
export function judgeAngle(quiz, question, form) {
  const given = numberIn(quizField(form, "[data-quiz-angle]"));
  if (given === null) return { verdict: "unread", words: "not a number" };
  const off = (/** @type {number} */ value) => anglesApart(given, value, question.kind === "line" ? 180 : 360);
  const judged = judgedBy(off, question, quiz.tolerance, () => quiz.tolerance);
  if (judged.words !== "wrong") return judged;
  const close = off(question.right) <= 3 * quiz.tolerance;
  return { verdict: "wrong", words: close ? "close" : "wrong", off: Math.round(off(question.right) * 10) / 10 };
}

/** @param {Quiz} quiz @param {Question} question @param {HTMLFormElement} form @returns {Judged} */
export function judgeValue(quiz, question, form) {
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
