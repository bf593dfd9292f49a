/** What was found on photographs, over the photographs: points are dragged, what is right is ticked and saved. */
import { byId, button, heldData, html, saveFile } from "./dom.js";
import { within } from "./numbers.js";
import { dragged, svg } from "./svg.js";
import { fillWords, inEachLanguage, language, say, setLanguage, spoken } from "./words.js";

/** @import { Both } from "./words.js" */
/** A room as it was measured; points in mm from the pole, y up.
 * @typedef {{room: {plane: string, pole: number[], low: number[], high: number[]}, points: Record<string, number[]>,
 * letters: string[], lines: string[][], error: number, confirmed: boolean, crop: string,
 * unsure: {reason: string, letters: string[]}[]}} Room */
/** @typedef {{sheet: {number: number}, picture: string, rooms: Room[]}} Reading */
/** Who has drawn it, and what is unsure in each room. @typedef {{called: string, reasons: Both[][]}} View */

const BY_KEY = 0.1; // of an arrow key [mm]
const BY_HAND = 0.15; // by so much a point that was moved is off [mm]
const [NEARER, NEAREST] = [1.4, 400]; // at each key; at most [%]

/** @type {{name: string, file: string, readings: {list: Reading[]}, views: View[], failed: Both[]}} */
const DATA = heldData("photographs");

class RoomView {
  /** @param {Reading} reading @param {Room} room @param {string} called @param {Both[]} reasons */
  constructor(reading, room, called, reasons) {
    this.room = room;
    this.pole = room.letters[0];
    this.wide = 100;
    const { pole, low, high } = room.room;
    const [x, y, width, height] = [low[0] - pole[0], low[1] - pole[1], high[0] - low[0], high[1] - low[1]];
    this.box = { left: x, right: x + width, low: -y - height, high: -y };
    this.lines = svg("g", { class: "arrows" });
    this.corners = svg("g", {});
    this.paper = svg("svg", { class: "paper", viewBox: `${x} ${y} ${width} ${height}`, width: "100%", role: "group" },
      svg("image", { x, y, width, height, href: room.crop }), this.lines, this.corners);
    this.missing = html("p", {});
    this.tick = html("input", { type: "checkbox" });
    this.tick.addEventListener("change", () => this.confirm(this.tick.checked));
    const tick = html("label", {}, this.tick, " ", html("span", { "data-word": "confirm" }));
    const [heading, told] = [html("h2", {}), html("ul", {}, ...reasons.map(() => html("li", {})))];
    this.element = html("section", {}, heading, html("p", { class: "seen" }, reading.picture), told,
      html("div", { class: "paper-place" }, this.paper), this.missing,
      html("p", {}, tick, " ", button({ "data-word": "empty" }, () => this.take(room.letters.slice(1)))));
    this.element.addEventListener("keydown", (event) => this.zoom(event.key));
    inEachLanguage(() => {
      heading.textContent = say("heading", { called, number: reading.sheet.number, plane: say(room.room.plane) });
      this.paper.setAttribute("aria-label", heading.textContent);
      reasons.forEach((reason, k) => (told.children[k].textContent = spoken(reason)));
      this.draw();
    });
  }

  get isOpen() {
    return this.room.unsure.length > 0 && !this.room.confirmed;
  }

  /** @param {boolean} on */
  confirm(on) {
    this.room.confirmed = on;
    this.draw();
    count();
  }

  /** @param {string} letter @param {number} x @param {number} y */
  move(letter, x, y) {
    const { left, right, low, high } = this.box;
    this.room.points[letter] = [within(x, left, right), within(y, low, high)].map((part) => Number(part.toFixed(3)));
    this.room.error = Math.max(this.room.error, BY_HAND);
    this.confirm(true);
  }

  /** Points that are not there. @param {string[]} letters */
  take(letters) {
    for (const letter of letters) delete this.room.points[letter];
    this.confirm(true);
    this.tick.focus({ preventScroll: true });
  }

  /** @param {string} key */
  zoom(key) {
    const factor = { "+": NEARER, "-": 1 / NEARER }[key];
    if (!factor) return;
    this.wide = within(this.wide * factor, 100, NEAREST);
    this.paper.setAttribute("width", `${this.wide}%`);
  }

