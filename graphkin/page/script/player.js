/** The page: figures, bars, steps and results of the mechanism that is shown; language, hash, contents. */
import { byId, heldData, html, onActions, partOf, setAttributes } from "./dom.js";
import { DriverControl, runOf } from "./drivers.js";
import { PlaneFigure } from "./figure.js";
import { layersOf } from "./layers.js";
import { numberIn } from "./numbers.js";
import { arrowSize, showResults, StepsPanel } from "./panels.js";
import { QuizPart } from "./quiz.js";
import { signNodes } from "./signs.js";
import { Shown } from "./state.js";
import { fillWords, inEachLanguage, language, say, setLanguage, spoken, typeset } from "./words.js";

/** @import { Mechanism } from "./state.js" */

/** @type {Mechanism[]} */
const MECHANISMS = heldData("mechanisms");

/** A mechanism on the page. */
export class Player {
  /** @param {Mechanism} mechanism */
  constructor(mechanism) {
    const [element] = /** @type {HTMLElement[]} */ (typeset(mechanism.stage));
    this.element = element;
    this.shown = new Shown(mechanism);
    this.figures = mechanism.planes.map((plane) => new PlaneFigure(this.shown, plane, partOf(element, `.figure.${plane.plane}`)));
    this.steps = new StepsPanel(this.shown, partOf(element, ".steps"));
    this.drivers = [...element.querySelectorAll(".driver")].map((bar, k) =>
      new DriverControl(this.shown, k, /** @type {HTMLElement} */ (bar), (values) => this.goTo(values)));
    this.run = runOf(this.drivers[0], partOf(element, ".run"));
    this.told = partOf(element, ".told");
    this.asked = 0;
    this.figures[0].drawing.append(...this.drivers.flatMap(({ handle }) => handle ?? []));
    this.moveLayers = layersOf(element, this.shown);
    this.quizzing = false;
    const quiz = mechanism.quiz.questions.length ? new QuizPart(mechanism.quiz, this, partOf(element, ".quiz")).acts : {};
    onActions(element, {
      back: () => this.goStep(this.steps.before()), next: () => this.goStep(this.steps.after()), whole: () => this.goStep(0),
      run: this.run.toggle, ...quiz,
    });
    fillWords(element);
    this.pointing();
    this.light(null);
    this.move();
    this.goStep(0);
  }

  /** Its acts up to one at the position of the quiz; all, as the page was, at the end. @param {number | null} act */
  showUpTo(act) {
    this.quizzing = act !== null;
    this.element.classList.toggle("quizzing", this.quizzing);
    this.run.stop();
    if (act === null) return this.goStep(this.shown.step);
    this.shown.values = [...this.shown.mechanism.quiz.at];
    this.move();
    // the mechanism is given; half of the first act is nothing of it
    for (const each of this.figures) each.showStep(each.plane.plane === "position" ? 0 : act || 0.5);
    return undefined;
  }

  /** @param {string | undefined} plane */
  figureOf(plane) {
    return this.figures.find((each) => each.plane.plane === plane) ?? this.figures[0];
  }

  /** @param {number[]} values */
  goTo(values) {
    this.shown.values = values;
    this.asked ||= requestAnimationFrame(() => {
      this.asked = 0;
      this.move();
      keepHash();
    });
  }

  /** Everything where the drivers are now. */
  move() {
    const { shown } = this;
    for (const tracks of [shown.tracks, shown.words]) tracks.moveTo(shown.parameters());
    for (const each of this.figures) each.move();
    for (const driver of this.drivers) driver.show();
    showResults(shown, this.element.querySelectorAll("[data-result]"));
    if (shown.step) this.steps.show();
    this.moveLayers();
  }

  /** @param {number} step */
  goStep(step) {
    this.shown.step = step > 0 ? this.steps.numbers.find((told) => told >= step) ?? this.steps.count : 0;
    for (const figure of this.figures) figure.showStep(this.shown.step);
    this.element.classList.toggle("by-step", this.shown.step > 0);
    this.showPlane(this.shown.mechanism.steps.find((each) => each.step === this.shown.step)?.plane);
    this.steps.show();
    keepHash();
  }

  /** On a phone one polygon is seen at a time: that of the step. @param {string | undefined} plane */
  showPlane(plane) {
    const { section } = this.figureOf(plane);
    const track = section.closest(".polygons");
    if (track) track.scrollLeft = section.offsetLeft - /** @type {HTMLElement} */ (track.firstElementChild).offsetLeft;
  }

  /** Arrows and the words that name them light up together. */
  pointing() {
    for (const kind of ["pointerover", "focusin"]) {
      this.element.addEventListener(kind, (event) => {
        const target = /** @type {Element | null} */ (event.target)?.closest?.("[data-vector]");
        this.light(target?.getAttribute("data-vector") ?? null);
      });
    }
  }

