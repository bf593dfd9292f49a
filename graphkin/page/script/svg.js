/** Elements of drawings; one user unit is a millimetre. */
import { setAttributes, takeEvent } from "./dom.js";

/** @import { Attributes } from "./dom.js" */

const SVG = "http://www.w3.org/2000/svg";
export const LETTER_FONT = "Times New Roman, Liberation Serif, Tinos, serif";

/** @template {keyof SVGElementTagNameMap} T @param {T} tag @param {Attributes} [attributes]
 * @param {...(Node | string)} inside @returns {SVGElementTagNameMap[T]} */
export function svg(tag, attributes = {}, ...inside) {
  const element = document.createElementNS(SVG, tag);
  setAttributes(element, attributes);
  element.append(...inside);
  return element;
}

/** The place of a pointer on a drawing [mm]. @param {SVGSVGElement} drawing
 * @param {{clientX: number, clientY: number}} event @returns {{x: number, y: number}} */
export function placeOn(drawing, event) {
  const matrix = drawing.getScreenCTM();
  if (!matrix) return { x: 0, y: 0 };
  const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  return { x: place.x, y: place.y };
}

/** What a hand drags over a drawing, from its press on or from where it moves; then the focus is on the handle.
 * @param {SVGGraphicsElement} grip @param {SVGElement} handle @param {boolean} atOnce
 * @param {(place: {x: number, y: number}) => void} act */
export function dragged(grip, handle, atOnce, act) {
  const follow = (/** @type {PointerEvent} */ event) => {
    const drawing = grip.ownerSVGElement;
    if (drawing && grip.hasPointerCapture(event.pointerId)) act(placeOn(drawing, event));
  };
  grip.addEventListener("pointerdown", (event) => {
    takeEvent(event);
    grip.setPointerCapture(event.pointerId);
    handle.focus({ preventScroll: true });
    if (atOnce) follow(event);
  });
  grip.addEventListener("pointermove", follow);
  grip.addEventListener("touchstart", takeEvent, { passive: false }); // a finger on it scrolls nothing
}