  draw() {
    const { points, letters, lines, confirmed } = this.room;
    this.element.className = `room${confirmed ? " confirmed" : this.isOpen ? " look" : ""}`;
    this.tick.checked = confirmed;
    this.lines.replaceChildren(...lines.filter((ends) => ends.every((end) => end in points)).map(([tail, head]) =>
      svg("line", { x1: points[tail][0], y1: -points[tail][1], x2: points[head][0], y2: -points[head][1] })));
    for (const [letter, [x, y]] of Object.entries(points)) {
      const own = this.handle(letter) ?? this.corners.appendChild(this.newHandle(letter));
      const unsure = !confirmed && this.room.unsure.some((one) => !one.letters.length || one.letters.includes(letter));
      own.setAttribute("class", `corner${letter === this.pole ? " pole" : unsure ? " doubtful" : ""}`);
      own.setAttribute("transform", `translate(${x} ${-y})`);
      own.setAttribute("aria-label", say("corner", { letter, x: x.toFixed(1), y: y.toFixed(1) }));
    }
    const away = letters.filter((letter) => !(letter in points));
    for (const letter of away) this.handle(letter)?.remove();
    const puts = away.map((letter) => button({ "data-put": letter, "data-word-label": "put" }, () => this.put(letter), letter));
    this.missing.replaceChildren(...(away.length ? [html("span", { "data-word": "not drawn" }), " ", ...puts] : []));
    fillWords(this.element);
  }

  /** @param {string} letter @returns {SVGGElement | null} */
  handle(letter) {
    return this.corners.querySelector(`[data-letter="${CSS.escape(letter)}"]`);
  }

  /** @param {string} letter */
  newHandle(letter) {
    const grip = svg("circle", { class: "grip", r: 3 });
    const own = svg("g", { tabindex: 0, role: "button", "data-letter": letter }, grip,
      svg("circle", { class: "ring", r: 1.2 }), svg("text", { x: 1.8, y: -1.6 }, letter));
    if (letter === this.pole) return own;
    dragged(grip, own, false, ({ x, y }) => this.move(letter, x, -y));
    own.addEventListener("keydown", (event) => {
      const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      const step = event.shiftKey ? 10 * BY_KEY : BY_KEY;
      if (by) this.move(letter, this.room.points[letter][0] + by[0] * step, this.room.points[letter][1] + by[1] * step);
      else if (event.key === "Delete" || event.key === "Backspace") this.take([letter]);
      else return;
      event.preventDefault();
    });
    return own;
  }

  /** A point that was not found begins in the middle. @param {string} letter */
  put(letter) {
    this.move(letter, (this.box.left + this.box.right) / 2, (this.box.low + this.box.high) / 2);
    this.handle(letter)?.focus();
  }
}

const rooms = DATA.readings.list.flatMap((reading, k) => reading.rooms.map((room, n) =>
  new RoomView(reading, room, DATA.views[k].called, DATA.views[k].reasons[n])));
const only = /** @type {HTMLInputElement} */ (byId("only"));

function count() {
  const open = rooms.filter((room) => room.isOpen).length;
  byId("count").textContent = say("count", { open, all: rooms.length });
}

/** What a teacher has confirmed is sure; no picture goes with it. */
function corrections() {
  const list = DATA.readings.list.map((reading) => ({ ...reading, rooms: reading.rooms.map((room) =>
    ({ ...room, crop: "", unsure: room.confirmed ? [] : room.unsure })) }));
  return JSON.stringify({ ...DATA.readings, list });
}

/** The next room to look at. */
function next() {
  const here = rooms.findIndex((room) => room.element.contains(document.activeElement));
  const ahead = [...rooms.slice(here + 1), ...rooms.slice(0, here + 1)].find((room) => room.isOpen);
  ahead?.element.scrollIntoView();
  ahead?.tick.focus({ preventScroll: true });
}

rooms.sort((a, b) => Number(b.isOpen) - Number(a.isOpen));
byId("rooms").append(...rooms.map((room) => room.element));
byId("failed").hidden = !DATA.failed.length;
byId("reasons").append(...DATA.failed.map(() => html("li", {})));
only.addEventListener("change", () => {
  for (const { element, room } of rooms) element.hidden = only.checked && !room.unsure.length;
});
byId("save").addEventListener("click", () => {
  saveFile(DATA.file, corrections(), "application/json");
  byId("count").textContent = say("saved", { file: DATA.file });
});
byId("language").addEventListener("click", () => setLanguage(language() === "en" ? "zh" : "en"));
document.addEventListener("keydown", (event) => event.key === "n" && next());
inEachLanguage(() => {
  byId("title").textContent = say("title", { name: DATA.name });
  byId("how").textContent = say("how", { file: DATA.file });
  DATA.failed.forEach((reason, k) => (byId("reasons").children[k].textContent = spoken(reason)));
  count();
});
fillWords(document);
