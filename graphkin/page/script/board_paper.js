/** Gridded paper with a pole: what of it is seen, and what is drawn on it. */
import { drawnSteps } from "./board_drawing.js";
import { paperOf } from "./board_state.js";
import { setAttributes } from "./dom.js";
import { within } from "./numbers.js";
import { svg } from "./svg.js";

export class BoardPaper {
  /** @param {string} plane */
  constructor(plane) {
    this.plane = plane;
    this.box = paperOf(plane).box;
    this.view = { ...this.whole };
    /** @type {import("./board_geometry.js").Spot} of the keys */
    this.cursor = { x: 0, y: 0 };
    this.drawn = svg("g", { class: "drawn" });
    this.aids = svg("g", { class: "aids", "aria-hidden": "true" });
    this.element = svg("svg", {
      class: "paper", "data-plane": plane, tabindex: 0, role: "application", "font-family": "serif",
    }, gridOf(plane, this.whole), this.drawn, this.aids);
    this.zoom(paperOf(plane).near);
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  /** All of the paper, y down [mm]. */
  get whole() {
    const { left, right, low, high } = this.box;
    return { x: left, y: -high, wide: right - left, high: high - low };
  }

  /** A pixel of the screen on the paper [mm]. */
  get pixel() {
    const matrix = this.element.getScreenCTM();
    return matrix && matrix.a > 0 ? 1 / matrix.a : this.view.wide / 800;
  }

  /** @returns {import("./board_drawing.js").Pen} */
  get pen() {
    return { pole: { x: 0, y: 0 }, pixel: this.pixel, letters: 16 * this.pixel };
  }

  draw() {
    this.drawn.replaceChildren(...drawnSteps(this.plane, this.pen));
  }

  /** Nearer or further, about a place that stays where it is [mm, y down]. @param {number} factor
   * @param {{x: number, y: number}} [about] */
  zoom(factor, about = { x: this.view.x + this.view.wide / 2, y: this.view.y + this.view.high / 2 }) {
    const { whole } = this;
    const wide = Math.min(whole.wide, Math.max(14, this.view.wide / factor));
    const part = wide / this.view.wide;
    this.view = {
      x: about.x - (about.x - this.view.x) * part, y: about.y - (about.y - this.view.y) * part,
      wide, high: (wide * whole.high) / whole.wide,
    };
    this.pan(0, 0);
  }

  /** Move what is seen, never off the paper [mm]. @param {number} x @param {number} y */
  pan(x, y) {
    const { view, whole } = this;
    view.x = within(view.x - x, whole.x, whole.x + whole.wide - view.wide);
    view.y = within(view.y - y, whole.y, whole.y + whole.high - view.high);
    const box = [view.x, view.y, view.wide, view.high].map((size) => size.toFixed(3));
    this.element.setAttribute("viewBox", box.join(" "));
    this.draw();
  }

  /** What is printed: so much of the paper as a page has room for, in true millimetres, about what is drawn. */
  printed() {
    const [box, whole] = [this.drawn.getBBox(), this.whole];
    const [wide, high] = [Math.min(170, whole.wide), Math.min(200, whole.high)];
    const x = within(box.x + (box.width - wide) / 2, whole.x, whole.x + whole.wide - wide);
    const y = within(box.y + (box.height - high) / 2, whole.y, whole.y + whole.high - high);
    setAttributes(this.element, { width: `${wide}mm`, height: `${high}mm`, viewBox: `${x} ${y} ${wide} ${high}` });
  }

  /** As before it was printed. */
  onScreen() {
    setAttributes(this.element, { width: null, height: null });
    this.pan(0, 0);
  }
}

/** Squares of 5 mm, each second line bolder. @param {string} plane
 * @param {{x: number, y: number, wide: number, high: number}} whole */
function gridOf(plane, { x, y, wide, high }) {
  const square = svg("pattern", { id: `grid-${plane}`, width: 10, height: 10, patternUnits: "userSpaceOnUse" },
    svg("path", { d: "M5 0V10M0 5H10", class: "fine" }), svg("path", { d: "M0 0V10M0 0H10", class: "bold" }));
  return svg("g", { "aria-hidden": "true" }, svg("defs", {}, square),
    svg("rect", { x, y, width: wide, height: high, fill: `url(#grid-${plane})`, class: "grid" }));
}
