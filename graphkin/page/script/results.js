/** What is asked for, at the place where the drivers are; and the size of the arrow that is pointed at. */
import { html } from "./dom.js";
import { directionOf } from "./numbers.js";
import { measured, printed, signNodes } from "./signs.js";

/** @import { Shown } from "./state.js" */

const UNITS = { velocity: "m/s", acceleration: "m/s²" };

/** The list of results. */
export class ResultsPanel {
  /** @param {Shown} shown */
  constructor(shown) {
    this.shown = shown;
    this.cells = shown.mechanism.values.map((value) => html("td", { "data-result": value.name }));
    const rows = shown.mechanism.values.map((value, k) =>
      html("tr", {}, html("th", { scope: "row" }, ...signNodes(value.sign)), this.cells[k]));
    this.element = html("section", { class: "panel results", "aria-labelledby": "results-heading" },
      html("h2", { id: "results-heading", "data-word": "page.values" }), html("table", {}, html("tbody", {}, ...rows)));
  }

  move() {
    const { tracks, mechanism } = this.shown;
    mechanism.values.forEach((value, k) => {
      const text = tracks.isNear(value.mask) ? measured(quantityAt(value, tracks), value.unit) : "–";
      if (this.cells[k].textContent !== text) this.cells[k].textContent = text;
    });
  }
}

/** A quantity where the tracks are; an angle that turns on and on rises each time the driver comes round.
 * @param {import("./state.js").ValueData} value @param {import("./tracks.js").Tracks} tracks */
export function quantityAt(value, tracks) {
  const [axis] = tracks.axes;
  const turns = axis?.period ? (tracks.us[0] - axis.u[0]) / axis.period : 0;
  const number = tracks.value(value.value, value.mask) + (value.rise ?? 0) * turns;
  return value.size ? Math.abs(number) : number;
}

/** An arrow's size and direction, as words are filled with. @param {SVGLineElement} line @param {number} scale */
export function arrowSize(line, scale) {
  const [x1, y1, x2, y2] = ["x1", "y1", "x2", "y2"].map((name) => Number(line.getAttribute(name)));
  const [x, y] = [x2 - x1, y1 - y2];
  const length = Math.hypot(x, y);
  const plane = line.getAttribute("data-plane") === "velocity" ? "velocity" : "acceleration";
  const angle = directionOf(x, y).toFixed(1);
  return { size: printed(length * scale), unit: UNITS[plane], angle, none: length < 0.02 };
}

