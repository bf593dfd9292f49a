/** Places, lines and steps in words. */
import { angleOf, apart } from "./board_geometry.js";
import { letterAt, spotOf } from "./board_steps.js";
import { say } from "./words.js";

/** @import { Spot } from "./board_geometry.js" */
/** @import { Step } from "./board_state.js" */

/** The letter of a place, or where it is. @param {string} plane @param {Spot} spot */
export function placeWords(plane, spot) {
  return letterAt(plane, spot) || `(${spot.x.toFixed(1)}, ${spot.y.toFixed(1)})`;
}

/** @param {string} name */
export function lineWords(name) {
  return name.startsWith("step ") ? say("line of step", { number: name.slice(5) }) : name;
}

/** A step as a sentence. @param {Step} step */
export function stepWords(step) {
  const [from, to] = step.at.map(spotOf);
  const place = (/** @type {Spot} */ spot) => placeWords(step.plane, spot);
  return say(`step ${step.tool}`, {
    from: place(from), to: to ? place(to) : "", through: step.point ? place(spotOf(step.point)) : "",
    line: step.line ?? "", name: step.name ?? "?", length: to ? apart(from, to).toFixed(1) : "",
    angle: (step.angle ?? (to ? angleOf(from, to) : 0)).toFixed(1),
  });
}
