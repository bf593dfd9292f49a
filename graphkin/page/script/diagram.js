/** A quantity over the driver's way, with a cursor at the position shown. */
import { html, setAttributes } from "./dom.js";
import { endsOf } from "./axes.js";
import { measured, signNodes } from "./signs.js";
import { svg } from "./svg.js";

/** @import { ValueData } from "./state.js" */
/** `axis`: of the driver; `now`: the driver's value, as all of these in the unit that is shown; `quantity`: at a
 * driver's value; NaN where it has none.
 * @typedef {{axis: import("./state.js").Axis, now: () => number, quantity: (value: ValueData,
 * place: number) => number}} DiagramHost */

const DIAGRAM = { width: 120, height: 52, left: 14, right: 6, top: 3, bottom: 8 }; // [mm of its own]
const DIAGRAM_SAMPLES = 240;
const DIAGRAM_ANGLES = [360, 180, 90, 60, 45, 30, 15, 10, 5, 2, 1];

export class DiagramPart {
  /** @param {ValueData} quantity @param {DiagramHost} host */
  constructor(quantity, host) {
    this.quantity = quantity;
    this.host = host;
    const [first, last] = endsOf(host.axis);
    this.first = first * host.axis.factor;
    this.last = last * host.axis.factor;
    this.value = html("output", {});
    this.cursor = svg("line", { class: "diagram-cursor", y1: DIAGRAM.top, y2: DIAGRAM.height - DIAGRAM.bottom });
    this.dot = svg("circle", { class: "diagram-dot", r: 1.2 });
    this.drawing = svg("svg", { viewBox: `0 0 ${DIAGRAM.width} ${DIAGRAM.height}`, "aria-hidden": "true" });
    const caption = html("figcaption", {}, ...signNodes(quantity.sign), " = ", this.value);
    this.element = html("figure", { class: "diagram", "data-diagram": quantity.name }, caption, this.drawing);
    this.drawn = false;
    this.low = this.high = 0;
  }

  draw() {
    const step = (this.last - this.first) / DIAGRAM_SAMPLES;
    const places = Array.from({ length: DIAGRAM_SAMPLES + 1 }, (_, k) => this.first + step * k);
    const values = places.map((place, k) => this.at(k < DIAGRAM_SAMPLES ? place : place - 1e-6 * step));
    const finite = values.filter(Number.isFinite);
    const ends = [Math.min(0, ...finite), Math.max(0, ...finite)];
    const ticks = ticksOver(ends[0], ends[1] > ends[0] ? ends[1] : ends[0] + 1, 4);
    [this.low, this.high] = [ticks[0], ticks[ticks.length - 1]];
    let path = "", on = false;
    places.forEach((place, k) => {
      const there = Number.isFinite(values[k]);
      if (there) path += `${on ? "L" : "M"}${this.x(place).toFixed(2)} ${this.y(values[k]).toFixed(2)}`;
      on = there;
    });
    this.drawing.replaceChildren(...this.grid(ticks), svg("path", { class: "diagram-curve", d: path }), this.cursor, this.dot);
    this.drawn = true;
  }

  /** @param {number[]} ticks @returns {SVGElement[]} */
  grid(ticks) {
    const { unit } = this.host.axis, low = this.first, high = this.last;
    const foot = DIAGRAM.height - DIAGRAM.bottom, end = DIAGRAM.width - DIAGRAM.right;
    const along = unit === "°" ? anglesOver(low, high) : ticksOver(low, high, 6).filter((at) => at >= low && at <= high);
    const lines = ticks.flatMap((at) => [
      svg("line", { class: at === 0 ? "diagram-axis" : "diagram-grid", x1: DIAGRAM.left, x2: end, y1: this.y(at), y2: this.y(at) }),
      svg("text", { x: DIAGRAM.left - 1, y: this.y(at) + 1, "text-anchor": "end" }, shortNumber(at)),
    ]);
    return [...lines, ...along.flatMap((at) => [
      svg("line", { class: "diagram-grid", x1: this.x(at), x2: this.x(at), y1: DIAGRAM.top, y2: foot }),
      svg("text", { x: this.x(at), y: foot + 4, "text-anchor": "middle" }, shortNumber(at) + (unit === "°" ? "°" : ` ${unit}`)),
    ])];
  }

  /** @param {number} place @returns {number} */
  at(place) {
    return this.host.quantity(this.quantity, place);
  }

  move() {
    if (!this.drawn) this.draw();
    const place = this.host.now(), value = this.at(place), there = Number.isFinite(value);
    this.value.textContent = there ? measured(value, this.quantity.unit) : "–";
    setAttributes(this.cursor, { x1: this.x(place), x2: this.x(place) });
    setAttributes(this.dot, { cx: this.x(place), cy: there ? this.y(value) : 0, display: there ? null : "none" });
  }

  /** @param {number} value of the driver */
  x(value) {
    return DIAGRAM.left + (DIAGRAM.width - DIAGRAM.left - DIAGRAM.right) * (value - this.first) / (this.last - this.first);
  }

  /** @param {number} value */
  y(value) {
    const foot = DIAGRAM.height - DIAGRAM.bottom;
    return foot - (foot - DIAGRAM.top) * (value - this.low) / (this.high - this.low);
  }
}

/** Round numbers that begin at or below one value and end at or above another. @param {number} low @param {number} high
 * @param {number} count about so many steps @returns {number[]} */
function ticksOver(low, high, count) {
  const least = (high - low) / count, power = 10 ** Math.floor(Math.log10(least));
  const step = [1, 2, 5, 10].map((times) => times * power).find((size) => size >= least * (1 - 1e-9)) ?? 10 * power;
  const first = Math.floor(low / step + 1e-9), last = Math.ceil(high / step - 1e-9);
  return Array.from({ length: last - first + 1 }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}

/** Round angles between two. @param {number} low @param {number} high @returns {number[]} */
function anglesOver(low, high) {
  const step = DIAGRAM_ANGLES.find((size) => (high - low) / size >= 3) ?? 1;
  const first = Math.ceil(low / step - 1e-9), last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, k) => (first + k) * step);
}

/** @param {number} value @returns {string} */
function shortNumber(value) {
  return String(value).replace("-", "−");
}
