/** What is filled in: scales, the rows of the vector equations, the boxes of the answers. */
import { BOARD, keepWork, onWork, work } from "./board_state.js";
import { numberIn } from "./numbers.js";
import { say } from "./words.js";

/** A field that holds a part of the work, whatever changes it. @param {HTMLInputElement} field
 * @param {() => string} read @param {(text: string) => void} store */
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
}

/** All fields that bear some data hold a text of the work. @template {string} K @param {string} data @param {K} key
 * @param {(own: DOMStringMap) => Record<K, string> | undefined} part of the work, by a field's data */
function bindFields(data, key, part) {
  for (const field of /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll(`[data-${data}]`))) {
    const own = () => part(field.dataset);
    boundField(field, () => own()?.[key] ?? "", (text) => Object.assign(own() ?? {}, { [key]: text }));
  }
}

/** All the forms follow the work. */
export function bindForms() {
  bindFields("field=student", "student", () => work);
  bindFields("answer", "value", ({ key = "" }) => work.answers[key]);
  for (const part of /** @type {const} */ (["unit", "sense"])) bindFields(part, part, ({ key = "" }) => work.answers[key]);
  for (const row of /** @type {const} */ (["direction", "magnitude"])) {
    bindFields(row, row, ({ ofPlane, number, term }) =>
      work.equations.find(({ plane, equation }) => plane === ofPlane && equation === Number(number))
        ?.terms.find((each) => each.term === term));
  }
  for (const { plane } of BOARD.papers) {
    /** @type {HTMLInputElement | null} */
    const field = document.querySelector(`[data-scale="${plane}"]`);
    if (field) boundField(field, () => String(work.scales[plane] ?? ""), (text) => setScale(plane, field, text));
  }
}

/** @param {string} plane @param {HTMLInputElement} field @param {string} text */
function setScale(plane, field, text) {
  const scale = numberIn(text) ?? 0;
  work.scales[plane] = scale > 0 ? scale : null;
  field.toggleAttribute("aria-invalid", text !== "" && work.scales[plane] === null);
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
