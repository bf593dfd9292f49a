/** What the steps of a drawing are on paper: shapes, lettered points, places to which a pencil is drawn; and in words. */
import { angleOf, apart, crossings, nearestOn } from "./board_geometry.js";
import { BOARD, paperOf, work } from "./board_state.js";
import { say } from "./words.js";

/** @import { Segment, Shape, Spot } from "./board_geometry.js" */
/** @import { Step } from "./board_state.js" */
/** @typedef {{spot: Spot, kind: "point" | "end" | "crossing" | "line" | "free", name: string}} Snap */

const SAME_PLACE = 0.05; // places so near each other are one [mm]

/** @param {[number, number]} place @returns {Spot} */
export function spotOf([x, y]) {
  return { x, y };
}

/** A place as it is written, to a ten-thousandth of a millimetre. @param {Spot} spot @returns {[number, number]} */
export function writtenSpot(spot) {
  return [Number(spot.x.toFixed(4)), Number(spot.y.toFixed(4))];
}

/** @param {string} plane */
export function stepsOf(plane) {
  return work.steps.filter((step) => step.plane === plane);
}

/** The line or circle that a step draws; none of a point. @param {Step} step @returns {Shape | null} */
export function shapeOf(step) {
  if (step.tool === "point") return null;
  const [from, to] = step.at.map(spotOf);
  if (step.tool === "compass") return { kind: "circle", centre: from, radius: apart(from, to) };
  return { kind: "line", from, to };
}

/** The lettered points of a paper, with its pole. @param {string} plane @returns {{name: string, spot: Spot}[]} */
export function letteredPoints(plane) {
  const points = [{ name: paperOf(plane).pole, spot: { x: 0, y: 0 } }];
  for (const [name, place] of Object.entries(plane === "position" ? BOARD.given.points : {})) {
    if (name !== points[0].name) points.push({ name, spot: spotOf(place) });
  }
  for (const step of stepsOf(plane)) {
    if (step.tool === "point" && step.name) points.push({ name: step.name, spot: spotOf(step.at[0]) });
  }
  return points;
}

/** The letter of the point at a place, or "". @param {string} plane @param {Spot} spot */
export function letterAt(plane, spot) {
  return letteredPoints(plane).find((point) => apart(point.spot, spot) < SAME_PLACE)?.name ?? "";
}

/** The lines of the mechanism on a paper. @param {string} plane
 * @returns {{name: string, shape: Segment, drawn: boolean}[]} */
export function givenLines(plane) {
  const lines = plane === "position" ? BOARD.given.lines : [];
  return lines.flatMap(({ name, at, drawn }) =>
    at ? [{ name, drawn, shape: { kind: "line", from: spotOf(at[0]), to: spotOf(at[1]) } }] : []);
}

/** @param {string} plane */
function givenShapes(plane) {
  return givenLines(plane).filter(({ drawn }) => drawn).map(({ shape }) => shape);
}

/** @type {WeakMap<Step[], Map<string, Snap[]>>} of each drawing, by plane */
const SNAP_PLACES = new WeakMap();

/** All places of a paper to which a pencil is drawn: points, ends of what is drawn, crossings. Nothing else is.
 * @param {string} plane @returns {Snap[]} */
function snapPlaces(plane) {
  const every = SNAP_PLACES.get(work.steps) ?? new Map();
  SNAP_PLACES.set(work.steps, every);
  if (every.has(plane)) return every.get(plane);
  /** @type {Snap[]} */
  const places = letteredPoints(plane).map(({ name, spot }) => ({ spot, kind: "point", name }));
  /** @type {Shape[]} */
  const shapes = givenShapes(plane);
  for (const step of stepsOf(plane)) {
    const { tool, at } = step;
    const ends = tool === "line" || tool === "vector" ? 2 : tool === "parallel" || tool === "perpendicular" ? 0 : 1;
    for (const place of at.slice(0, ends)) places.push({ spot: spotOf(place), kind: "end", name: "" });
    const shape = shapeOf(step);
    if (!shape) continue;
    const spots = shapes.flatMap((other) => crossings(shape, other));
    for (const spot of spots) places.push({ spot, kind: "crossing", name: "" });
    shapes.push(shape);
  }
  every.set(plane, places);
  return places;
}

