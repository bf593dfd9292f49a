/** The words of the page in both languages, of which one is shown. All come from its data: `{key: {en, zh}}`. */
import { heldData } from "./dom.js";

/** @typedef {"en" | "zh"} Lang */
/** @typedef {Record<Lang, string>} Both */

/** @type {Record<string, Both>} */
const WORDS = heldData("words");
/** @type {Lang} */
let shown = document.documentElement.lang.startsWith("zh") ? "zh" : "en";
/** @type {(() => void)[]} */
const followers = [];

/** @returns {Lang} */
export function language() {
  return shown;
}

/** @param {string} key @param {Record<string, string | number | undefined>} [values] what stands in for `{name}` */
export function say(key, values = {}) {
  const words = WORDS[key];
  if (!words) throw new Error(`no words ${key}`);
  return words[shown].replace(/\{(\w+)\}/g, (_, name) => String(values[name] ?? ""));
}

/** What is said in the language shown. @param {Both} both @returns {string} */
export function spoken(both) {
  return both[shown];
}

/** Do something now and whenever the language changes. @param {() => void} act */
export function inEachLanguage(act) {
  followers.push(act);
  act();
}

/** @param {string} lang */
export function setLanguage(lang) {
  if (lang !== "en" && lang !== "zh") return;
  shown = lang;
  document.documentElement.lang = lang === "zh" ? "zh-CN" : "en";
  fillWords(document);
  for (const act of followers) act();
}

/** The words of all elements that bear `data-word` (their text) or `data-word-label` (their name for a screen reader),
 * with their own data in them. @param {ParentNode} within */
export function fillWords(within) {
  for (const element of /** @type {NodeListOf<HTMLElement>} */ (within.querySelectorAll("[data-word], [data-word-label]"))) {
    const { word, wordLabel } = element.dataset;
    if (word) element.textContent = say(word, element.dataset);
    else if (wordLabel) element.title = element.ariaLabel = say(wordLabel, element.dataset);
  }
}

/** Words with formulas in them, which stand in the page's data as HTML. @param {string} words @returns {Node[]} */
export function typeset(words) {
  return [...new DOMParser().parseFromString(words, "text/html").body.childNodes];
}