  /** @param {string | null} name */
  light(name) {
    let line = null;
    for (const element of this.element.querySelectorAll("[data-vector]")) {
      const own = element.getAttribute("data-vector");
      const also = element.querySelector("line.vector")?.getAttribute("data-also")?.split(" ") ?? [];
      const lit = name !== null && (own === name || also.includes(name));
      element.classList.toggle("lit", lit);
      if (lit && element instanceof SVGElement) line = /** @type {SVGLineElement | null} */ (element.querySelector("line.vector"));
    }
    const figure = this.figures.find((each) => line && each.drawing.contains(line));
    this.told.replaceChildren(say("page.point"));
    this.told.removeAttribute("data-told");
    if (!line || !figure) return;
    const { size, unit, angle, none } = arrowSize(line, figure.plane.scale);
    const row = figure.pieces.find((piece) => piece.element === line)?.row;
    const [before = "", after = ""] = say(none ? "page.nothing" : "page.size", { name: "\0", size, unit, angle }).split("\0");
    const sentence = this.sentenceOf(row?.step);
    this.told.replaceChildren(before, ...signNodes(row?.sign ?? []), after, ...(sentence ? [html("br"), sentence] : []));
    this.told.setAttribute("data-told", line.getAttribute("aria-label"));
  }

  /** @param {number | undefined} step */
  sentenceOf(step) {
    const own = this.shown.mechanism.steps.find((each) => each.step === step);
    if (!own) return null;
    const sentence = this.steps.entries(own[language()]).find((node) => node.hasAttribute("data-step-sentence"));
    return sentence ? html("span", { class: "of-step" }, ...sentence.childNodes) : null;
  }
}

/** @type {Player | null} */
let player = null;
let written = ""; // as the hash, or read there

function goToHash() {
  written = location.hash;
  const entries = new URLSearchParams(written.slice(1));
  const lang = entries.get("lang");
  if (lang && lang !== language()) setLanguage(lang);
  const chosen = MECHANISMS.find((each) => each.name === entries.get("show")) ?? player?.shown.mechanism ?? MECHANISMS[0];
  if (!chosen) return;
  if (player?.shown.mechanism !== chosen) showMechanism(chosen);
  const now = /** @type {Player} */ (/** @type {unknown} */ (player));
  for (const driver of now.drivers) {
    const value = numberIn(entries.get(driver.axis.name) ?? "");
    if (value !== null) driver.set(value / driver.axis.factor);
  }
  now.move();
  now.goStep(Number(entries.get("step") ?? 0));
}

/** The hash, `#AB=60&step=7&lang=zh`, is what the page shows, without a new entry in the browser's history. A frame
 * without an address of its own keeps none. */
function keepHash() {
  if (!player || location.hash !== written || location.protocol === "about:") return; // a new one is to be read first
  const entries = new URLSearchParams();
  if (MECHANISMS.length > 1) entries.set("show", player.shown.mechanism.name);
  for (const driver of player.drivers) {
    entries.set(driver.axis.name, String(Math.round(driver.value * driver.axis.factor * 1e4) / 1e4));
  }
  if (player.shown.step) entries.set("step", String(player.shown.step));
  entries.set("lang", language());
  try {
    history.replaceState(null, "", `#${entries}`);
  } catch {
    // too many changes in a second: the next one is written
  }
  written = location.hash;
}

/** @param {Mechanism} mechanism */
function showMechanism(mechanism) {
  player?.run.stop();
  player = null;
  const made = new Player(mechanism);
  player = made;
  byId("page").replaceChildren(made.element);
  showTitle(mechanism);
  for (const link of document.querySelectorAll("#contents [data-show]")) {
    setAttributes(link, { "aria-current": link.getAttribute("data-show") === mechanism.name && "page" });
  }
}

/** @param {Mechanism} mechanism */
function showTitle({ title }) {
  byId("title").textContent = document.title = spoken(title);
}

/** @param {KeyboardEvent} event */
function onKey(event) {
  const target = /** @type {Element | null} */ (event.target);
  if (!player || player.quizzing || event.altKey || event.ctrlKey || event.metaKey) return;
  if (target?.closest("input, select, summary") && !["PageUp", "PageDown"].includes(event.key)) return;
  if (event.key === " " && target?.closest("button, a")) return;
  const { run, steps, drivers } = player;
  const step = { PageDown: steps.after(), PageUp: steps.before(), Home: 0 }[event.key];
  if (step === undefined && event.key !== " ") return drivers[0]?.key(event);
  event.preventDefault();
  if (step === undefined) run.toggle();
  else player.goStep(step);
}

function startPage() {
  goToHash();
  onActions(partOf(document, "header"), {
    print,
    language() {
      setLanguage(language() === "zh" ? "en" : "zh");
      keepHash();
    },
  });
  fillWords(document);
  inEachLanguage(() => {
    if (!player) return;
    showTitle(player.shown.mechanism);
    player.drivers.forEach((driver) => driver.showEvent());
    player.steps.show();
    player.light(null);
  });
  addEventListener("hashchange", () => {
    if (location.hash !== written) goToHash();
  });
  addEventListener("keydown", onKey);
}

startPage();
