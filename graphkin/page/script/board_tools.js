/** The tools of the board: what a press, a second place and the fields beside them make of a paper. */
import { acrossPaper, angleOf, apart, laidOff, lengthAlong, nearestOn, toEdge } from "./board_geometry.js";
import {
  givenLines, letterAt, letteredPoints, lineName, pairName, spotOf, stepNear, stepsOf, writtenSpot,
} from "./board_steps.js";
import { BOARD, paperOf, work } from "./board_state.js";

/** @import { Spot } from "./board_geometry.js" */
/** @import { Step } from "./board_state.js" */
/** @typedef {{name: string, angle: number}} ChosenLine */
/** What stands in the fields beside the tools; null where nothing does.
 * @typedef {{line: ChosenLine | null, kind: string, length: number | null, angle: number | null}} ToolFields */

const SHORTEST = 0.05; // [mm]

/** The fields that a tool has. @type {Record<string, string[]>} */
export const TOOL_FIELDS = {
  parallel: ["line"], perpendicular: ["line"], compass: ["length"], protractor: ["angle"],
  vector: ["kind", "line", "length", "angle", "name"], point: ["name"], letter: ["name"],
};

/** True of a tool that is told everything by one place. @param {string} tool @param {ToolFields} fields */
export function needsOnePlace(tool, fields) {
  if (tool === "compass") return fields.length !== null;
  if (tool === "protractor") return fields.angle !== null;
  if (tool === "vector") return fields.kind === "angle" && fields.angle !== null && fields.length !== null;
  return !["line", "measure", "vector"].includes(tool);
}

/** A step as a tool draws it from one place to another, or the key of the words that say what is missing.
 * @param {string} tool @param {string} plane @param {Spot} from @param {Spot} to @param {ToolFields} fields */
export function stepOf(tool, plane, from, to, fields) {
  const { box } = paperOf(plane);
  switch (tool) {
    case "line":
      return apart(from, to) < SHORTEST ? "too short" : stepBetween(plane, tool, [from, to]);
    case "parallel":
    case "perpendicular": {
      if (!fields.line) return "choose line";
      const ends = acrossPaper(from, fields.line.angle + (tool === "perpendicular" ? 90 : 0), box);
      return stepBetween(plane, tool, ends, { point: writtenSpot(from), line: fields.line.name });
    }
    case "compass": {
      const edge = fields.length === null ? to : laidOff(from, 0, fields.length);
      return apart(from, edge) < SHORTEST ? "too short" : stepBetween(plane, tool, [from, edge]);
    }
    case "protractor": {
      const angle = fields.angle ?? 0;
      return stepBetween(plane, tool, [from, laidOff(from, angle, toEdge(from, angle, box))], { angle });
    }
    case "vector":
      return vectorStep(plane, from, to, fields);
    default:
      return stepBetween(plane, "point", [from]);
  }
}

/** @param {string} plane @param {string} tool @param {Spot[]} spots @param {Partial<Step>} [more] @returns {Step} */
function stepBetween(plane, tool, spots, more = {}) {
  return { plane, tool, at: spots.map(writtenSpot), ...more };
}

/** An arrow from a place: in the direction of the fields or of the second place, which tells its sense; so long as the
 * field says, or to the second place. @param {string} plane @param {Spot} from @param {Spot} to
 * @param {ToolFields} fields @returns {Step | string} */
function vectorStep(plane, from, to, fields) {
  let angle = angleOf(from, to);
  let length = fields.length ?? apart(from, to);
  /** @type {import("./board_state.js").StepDirection | null} */
  let direction = null;
  if (fields.kind === "angle") {
    if (fields.angle === null) return "give angle";
    angle = fields.angle;
    direction = { kind: "angle", angle };
    length = fields.length ?? lengthAlong(from, to, angle);
  } else if (fields.kind) {
    if (!fields.line) return "choose line";
    angle = fields.line.angle + (fields.kind === "perpendicular" ? 90 : 0);
    if (lengthAlong(from, to, angle) < 0) angle += 180;
    direction = { kind: fields.kind, line: fields.line.name };
    length = fields.length ?? lengthAlong(from, to, angle);
  }
  if (fields.length === null && length < SHORTEST) return "too short";
  if (!fields.kind && fields.length !== null && apart(from, to) < SHORTEST) return "second place";
  const head = fields.length === null && !fields.kind ? to : laidOff(from, angle, length);
  return stepBetween(plane, "vector", [from, head], { direction, length: Number(length.toFixed(4)) });
}

