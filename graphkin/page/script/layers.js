/** Layers over the playing mechanism: instant centres, curves, centrodes; and diagrams with a cursor beside it. */
import { partOf, setAttributes } from "./dom.js";
import { quantityAt } from "./panels.js";
import { measured } from "./signs.js";
import { parameterAt } from "./state.js";
import { Tracks } from "./tracks.js";

/** @import { Changing } from "./tracks.js" */
/** @import { Shown, ValueData } from "./state.js" */
/** @typedef {{x: Changing, y: Changing, w: Changing, mask?: number}} Centre */
/** @typedef {{x: Changing, y: Changing, cos: Changing, sin: Changing}} Centrode */
/** @typedef {{centres: Centre[], centrodes: Centrode[]}} Layers */

const LAYER_FAR = 1e-4; // a centre with so small a w is far off
const DIAGRAM_SAMPLES = 240;

/** Each switch shows and hides its layer. Gives what moves those that are shown. @param {HTMLElement} element
 * @param {Shown} page */
export function layersOf(element, page) {
  const { overlays, values, axes, tracks, masks } = page.mechanism;
  const [centres, centrodes, diagrams] = [".centre", ".centrode-moving", ".diagram"].map((kind) => [...element.querySelectorAll(kind)]);
  const own = new Tracks(axes, tracks, masks);
  const movers = [
    ...centres.map((mark, k) => ({ mark, move: () => moveCentre(mark, overlays?.centres[k], page.tracks) })),
    ...centrodes.map((mark, k) => ({ mark, move: () => moveCentrode(mark, overlays?.centrodes[k], page.tracks) })),
    ...diagrams.map((mark, k) => ({ mark, move: diagramOf(mark, values[k], page, own) })),
  ];
  const move = () => movers.forEach((each) => each.mark.closest("[hidden]") || each.move());
  element.addEventListener("change", ({ target }) => {
    if (!(target instanceof HTMLInputElement) || !target.dataset.toggle) return;
    const { toggle, of } = target.dataset;
    const shown = `[data-layer="${toggle}"], [data-shown="${toggle}"]${of ? `[data-of="${CSS.escape(of)}"]` : ""}`;
    for (const part of element.querySelectorAll(shown)) part.toggleAttribute("hidden", !target.checked);
    move();
  });
  return move;
}

/** @param {Element} mark @param {Centre | undefined} centre @param {Tracks} tracks */
function moveCentre(mark, centre, tracks) {
  if (!centre) return;
  const [x, y, w] = [centre.x, centre.y, centre.w].map((each) => tracks.value(each, centre.mask));
  const there = w > LAYER_FAR && tracks.isAround(centre.mask);
  setAttributes(mark, { display: there ? null : "none", transform: there ? `translate(${x / w} ${y / w})` : null });
}

/** @param {Element} carried @param {Centrode | undefined} centrode @param {Tracks} tracks */
function moveCentrode(carried, centrode, tracks) {
  if (!centrode) return;
  const [x, y, cos, sin] = [centrode.x, centrode.y, centrode.cos, centrode.sin].map((each) => tracks.value(each));
  setAttributes(carried, { transform: `matrix(${cos} ${sin} ${-sin} ${cos} ${x} ${y})` });
}

/** A quantity over the first driver's way, with a cursor at the position shown. Gives what moves it.
 * @param {Element} figure @param {ValueData} quantity @param {Shown} page @param {Tracks} tracks its own */
function diagramOf(figure, quantity, page, tracks) {
  const { x: [left, wide], y: [foot, high] } = quantity.diagram;
  const [axis, ...others] = page.mechanism.axes;
  const [value, curve, cursor, dot] = ["output", ".diagram-curve", ".diagram-cursor", ".diagram-dot"].map((part) => partOf(figure, part));
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
  return () => {
    const held = `at ${others.map((_, k) => page.values[k + 1])}`;
    if (held !== drawn) draw();
    drawn = held;
    const [place] = page.values;
    const number = at(place);
    const there = Number.isFinite(number);
    value.textContent = measured(number, quantity.unit);
    setAttributes(cursor, { x1: x(place), x2: x(place) });
    setAttributes(dot, { cx: x(place), cy: there ? y(number) : 0, display: there ? null : "none" });
  };
}
