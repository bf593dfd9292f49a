/** Labels, sentences and numbers in print. */
import { html } from "./dom.js";
import { modulo } from "./numbers.js";

/** @typedef {[string, number?, string?, string?, string?]} Sign letters, leaning, below, above, the vector they name */

const DIGITS = 4;
const EXACT = 3e-6;
const MOST_ZEROS = 1e9;

/** Four significant digits, as the sentences have them. @param {number} value */
export function printed(value) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const short = Number(value.toPrecision(DIGITS - 1)); // zeros at the end are kept, but of what is exact without
  let text = Math.abs(short - value) <= EXACT * Math.abs(value) ? String(short) : value.toPrecision(DIGITS);
  if (text.includes("e") && Math.abs(value) < MOST_ZEROS && Math.abs(value) >= 1) text = String(Number(text));
  else if (text.includes("e")) text = text.replace(/e\+?(-?)0*(\d+)/, "e$1$2");
  return text.replaceAll("-", "−");
}

/** A number with its unit, where there is one; an angle within a turn. @param {number} value @param {string} unit */
export function measured(value, unit) {
  if (!Number.isFinite(value)) return printed(value);
  return unit === "°" ? `${printed(modulo(value, 360))}°` : printed(value) + (unit && ` ${unit}`);
}

/** @param {Sign[]} signs @param {(text: string) => string} [filled] the text with its numbers @returns {Node[]} */
export function signNodes(signs, filled = (text) => text) {
  return signs.map(([base, leans, low, high, vector]) => {
    const text = filled(base);
    if (!leans && !low && !high) return document.createTextNode(text);
    const letter = leans ? html("i", {}, text) : text;
    if (!low && !high) return /** @type {Node} */ (letter);
    const term = html("span", { class: vector ? "sign term" : "sign", "data-vector": vector ?? null });
    if (vector) term.tabIndex = 0;
    term.append(letter);
    const scripts = [...(high ? [html("sup", {}, filled(high))] : []), ...(low ? [html("sub", {}, filled(low))] : [])];
    term.append(...(low && high ? [html("span", { class: "scripts" }, ...scripts)] : scripts));
    return term;
  });
}
