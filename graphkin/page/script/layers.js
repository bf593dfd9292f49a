/** Layers over the playing mechanism: instant centres, curves, centrodes; and diagrams with a cursor beside it. */
import { html, setAttributes, tickBox } from "./dom.js";
import { quantityAt } from "./panels.js";
import { measured, signNodes } from "./signs.js";
import { parameterAt } from "./state.js";
import { svg } from "./svg.js";
import { Tracks } from "./tracks.js";
import { inEachLanguage, say, typeset } from "./words.js";

/** @import { Changing } from "./tracks.js" */
/** @import { Shown, ValueData } from "./state.js" */
/** @typedef {{name: string, x: Changing, y: Changing, w: Changing, mask?: number, frame: boolean}} Centre */
/** @typedef {{name: string, label: string, pieces: string[]}} Curve */
/** @typedef {{link: string, name: string, fixed: string[], moving: string[], x: Changing, y: Changing, cos: Changing,
 * sin: Changing}} Centrode */
/** @typedef {{centres: Centre[], curves: Curve[], centrodes: Centrode[]}} Layers */

const LAYER_FAR = 1e-4; // a centre with so small a w is far off
const DIAGRAM_SAMPLES = 240;

/** Switches, and what they show. */
export class LayersPart {
  /** @param {Layers | undefined} layers @param {import("./figure.js").PlaneFigure} figure of the mechanism
   * @param {Shown} page */
  constructor(layers, figure, page) {
    this.tracks = page.tracks;
    this.element = html("div", { class: "overlays" });
    /** @type {(() => void)[]} */
    this.moves = [];
    this.group = svg("g", { class: "layers-drawn" });
    this.figures = html("div", { class: "diagrams" });
    figure.figure.append(this.group);
    if (layers?.centres.length) this.addCentres(layers.centres);
    for (const curve of layers?.curves ?? []) this.addCurve(curve);
    for (const centrode of layers?.centrodes ?? []) this.addCentrode(centrode);
    if (page.mechanism.values.length) this.addDiagrams(page);
    page.onMove.push(() => this.moves.forEach((move) => move()));
  }

  /** A switch and what it shows, which moves while it is on. @param {string} kind @param {string} name
   * @param {() => Node[]} words @param {Element} shown @param {() => void} [move] */
  add(kind, name, words, shown, move = () => {}) {
    let isOn = false;
    const spoken = html("span");
    const box = tickBox({ "data-toggle": kind, "data-of": name || null }, isOn, (on) => {
      isOn = on;
      setAttributes(shown, { hidden: !on, display: on ? null : "none" });
      if (on) move();
    }, spoken);
    inEachLanguage(() => spoken.replaceChildren(...words()));
    setAttributes(shown, { hidden: true, display: "none" });
    (shown instanceof SVGElement ? this.group : this.figures).append(shown);
    this.element.append(box);
    this.moves.push(() => isOn && move());
  }

  /** @param {Centre[]} centres */
  addCentres(centres) {
    const marks = centres.map((centre) => {
      const mark = svg("g", { class: centre.frame ? "centre centre-frame" : "centre", "data-name": centre.name },
        svg("circle", { r: 1 }), svg("text", { x: 1.6, y: -1.2 }, "P", svg("tspan", { dy: 0.8, class: "low" }, centre.name.slice(1))));
      return { centre, mark };
    });
    const group = svg("g", { "data-shown": "centres" }, ...marks.map(({ mark }) => mark));
    this.add("centres", "", () => typeset(say("layers.centres")), group, () => {
      for (const { centre, mark } of marks) {
        const [x, y, w] = [centre.x, centre.y, centre.w].map((each) => this.tracks.value(each, centre.mask));
        const there = w > LAYER_FAR && this.tracks.isAround(centre.mask);
        setAttributes(mark, { display: there ? null : "none", transform: there ? `translate(${x / w} ${y / w})` : null });
      }
    });
  }

