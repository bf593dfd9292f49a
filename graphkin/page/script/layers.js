/** Layers over the playing mechanism: instant centres, curves, centrodes; and diagrams with a cursor beside it. */
import { html, setAttributes, tickBox } from "./dom.js";
import { svg } from "./svg.js";
import { inEachLanguage, say, typeset } from "./words.js";

/** @import { Changing } from "./tracks.js" */
/** @typedef {{name: string, x: Changing, y: Changing, w: Changing, mask?: number, frame: boolean}} Centre */
/** @typedef {{name: string, label: string, pieces: string[]}} Curve */
/** @typedef {{link: string, name: string, fixed: string[], moving: string[], x: Changing, y: Changing, cos: Changing,
 * sin: Changing}} Centrode */
/** @typedef {{centres: Centre[], curves: Curve[], centrodes: Centrode[]}} Layers */
/** @typedef {{kind: string, name: string, words: () => Node[], on: boolean, shown: Element,
 * move: () => void}} Switch */

const LAYER_FAR = 1e-4; // a centre with so small a w is far off

/** Switches, and what they show. */
export class LayersPart {
  /** @param {Layers} layers @param {import("./diagram.js").DiagramPart[]} diagrams
   * @param {import("./figure.js").PlaneFigure} figure of the mechanism @param {import("./state.js").Shown} page */
  constructor(layers, diagrams, figure, page) {
    this.tracks = page.tracks;
    this.element = html("div", { class: "overlays" });
    /** @type {Switch[]} */
    this.switches = [];
    this.group = svg("g", { class: "layers-drawn" });
    this.figures = html("div", { class: "diagrams" });
    figure.figure.append(this.group);
    if (layers.centres.length) this.addCentres(layers.centres);
    for (const curve of layers.curves) this.addCurve(curve);
    for (const centrode of layers.centrodes) this.addCentrode(centrode);
    if (diagrams.length) this.addDiagrams(diagrams);
    inEachLanguage(() => this.draw());
    page.onMove.push(() => this.move());
  }

  draw() {
    const boxes = this.switches.map((one) =>
      tickBox({ "data-toggle": one.kind, "data-of": one.name || null }, one.on, (on) => {
        one.on = on;
        setAttributes(one.shown, { hidden: !on, display: on ? null : "none" });
        this.move();
      }, ...one.words()));
    this.element.replaceChildren(...boxes);
  }

  move() {
    for (const one of this.switches) if (one.on) one.move();
  }

  /** @param {string} kind @param {string} name @param {() => Node[]} words @param {Element} shown
   * @param {() => void} [move] */
  add(kind, name, words, shown, move = () => {}) {
    setAttributes(shown, { hidden: true, display: "none" });
    (shown instanceof SVGElement ? this.group : this.figures).append(shown);
    this.switches.push({ kind, name, words, on: false, shown, move });
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

  /** @param {import("./diagram.js").DiagramPart[]} diagrams */
  addDiagrams(diagrams) {
    const group = html("div", { "data-shown": "diagrams" }, ...diagrams.map(({ element }) => element));
    this.add("diagrams", "", () => typeset(say("layers.diagrams")), group, () => diagrams.forEach((one) => one.move()));
  }
}
