/** The state of the page: which mechanism, where its drivers are, which step; who shows it follows its changes. */
import { parameterAt } from "./axes.js";
import { Tracks } from "./tracks.js";

/** @import { Sign } from "./signs.js" */
/** @import { Changing } from "./tracks.js" */
/** @import { Both } from "./words.js" */
/** @typedef {{value: number} & Both} PathEvent a dead point or a change point at a driver's value */
/** A driver and its knots.
 * @typedef {{name: string, unit: string, factor: number, low: number, high: number,
 * ends: "line" | "low" | "high" | "both", round: boolean, u: number[], period: number, start: number, rate: number,
 * events: PathEvent[], handle?: [Changing, Changing]}} Axis */
/** A mark of a figure.
 * @typedef {{kind: "line" | "body" | "circle" | "arc" | "text" | "vector" | "point", numbers: Changing[],
 * paint: number, step?: number, layer?: string, mask?: number, closed?: boolean, form?: string, base?: [number, number,
 * number, number], flags?: string, data?: Record<string, string>, radius?: number, sign?: Sign[], also?: string[],
 * spans?: [number, number, string, string, number][]}} Row */
/** @typedef {{plane: "position" | "velocity" | "acceleration", scale: number, written: Sign[], width: number,
 * height: number, origin: [number, number], rows: Row[], mask?: number, cells?: number | null}} PlaneData */
/** @typedef {{kind: string, words: Sign[][], numbers?: number[], sizes?: number[], turns?: number[], mask?: number}} Template */
/** @typedef {{step: number, plane: string, en: Template[][], zh: Template[][]}} StepData */
/** @typedef {{name: string, sign: Sign[], unit: string, value: Changing, mask?: number, rise?: number, size?: boolean}} ValueData */
/** @typedef {{name: string, title: Both, axes: Axis[], planes: PlaneData[], paints: Record<string, string>[],
 * wordKnots: number[][], quiz?: import("./quiz.js").Quiz, overlays?: import("./layers.js").Layers, steps: StepData[],
 * values: ValueData[], layers: string[], tracks: (string | [number, string])[], masks: string[]}} Mechanism */

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
    /** @type {(() => void)[]} */
    this.onMove = [];
  }

  /** The parameters of the drivers' values. */
  parameters() {
    return this.mechanism.axes.map((axis, k) => parameterAt(axis, this.values[k]));
  }
}
