/** The state of the page: which mechanism, where its drivers are, which step; who shows it follows its changes. */
import { modulo, within } from "./numbers.js";
import { Tracks } from "./tracks.js";

/** @import { Sign } from "./signs.js" */
/** @import { Changing } from "./tracks.js" */
/** @import { Both } from "./words.js" */
/** @typedef {{value: number} & Both} PathEvent a dead point or a change point at a driver's value */
/** A driver and its knots; `ends` of what the page shows; `wave`: at u its value is the first - the second cos u.
 * @typedef {{name: string, unit: string, factor: number, low: number, high: number, ends: [number, number],
 * wave: [number, number] | null, round: boolean, u: number[], period: number, start: number, rate: number,
 * events: PathEvent[], handle?: [Changing, Changing]}} Axis */
/** A mark of a figure.
 * @typedef {{kind: "line" | "segment" | "body" | "circle" | "arc" | "text" | "vector" | "point", numbers: Changing[],
 * step?: number, mask?: number, closed?: boolean, base?: [number, number, number, number], flags?: string,
 * sign?: Sign[]}} Row */
/** @typedef {{plane: "position" | "velocity" | "acceleration", scale: number, width: number, height: number,
 * origin: [number, number], rows: Row[], mask?: number, cells?: number | null}} PlaneData */
/** @typedef {{kind: string, words: Sign[][], numbers?: number[], sizes?: number[], turns?: number[], mask?: number}} Template */
/** @typedef {{step: number, plane: string, en: Template[][], zh: Template[][]}} StepData */
/** @typedef {{name: string, unit: string, value: Changing, mask?: number, rise?: number, turn?: number, size?: boolean,
 * diagram: {x: [number, number], y: [number, number]}}} ValueData */
/** `stage`: the elements, as HTML.
 * @typedef {{name: string, title: Both, axes: Axis[], planes: PlaneData[], wordKnots: number[][], stage: string,
 * quiz: import("./quiz.js").Quiz, overlays: import("./layers.js").Layers | null, steps: StepData[],
 * values: ValueData[], tracks: (string | [number, string])[], masks: string[]}} Mechanism */

/** One mechanism as it is shown. */
export class Shown {
  /** @param {Mechanism} mechanism */
  constructor(mechanism) {
    this.mechanism = mechanism;
    this.tracks = new Tracks(mechanism.axes, mechanism.tracks, mechanism.masks);
    const wordAxes = mechanism.axes.map((axis, k) => ({ u: mechanism.wordKnots[k], period: axis.period }));
    this.words = new Tracks(wordAxes, mechanism.tracks, mechanism.masks);
    /** @type {number[]} the drivers' values [rad, m] */
    this.values = mechanism.axes.map((axis) => axis.start);
    this.step = 0;
  }

  /** The parameters of the drivers' values. */
  parameters() {
    return this.mechanism.axes.map((axis, k) => parameterAt(axis, this.values[k]));
  }
}

/** The parameter of a driver's value, within the knots. @param {Axis} axis @param {number} value */
export function parameterAt(axis, value) {
  if (axis.round) return axis.low + modulo(value - axis.low, axis.high - axis.low);
  const [middle, half] = axis.wave ?? [0, 1];
  return within(axis.wave ? Math.acos(within((middle - value) / half, -1, 1)) : value, ...knotEnds(axis));
}

/** @param {Axis} axis @returns {[number, number]} */
export function knotEnds({ u }) {
  return [u[0], u[u.length - 1]];
}

/** @param {Axis} axis @param {number} u */
export function valueAt({ wave }, u) {
  return wave ? wave[0] - wave[1] * Math.cos(u) : u;
}

/** A value on the driver's way: round, or between its ends, if need be turned. @param {Axis} axis @param {number} value */
export function onTheWay({ unit, ends: [low, high], round }, value) {
  const turn = 2 * Math.PI;
  if (round) return low + modulo(value - low, turn);
  const shifted = unit === "°" ? value + turn * Math.round(((low + high) / 2 - value) / turn) : value;
  return within([value, shifted].find((each) => each > low - 1e-9 && each < high + 1e-9) ?? value, low, high);
}