/** The next of the points, ends and crossings. @param {string} plane @param {Spot} spot @param {number} by */
export function nextPlace(plane, spot, by) {
  const places = snapPlaces(plane).map((place) => place.spot);
  const here = places.findIndex((place) => apart(place, spot) < SAME_PLACE);
  return places[(here + by + places.length) % places.length];
}

/** Where a pencil that comes so near is set: on a point, an end or a crossing, else on a line, else where it is.
 * @param {string} plane @param {Spot} at @param {number} reach [mm] @returns {Snap} */
export function snapped(plane, at, reach) {
  const places = snapPlaces(plane);
  let best = places[0];
  for (const place of places) if (apart(place.spot, at) < apart(best.spot, at) - 1e-6) best = place;
  if (apart(best.spot, at) <= reach) return best;
  let near = { spot: at, off: reach / 2 };
  for (const shape of [...givenShapes(plane), ...stepsOf(plane).map(shapeOf)]) {
    if (!shape) continue;
    const spot = nearestOn(shape, at);
    if (apart(spot, at) < near.off) near = { spot, off: apart(spot, at) };
  }
  return { spot: near.spot, kind: near.spot === at ? "free" : "line", name: "" };
}

/** The step nearest to a place, among those of some tools; a point before a vector before a line. @param {string} plane
 * @param {Spot} at @param {number} reach [mm] @param {(step: Step) => boolean} [among] @returns {Step | null} */
export function stepNear(plane, at, reach, among = () => true) {
  let best = null;
  let least = Infinity;
  for (const step of stepsOf(plane)) {
    if (!among(step)) continue;
    const shape = shapeOf(step);
    const off = apart(shape ? nearestOn(shape, at) : spotOf(step.at[0]), at);
    const order = step.tool === "point" ? 0 : step.tool === "vector" ? reach : 2 * reach;
    if (off <= reach && off + order < least) [best, least] = [step, off + order];
  }
  return best;
}

/** The name by which other steps speak of a drawn line: an arrow's own, its ends' letters, or the step's number.
 * @param {Step} step */
export function lineName(step) {
  if (step.name) return step.name;
  const ends = step.tool === "line" ? step.at.map((place) => letterAt(step.plane, spotOf(place))) : [];
  if (ends.length === 2 && ends.every(Boolean)) return pairName(ends[0], ends[1]);
  return `step ${work.steps.indexOf(step) + 1}`;
}

/** The steps without one; what was said of later ones by their number is said by that which they have then.
 * @param {Step} gone */
export function stepsWithout(gone) {
  const number = work.steps.indexOf(gone) + 1;
  const renamed = (/** @type {string | undefined} */ line) => {
    const said = Number(/^step (\d+)$/.exec(line ?? "")?.[1] ?? 0);
    return said > number ? `step ${said - 1}` : said && said === number ? "" : line;
  };
  return work.steps.filter((step) => step !== gone).map((step) => ({
    ...step, line: renamed(step.line),
    direction: step.direction && { ...step.direction, line: renamed(step.direction.line) },
  }));
}

/** The line through two points, by the mechanism's name for it. @param {string} one @param {string} other */
export function pairName(one, other) {
  return BOARD.given.pairs.find((name) => name === one + other || name === other + one) ?? one + other;
}

/** What a polygon's point belongs to: `B3` of b3', `pole` of the pole; of a point of the mechanism itself that.
 * @param {string} plane @param {string} name */
export function belongsTo(plane, name) {
  if (plane === "position") return name;
  if (name === paperOf(plane).pole) return "pole";
  return paperOf(plane).of[name] || name.charAt(0).toUpperCase() + name.slice(1).replaceAll("'", "");
}

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