/** The line at a place of a paper: one that is drawn there, or one of the mechanism; null if there is none.
 * @param {string} plane @param {Spot} at @param {number} reach [mm] @returns {ChosenLine | null} */
export function lineAt(plane, at, reach) {
  let [best, least] = [/** @type {ChosenLine | null} */ (null), reach];
  for (const { name, shape, drawn } of givenLines(plane)) {
    const off = apart(nearestOn(shape, at), at) + (drawn ? 0 : 0.1 * reach);
    if (off < least) [best, least] = [{ name, angle: angleOf(shape.from, shape.to) }, off];
  }
  const step = stepNear(plane, at, least, ({ tool }) => tool !== "point" && tool !== "compass");
  return step ? lineOfStep(step) : best;
}

/** @param {Step} step @returns {ChosenLine} */
function lineOfStep(step) {
  const [from, to] = step.at.map(spotOf);
  return { name: lineName(step), angle: angleOf(from, to) };
}

/** The line through two lettered points of a paper. @param {string} plane @param {string} one @param {string} other */
export function lineThrough(plane, one, other) {
  const points = letteredPoints(plane);
  const [from, to] = [one, other].map((name) => points.find((point) => point.name === name)?.spot);
  return from && to && apart(from, to) > SHORTEST ? { name: pairName(one, other), angle: angleOf(from, to) } : null;
}

/** All lines that can be chosen: the mechanism's, the axes, then what is drawn. @returns {ChosenLine[]} */
export function allLines() {
  const hasFigure = BOARD.papers.some(({ plane }) => plane === "position");
  const letters = hasFigure ? letteredPoints("position").map(({ name }) => name) : [];
  const pairs = letters.flatMap((one, k) => letters.slice(k + 1).map((other) => lineThrough("position", one, other)));
  const lines = [
    ...BOARD.given.lines.map(({ name, angle, at }) =>
      ({ name, angle: at ? angleOf(spotOf(at[0]), spotOf(at[1])) : angle ?? 0 })),
    { name: "x", angle: 0 }, { name: "y", angle: 90 }, ...pairs.filter((line) => line !== null),
    ...work.steps.filter(({ tool }) => tool !== "point" && tool !== "compass").map(lineOfStep),
  ];
  return lines.filter((line, k) => lines.findIndex(({ name }) => name === line.name) === k);
}

/** The student's arrow or point that `letter` names. @param {string} plane @param {Spot} at @param {number} reach */
export function lettered(plane, at, reach) {
  return stepNear(plane, at, reach, ({ tool }) => tool === "point" || tool === "vector");
}

/** True if no other point, or no other arrow, of the paper bears a name. @param {Step} step @param {string} name */
export function isFreeName(step, name) {
  const { plane, tool } = step;
  const isGiven = paperOf(plane).pole === name || (plane === "position" && name in BOARD.given.points);
  const others = stepsOf(plane).filter((each) => each !== step && each.tool === tool);
  return !(isGiven && tool === "point") && others.every((each) => each.name !== name);
}

/** What ruler [mm] and protractor [deg] read. @param {string} plane @param {Spot} from @param {Spot} to */
export function reading(plane, from, to) {
  const scale = work.scales[plane];
  const length = Math.round(apart(from, to) * 10) / 10;
  return {
    length: length.toFixed(1), angle: (Math.round(angleOf(from, to) * 10) / 10).toFixed(1),
    size: scale ? String(Number((length * scale).toPrecision(4))) : "", unit: paperOf(plane).unit,
    from: letterAt(plane, from), to: letterAt(plane, to),
  };
}
