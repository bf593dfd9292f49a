/** Gridded paper with a pole: what of it is seen, what is drawn on it, and the hand that points at it. */
import { drawnSteps } from "./board_drawing.js";
import { snapped, snapPlaces } from "./board_steps.js";
import { paperOf } from "./board_state.js";
import { setAttributes } from "./dom.js";
import { within } from "./numbers.js";
import { placeOn, svg } from "./svg.js";

/** @import { Spot } from "./board_geometry.js" */
/** @import { Snap } from "./board_steps.js" */
/** Where a hand points: exactly, and where the pencil is set. @typedef {{at: Spot, snap: Snap}} Pointed */
/** What a hand does on papers. `pans`: a press moves the paper; `moved`: by a key.
 * @typedef {{pans: () => boolean, hover: (paper: BoardPaper, from: Pointed | null, to: Pointed) => void,
 * finish: (paper: BoardPaper, from: Pointed, to: Pointed, dragged: boolean) => void,
 * cancel: (paper: BoardPaper) => void, moved: (paper: BoardPaper, pointed: Pointed) => void}} HandActs */

const MOUSE_REACH = 9;
const FINGER_REACH = 16; // [px]
const DRAGGED = 6; // so far a press and its release are apart [px]

export class BoardPaper {
  /** @param {string} plane @param {HandActs} acts */
  constructor(plane, acts) {
    this.plane = plane;
    this.acts = acts;
    this.box = paperOf(plane).box;
    this.view = { ...this.whole };
    this.reachPixels = MOUSE_REACH;
    /** @type {Spot} */
    this.cursor = { x: 0, y: 0 };
    /** @type {Map<number, {x: number, y: number}>} */
    this.pointers = new Map();
    /** @type {Pointed | null} */
    this.pressed = null;
    this.pressedAt = { x: 0, y: 0 };
    this.drawn = svg("g", { class: "drawn" });
    this.aids = svg("g", { class: "aids", "aria-hidden": "true" });
    this.element = svg("svg", {
      class: "paper", "data-plane": plane, tabindex: 0, role: "application", "font-family": "serif",
    }, gridOf(plane, this.whole), this.drawn, this.aids);
    this.zoom(paperOf(plane).near);
    this.listen();
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

  get reach() {
    return this.reachPixels * this.pixel;
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

  /** @param {Spot} at @returns {Pointed} */
  pointed(at) {
    const { left, right, low, high } = this.box;
    const kept = { x: within(at.x, left, right), y: within(at.y, low, high) };
    return { at: kept, snap: snapped(this.plane, kept, this.reach) };
  }

  /** @param {{clientX: number, clientY: number}} event */
  pointedBy(event) {
    const { x, y } = placeOn(this.element, event);
    return this.pointed({ x, y: -y });
  }

  listen() {
    const { element } = this;
    element.addEventListener("pointerdown", (event) => this.press(event));
    element.addEventListener("pointermove", (event) => this.move(event));
    element.addEventListener("pointerup", (event) => this.release(event));
    element.addEventListener("pointercancel", (event) => this.letGo(event.pointerId));
    element.addEventListener("pointerleave", () => !this.pressed && this.aids.replaceChildren());
    element.addEventListener("keydown", (event) => this.key(event));
    element.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !event.metaKey) return; // the page scrolls
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY / 300), placeOn(element, event));
    }, { passive: false });
    new ResizeObserver(() => this.draw()).observe(element);
  }

  /** @param {PointerEvent} event */
  press(event) {
    if (event.button > 1) return;
    this.element.setPointerCapture(event.pointerId);
    this.reachPixels = event.pointerType === "touch" ? FINGER_REACH : MOUSE_REACH;
    this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const pans = this.pointers.size > 1 || event.button === 1 || this.acts.pans();
    this.pressed = pans ? null : this.pointedBy(event);
    this.pressedAt = { x: event.clientX, y: event.clientY };
    if (this.pressed) this.acts.hover(this, null, this.pressed);
  }

  /** @param {PointerEvent} event */
  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before || this.pressed) {
      this.acts.hover(this, this.pressed && this.isDragged(event) ? this.pressed : null, this.pointedBy(event));
      return;
    }
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    const after = { x: event.clientX, y: event.clientY };
    const pixel = this.pixel;
    const part = 1 / this.pointers.size;
    if (others.length) {
      const spread = (/** @type {Spot} */ place) => Math.hypot(place.x - others[0].x, place.y - others[0].y) || 1;
      const middle = { clientX: (after.x + others[0].x) / 2, clientY: (after.y + others[0].y) / 2 };
      this.zoom(spread(after) / spread(before), placeOn(this.element, middle));
    }
    this.pan((after.x - before.x) * pixel * part, (after.y - before.y) * pixel * part);
    this.pointers.set(event.pointerId, after);
  }

  /** @param {{clientX: number, clientY: number}} event */
  isDragged(event) {
    return Math.hypot(event.clientX - this.pressedAt.x, event.clientY - this.pressedAt.y) > DRAGGED;
  }

  /** @param {PointerEvent} event */
  release(event) {
    const from = this.pressed;
    this.letGo(event.pointerId);
    if (!from) return;
    const to = this.pointedBy(event);
    this.cursor = to.snap.spot;
    this.acts.finish(this, from, to, this.isDragged(event));
  }

  /** @param {number} pointer */
  letGo(pointer) {
    this.pointers.delete(pointer);
    this.pressed = null;
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const step = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
    const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (by) this.moveCursor({ x: this.cursor.x + by[0] * step, y: this.cursor.y + by[1] * step });
    else if (event.key === "n" || event.key === "N") this.moveCursor(this.nextPlace(event.key === "n" ? 1 : -1));
    else if (event.key === "Enter" || event.key === " ") {
      const pointed = this.pointed(this.cursor);
      this.acts.finish(this, pointed, pointed, false);
    } else if (event.key === "Escape") this.acts.cancel(this);
    else if (event.key === "+" || event.key === "-") this.zoom(event.key === "+" ? 1.5 : 1 / 1.5);
    else return;
    event.preventDefault();
  }

  /** @param {Spot} at */
  moveCursor(at) {
    this.reachPixels = 2;
    const pointed = this.pointed(at);
    this.cursor = pointed.at;
    const [x, y, view] = [pointed.at.x, -pointed.at.y, this.view];
    if (x < view.x || y < view.y || x > view.x + view.wide || y > view.y + view.high) {
      this.pan(view.x + view.wide / 2 - x, view.y + view.high / 2 - y);
    }
    this.acts.moved(this, pointed);
  }

  /** The next of the points, ends and crossings. @param {number} by */
  nextPlace(by) {
    const places = snapPlaces(this.plane).map(({ spot }) => spot);
    const here = places.findIndex((spot) => Math.hypot(spot.x - this.cursor.x, spot.y - this.cursor.y) < 0.05);
    return places[(here + by + places.length) % places.length];
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
