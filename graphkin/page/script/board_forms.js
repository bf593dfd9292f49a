/** What is filled in: scales, the rows of the vector equations, the boxes of the answers. */
import { byId, choice, html } from "./dom.js";
import { BOARD, keepWork, onWork, work } from "./board_state.js";
import { numberIn } from "./numbers.js";
import { nameWords } from "./signs.js";
import { labelled, say } from "./words.js";

/** @import { AnswerBox, Choice, FilledTerm, GivenEquation } from "./board_state.js" */

/** A field that holds a part of the work, whatever changes it. @template {HTMLInputElement | HTMLSelectElement} F @param {F} field
 * @param {() => string} read @param {(text: string) => void} store @returns {F} */
function boundField(field, read, store) {
  field.addEventListener("input", () => {
    store(field.value);
    keepWork();
  });
  const fill = () => {
    if (field.value !== read()) field.value = read();
  };
  onWork(fill);
  fill();
  return field;
}

/** A field that holds a text of the work. @template {string} K @param {HTMLInputElement | HTMLSelectElement} field
 * @param {K} key @param {() => Record<K, string> | undefined} part */
function boundTo(field, key, part) {
  return boundField(field, () => part()?.[key] ?? "", (text) => Object.assign(part() ?? {}, { [key]: text }));
}

/** Build all the forms; they follow the work. */
export function buildForms() {
  for (const paper of BOARD.papers) {
    const place = byId(`scale-${paper.plane}`);
    if (paper.plane === "position" && paper.scale) {
      place.append(html("span", {}, `1 mm = ${Number((paper.scale * 1000).toPrecision(6))} mm`));
    } else {
      place.append(html("span", {}, "1 mm = "), scaleField(paper.plane), html("span", {}, ` ${paper.unit}`));
    }
    const equations = BOARD.equations.filter(({ plane }) => plane === paper.plane);
    if (equations.length) byId(`equations-${paper.plane}`).append(...equations.map(equationTable));
  }
  byId("answers").append(...BOARD.answers.map(answerRow));
  const student = byId("student");
  if (student instanceof HTMLInputElement) boundTo(student, "student", () => work);
}

/** @param {string} plane */
function scaleField(plane) {
  const field = html("input", {
    "data-scale": plane, type: "text", inputmode: "decimal", size: 7, "data-word-label": "scale", placeholder: "?",
  });
  return boundField(field, () => String(work.scales[plane] ?? ""), (text) => {
    const scale = numberIn(text) ?? 0;
    work.scales[plane] = scale > 0 ? scale : null;
    field.toggleAttribute("aria-invalid", text !== "" && work.scales[plane] === null);
  });
}

/** A vector equation with a row of directions and a row of magnitudes. @param {GivenEquation} given */
function equationTable(given) {
  const { plane, equation, front, sides } = given;
  const { directions, magnitudes } = BOARD.choices[plane];
  const apartFrom = (/** @type {Node | string} */ words) => [html("td", {}, words), html("td"), html("td")];
  const columns = front.length ? [apartFrom(nameWords(front))] : [];
  sides.forEach((side) => side.forEach(({ term, words }, n) => {
    if (n || columns.length) columns.push(apartFrom(n ? "+" : "="));
    columns.push([
      html("td", { "data-term": term }, nameWords(words)),
      html("td", { "data-term": term }, choiceField(given, term, "direction", directions)),
      html("td", { "data-term": term }, choiceField(given, term, "magnitude", magnitudes)),
    ]);
  }));
  const rows = ["equation", "direction", "magnitude"].map((key, k) =>
    html("tr", {}, html("th", { scope: "row", "data-word": key }), ...columns.map((column) => column[k])));
  const table = html("table", {}, html("tbody", {}, ...rows));
  return html("div", { class: "equation", "data-equation": equation, "data-of-plane": plane }, table);
}

/** @param {GivenEquation} given @param {string} term @param {keyof FilledTerm} row @param {Choice[]} choices */
function choiceField({ plane, equation }, term, row, choices) {
  const data = { [`data-${row}`]: term, "data-term": term };
  const field = choice(data, "", choices.map(({ token, text }) => [token, text]));
  return boundTo(labelled(field, `${row} of`, { term, number: equation }), row, () =>
    work.equations.find((each) => each.plane === plane && each.equation === equation)
      ?.terms.find((each) => each.term === term));
}

/** @param {AnswerBox} box */
function answerRow({ key, words, units, sense }) {
  const value = html("input", {
    "data-answer": key, type: "text", inputmode: sense === "place" ? false : "decimal", size: 10, autocomplete: "off",
    placeholder: sense === "place" && "(x, y)",
  });
  const unit = html("select", { "data-unit": key },
    ...units.map((each) => html("option", { value: each }, each.replace("^2", "²"))));
  const cells = [[nameWords(words), " ="], [answerField(value, key, "value", "answer of")],
    [answerField(unit, key, "unit", "unit of")], senseField(key, sense)];
  return html("tr", {}, ...cells.map((inside) => html("td", {}, ...inside)));
}

/** @param {HTMLInputElement | HTMLSelectElement} field @param {string} key @param {"value" | "unit" | "sense"} part
 * @param {string} label */
function answerField(field, key, part, label) {
  return boundTo(labelled(field, label, { key }), part, () => work.answers[key]);
}

/** The sense of a rotation, or the direction of a vector to +x. @param {string} key @param {string} sense */
function senseField(key, sense) {
  if (sense === "turns") {
    const ways = choice({ "data-sense": key }, "", [
      ["counter-clockwise", "", "counter-clockwise"], ["clockwise", "", "clockwise"],
    ]);
    return [answerField(ways, key, "sense", "sense of")];
  }
  if (sense !== "directed") return [];
  const angle = html("input", { "data-sense": key, type: "text", inputmode: "decimal", size: 6, autocomplete: "off" });
  return ["∠ ", answerField(angle, key, "sense", "angle of"), " °"];
}

/** What is still empty, by what it is called. @returns {string[]} */
export function emptyFields() {
  const scales = Object.entries(work.scales).filter(([, scale]) => !scale)
    .map(([plane]) => `${say("scale")} (${say(plane)})`);
  const equations = work.equations
    .filter(({ terms }) => terms.some(({ direction, magnitude }) => !direction || !magnitude))
    .map(({ plane, equation }) => say("equation number", { number: equation, plane: say(plane) }));
  const answers = Object.entries(work.answers).filter(([, { value }]) => !value.trim()).map(([key]) => key);
  return [...scales, ...equations, ...answers];
}
