/** Ruler and compass on a paper: millimetres from the pole, y up. */
import { directionOf, within } from "./numbers.js";

/** @typedef {{x: number, y: number}} Spot */
/** @typedef {{kind: "line", from: Spot, to: Spot}} Segment */
/** @typedef {{kind: "circle", centre: Spot, radius: number}} Circle */
/** @typedef {Segment | Circle} Shape */

/** The edges of a paper [mm]. @typedef {{left: number, right: number, low: number, high: number}} Box */

/** @param {Spot} a @param {Spot} b */
export function apart(a, b) {
  return Math.hypot(b.x - a.x, b.y - a.y);
}

/** The angle from +x to the direction of b from a, 0 to 360 [deg]. @param {Spot} a @param {Spot} b */
export function angleOf(a, b) {
  return directionOf(b.x - a.x, b.y - a.y);
}

/** A place so far from another in a direction [deg]. @param {Spot} from @param {number} angle @param {number} length */
export function laidOff(from, angle, length) {
  const turn = (angle * Math.PI) / 180;
  return { x: from.x + length * Math.cos(turn), y: from.y + length * Math.sin(turn) };
}

/** The length along a direction [deg] of the way from a to b. @param {Spot} a @param {Spot} b @param {number} angle */
export function lengthAlong(a, b, angle) {
  const turn = (angle * Math.PI) / 180;
  return (b.x - a.x) * Math.cos(turn) + (b.y - a.y) * Math.sin(turn);
}

/** The place of a shape that is nearest to a spot. @param {Shape} shape @param {Spot} at @returns {Spot} */
export function nearestOn(shape, at) {
  if (shape.kind === "circle") return laidOff(shape.centre, angleOf(shape.centre, at), shape.radius);
  const length = apart(shape.from, shape.to);
  if (length === 0) return shape.from;
  const angle = angleOf(shape.from, shape.to);
  return laidOff(shape.from, angle, within(lengthAlong(shape.from, at, angle), 0, length));
}

/** The line through a place, as far as the paper goes; from the one edge to the other. @param {Spot} at
 * @param {number} angle [deg] @param {Box} box @returns {[Spot, Spot]} */
export function acrossPaper(at, angle, box) {
  return [laidOff(at, angle, -toEdge(at, angle + 180, box)), laidOff(at, angle, toEdge(at, angle, box))];
}

/** How far the edge of the paper is in a direction. @param {Spot} at @param {number} angle [deg] @param {Box} box */
export function toEdge(at, angle, box) {
  const step = laidOff({ x: 0, y: 0 }, angle, 1);
  const ways = [Infinity];
  if (Math.abs(step.x) > 1e-9) ways.push(((step.x > 0 ? box.right : box.left) - at.x) / step.x);
  if (Math.abs(step.y) > 1e-9) ways.push(((step.y > 0 ? box.high : box.low) - at.y) / step.y);
  return Math.max(0, Math.min(...ways));
}

const CROSSING_REACH = 0.5; // lines that end so near each other cross [mm]

/** Where two shapes cross, or touch. @param {Shape} one @param {Shape} other @returns {Spot[]} */
export function crossings(one, other) {
  if (one.kind === "line" && other.kind === "line") return linesCross(one, other);
  if (one.kind === "circle" && other.kind === "circle") return circlesCross(one, other);
  const [line, circle] = one.kind === "line" ? [one, other] : [other, one];
  if (line.kind !== "line" || circle.kind !== "circle") return [];
  return lineCrossesCircle(line, circle).filter((spot) => isOnLine(line, spot));
}

/** @param {Segment} line @param {Spot} spot */
function isOnLine(line, spot) {
  return apart(nearestOn(line, spot), spot) <= CROSSING_REACH;
}

/** @param {Segment} one @param {Segment} other */
function linesCross(one, other) {
  const [angle, across] = [angleOf(one.from, one.to), angleOf(other.from, other.to)];
  const sine = Math.sin(((across - angle) * Math.PI) / 180);
  if (Math.abs(sine) < 1e-4) return [];
  const spot = laidOff(one.from, angle, lengthAlong(one.from, other.from, across - 90) / sine);
  return isOnLine(one, spot) && isOnLine(other, spot) ? [spot] : [];
}

/** @param {Segment} line @param {Circle} circle */
function lineCrossesCircle(line, circle) {
  const angle = angleOf(line.from, line.to);
  const foot = laidOff(line.from, angle, lengthAlong(line.from, circle.centre, angle));
  const square = circle.radius ** 2 - apart(foot, circle.centre) ** 2;
  if (square < -0.02 * circle.radius) return []; // a pencil's line that nearly touches does
  const half = Math.sqrt(Math.max(0, square));
  return half === 0 ? [foot] : [laidOff(foot, angle, half), laidOff(foot, angle, -half)];
}

/** They cross where the line through their crossings crosses one. @param {Circle} one @param {Circle} other */
function circlesCross(one, other) {
  const between = apart(one.centre, other.centre);
  if (between === 0) return [];
  const along = (between ** 2 + one.radius ** 2 - other.radius ** 2) / (2 * between);
  const angle = angleOf(one.centre, other.centre);
  const from = laidOff(one.centre, angle, along);
  return lineCrossesCircle({ kind: "line", from, to: laidOff(from, angle + 90, 1) }, one);
}
