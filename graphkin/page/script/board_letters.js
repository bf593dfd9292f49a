/** Names as they are lettered: `a^n_B3D`, `b3'`, with raised and lowered parts. */
import { html } from "./dom.js";
import { svg } from "./svg.js";

/** @typedef {{text: string, place: "" | "low" | "high", italic: boolean}} LetterRun */

/** The runs of a name; what is no name of a vector or a point stands as it is. @param {string} name
 * @returns {LetterRun[]} */
export function letterRuns(name) {
  if (name.includes("+")) {
    return name.split("+").flatMap((half, k) => [...(k ? [letterRun(" + ")] : []), ...letterRuns(half)]);
  }
  const vector = /^([a-z])(?:\^(\w+))?_(.+)$/.exec(name);
  if (vector) {
    const [, letter, part = "", low] = vector;
    const index = low.replaceAll("'", "′").replaceAll("@", "_");
    return [letterRun(letter, "", true), letterRun(part, "high", true), letterRun(index, "low")].filter(isLettered);
  }
  const point = /^([A-Za-z])@?(\d+|(?<=@)\w+|)('*)$/.exec(name);
  if (!point) return [letterRun(name.replaceAll("'", "′"))];
  const [, letter, low, primes] = point;
  return [letterRun(letter, "", true), letterRun(low, "low"), letterRun(primes.replaceAll("'", "′"))].filter(isLettered);
}

/** @param {string} text @param {LetterRun["place"]} [place] @returns {LetterRun} */
function letterRun(text, place = "", italic = false) {
  return { text, place, italic };
}

/** @param {LetterRun} run */
function isLettered({ text }) {
  return text !== "";
}

/** A name in a line of words. @param {LetterRun[]} runs */
export function nameWords(runs) {
  const words = html("span", { class: "name" });
  for (const { text, place, italic } of runs) {
    const letters = italic ? html("i", {}, text) : text;
    words.append(place === "low" ? html("sub", {}, letters) : place === "high" ? html("sup", {}, letters) : letters);
  }
  return words;
}

/** A name on a drawing, so high. @param {string} name
 * @param {{x: number, y: number}} at the left end of its base line, y down @param {number} size */
export function nameOnDrawing(name, at, size) {
  const drawn = svg("text", { x: at.x.toFixed(3), y: at.y.toFixed(3), "font-size": size.toFixed(3), class: "letters" });
  let drop = 0;
  for (const { text, place, italic } of letterRuns(name)) {
    const goal = place === "low" ? 0.28 * size : place === "high" ? -0.38 * size : 0;
    const small = place ? { "font-size": (0.7 * size).toFixed(3) } : {};
    const shift = goal === drop ? {} : { dy: (goal - drop).toFixed(3) };
    drawn.append(svg("tspan", { ...small, ...shift, ...(italic ? { "font-style": "italic" } : {}) }, text));
    drop = goal;
  }
  return drawn;
}

/** About how wide a name is, in parts of its height. @param {string} name */
export function nameWidth(name) {
  return letterRuns(name).reduce((sum, { text, place }) => sum + text.length * (place ? 0.36 : 0.5), 0);
}