  /** @param {Curve} curve */
  addCurve(curve) {
    const group = svg("g", { class: "curve", "data-shown": "curve", "data-of": curve.name },
      ...curve.pieces.map((d) => svg("path", { d })));
    this.add("curve", curve.name, () => typeset(say("layers.curve", { name: curve.label })), group);
  }

  /** @param {Centrode} centrode */
  addCentrode(centrode) {
    const carried = svg("g", { class: "centrode-moving" }, ...centrode.moving.map((d) => svg("path", { d })));
    const fixed = svg("g", { class: "centrode-fixed" }, ...centrode.fixed.map((d) => svg("path", { d })));
    const group = svg("g", { "data-shown": "centrode", "data-of": centrode.link }, fixed, carried);
    const words = () => typeset(say("layers.centrode", { name: centrode.link }));
    this.add("centrode", centrode.link, words, group, () => {
      const [x, y, cos, sin] = [centrode.x, centrode.y, centrode.cos, centrode.sin].map((each) => this.tracks.value(each));
      setAttributes(carried, { transform: `matrix(${cos} ${sin} ${-sin} ${cos} ${x} ${y})` });
    });
  }

  /** @param {Shown} page */
  addDiagrams(page) {
    const tracks = new Tracks(page.mechanism.axes, page.mechanism.tracks, page.mechanism.masks);
    const diagrams = page.mechanism.values.map((value) => diagramOf(value, page, tracks));
    const group = html("div", { "data-shown": "diagrams" }, ...diagrams.map(({ element }) => element));
    this.add("diagrams", "", () => typeset(say("layers.diagrams")), group, () => diagrams.forEach(({ move }) => move()));
  }
}

/** A quantity over the first driver's way, with a cursor at the position shown. @param {ValueData} quantity
 * @param {Shown} page @param {Tracks} tracks its own */
function diagramOf(quantity, page, tracks) {
  const { drawing, x: [left, wide], y: [foot, high] } = quantity.diagram;
  const [axis, ...others] = page.mechanism.axes;
  const value = html("output");
  const curve = svg("path", { class: "diagram-curve" });
  const cursor = svg("line", { class: "diagram-cursor", y1: 3, y2: 44 });
  const dot = svg("circle", { class: "diagram-dot", r: 1.2 });
  const [picture] = /** @type {SVGSVGElement[]} */ (typeset(drawing));
  picture.append(curve, cursor, dot);
  const caption = html("figcaption", {}, ...signNodes(quantity.sign), " = ", value);
  const x = (/** @type {number} */ place) => (left + wide * place * axis.factor).toFixed(2);
  const y = (/** @type {number} */ number) => (foot + high * number).toFixed(2);
  const at = (/** @type {number} */ place) => {
    const [, ...rest] = page.parameters();
    tracks.moveTo([parameterAt(axis, place), ...rest]);
    return tracks.isAround(quantity.mask) ? quantityAt(quantity, tracks) : NaN;
  };
  const draw = () => {
    const [first, last] = axis.ends;
    const step = (last - first) / DIAGRAM_SAMPLES;
    let path = "";
    for (let k = 0, on = false; k <= DIAGRAM_SAMPLES; k++) {
      const place = first + step * k;
      const number = at(k < DIAGRAM_SAMPLES ? place : place - 1e-6 * step); // the end of a turn is not its beginning
      if (Number.isFinite(number)) path += `${on ? "L" : "M"}${x(place)} ${y(number)}`;
      on = Number.isFinite(number);
    }
    curve.setAttribute("d", path);
  };
  let drawn = "";
  return {
    element: html("figure", { class: "diagram", "data-diagram": quantity.name }, caption, picture),
    move() {
      const held = `at ${others.map((_, k) => page.values[k + 1])}`;
      if (held !== drawn) draw();
      drawn = held;
      const [place] = page.values;
      const number = at(place);
      const there = Number.isFinite(number);
      value.textContent = there ? measured(number, quantity.unit) : "–";
      setAttributes(cursor, { x1: x(place), x2: x(place) });
      setAttributes(dot, { cx: x(place), cy: there ? y(number) : 0, display: there ? null : "none" });
    },
  };
}
