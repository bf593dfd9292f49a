/** What is dragged: a bar for each driver, its crank pin on the mechanism, keys; and the motion that runs by itself. */
import { partOf, setAttributes, takeEvent } from "./dom.js";
import { within } from "./numbers.js";
import { knotEnds, onTheWay, parameterAt, valueAt } from "./state.js";
import { dragged, svg } from "./svg.js";
import { say, spoken } from "./words.js";

/** @import { Shown } from "./state.js" */

const STEP = { "°": 1, mm: 0.5 }; // of a key; of a bar a hundredth [deg, mm]
const FINE = 0.1;
const NEAR_EVENT = 0.012; // of the range: there a dead point is told
const SECONDS = 8; // of a turn that runs by itself

/** The bar and the handle of one driver. */
export class DriverControl {
  /** @param {Shown} shown @param {number} number @param {HTMLElement} element @param {(values: number[]) => void} go */
  constructor(shown, number, element, go) {
    this.shown = shown;
    this.number = number;
    this.axis = shown.mechanism.axes[number];
    this.go = go;
    /** @type {HTMLInputElement} */
    this.bar = partOf(element, "[data-driver]");
    /** @type {HTMLInputElement} */
    this.field = partOf(element, "[data-value]");
    /** @type {HTMLElement} */
    this.events = partOf(element, ".event");
    this.bar.addEventListener("input", () => this.set(this.bar.valueAsNumber / this.axis.factor));
    this.field.addEventListener("change", () => this.set(this.field.valueAsNumber / this.axis.factor));
    this.field.addEventListener("blur", () => this.show());
    this.bar.addEventListener("keydown", (event) => this.key(event));
    this.handle = this.axis.handle ? this.madeHandle() : null;
  }

  madeHandle() {
    const handle = svg("circle", {
      class: "handle", r: 4.5, "data-driver": this.axis.name, tabindex: 0, role: "slider",
      "data-word-label": "page.handle", "aria-valuemin": this.bar.min, "aria-valuemax": this.bar.max,
    });
    handle.addEventListener("keydown", (event) => this.key(event));
    dragged(handle, handle, false, (place) => this.set(this.nearestTo(place)));
    return handle;
  }

  get value() {
    return this.shown.values[this.number];
  }

  /** @param {number} value [rad, m] */
  set(value) {
    if (!Number.isFinite(value)) return;
    const values = [...this.shown.values];
    values[this.number] = onTheWay(this.axis, value);
    this.go(values);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const sense = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (!sense || event.altKey || event.ctrlKey || event.metaKey) return;
    takeEvent(event);
    const step = STEP[this.axis.unit === "°" ? "°" : "mm"] * (event.shiftKey ? FINE : 1);
    this.set(this.value + (sense * step) / this.axis.factor);
  }

  /** The value at which the handle is nearest to a place, not far along from where it is.
   * @param {{x: number, y: number}} place */
  nearestTo(place) {
    const { axis, shown } = this;
    const [x, y] = axis.handle ?? [0, 0];
    const us = shown.parameters();
    const start = us[this.number];
    const [first, last] = knotEnds(axis);
    const kept = (/** @type {number} */ u) => (axis.round ? parameterAt(axis, u) : within(u, first, last));
    const off = (/** @type {number} */ u) => {
      us[this.number] = kept(u);
      shown.tracks.moveTo(us);
      return Math.hypot(shown.tracks.value(x) - place.x, shown.tracks.value(y) - place.y);
    };
    const span = (last - first) / 4;
    let [best, least] = [start, off(start)];
    for (let reach = span; reach > span * 1e-4; reach /= 2.2) {
      const middle = best;
      for (let k = -6; k <= 6; k++) {
        const at = middle + (k * reach) / 6;
        const own = off(at) + 1e-6 * Math.abs(at - start);
        if (own < least) [best, least] = [at, own];
      }
    }
    return valueAt(axis, kept(best));
  }

  /** The bar and the handle where the driver is. */
  show() {
    const shown = this.value * this.axis.factor;
    const text = String(Math.round(shown * 1000) / 1000);
    this.bar.valueAsNumber = shown;
    if (!this.field.matches(":focus")) this.field.value = text;
    const said = `${text}${this.axis.unit === "°" ? "°" : " " + this.axis.unit}`;
    this.bar.setAttribute("aria-valuetext", said);
    if (this.handle && this.axis.handle) {
      const [cx, cy] = this.axis.handle.map((each) => this.shown.tracks.value(each).toFixed(3));
      setAttributes(this.handle, { cx, cy, "aria-valuenow": text, "aria-valuetext": said });
    }
    this.showEvent();
  }

  showEvent() {
    const { events, high, low } = this.axis;
    const event = events.find((each) => Math.abs(each.value - this.value) < NEAR_EVENT * (high - low));
    const text = event ? spoken(event) : "";
    if (this.events.textContent !== text) this.events.textContent = text;
  }
}

/** The motion that runs by itself: round, or there and back. @param {DriverControl} driver
 * @param {HTMLElement} control the button that says what it would do */
export function runOf(driver, control) {
  const { axis } = driver;
  const [low, last] = knotEnds(axis);
  const high = axis.round ? low + axis.period : last;
  let frame = 0;
  let before = 0;
  let sense = axis.rate < 0 ? -1 : 1;
  const go = (/** @type {number} */ now) => {
    const way = (Math.min(0.1, (now - before) / 1000) * (high - low)) / SECONDS;
    const u = parameterAt(axis, driver.value) + sense * way;
    before = now;
    if (!axis.round && (u > high || u < low)) sense = -sense;
    driver.set(valueAt(axis, axis.round ? u : within(u, low, high)));
    frame = requestAnimationFrame(go);
  };
  const run = (/** @type {boolean} */ on) => {
    cancelAnimationFrame(frame);
    before = performance.now();
    frame = on ? requestAnimationFrame(go) : 0;
    control.dataset.word = on ? "page.pause" : "page.play";
    control.textContent = say(control.dataset.word);
  };
  return { toggle: () => run(!frame), stop: () => run(false) };
}
