/** Elements of the page. */

/** An element that the page surely has. @param {string} id @returns {HTMLElement} */
export function byId(id) {
  const element = document.getElementById(id);
  if (!element) throw new Error(`no element ${id}`);
  return element;
}

/** The data that the page holds under a name. @param {string} id @returns {any} */
export function heldData(id) {
  return JSON.parse(byId(id).textContent ?? "null");
}

/** Those that are `false` or missing are left out, those that are `true` stand without a value.
 * @typedef {Record<string, string | number | boolean | null | undefined>} Attributes */

/** A new element. @template {keyof HTMLElementTagNameMap} T @param {T} tag @param {Attributes} [attributes]
 * @param {...(Node | string)} inside @returns {HTMLElementTagNameMap[T]} */
export function html(tag, attributes = {}, ...inside) {
  const element = document.createElement(tag);
  setAttributes(element, attributes);
  element.append(...inside);
  return element;
}

/** @param {Element} element @param {Attributes} attributes */
export function setAttributes(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) element.removeAttribute(name);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
}

/** @param {Attributes} attributes @param {() => void} act @param {...(Node | string)} inside */
export function button(attributes, act, ...inside) {
  const element = html("button", { type: "button", ...attributes }, ...inside);
  element.addEventListener("click", act);
  return element;
}

/** A box that is ticked, with words behind it. @param {Attributes} attributes @param {boolean} on
 * @param {(on: boolean) => void} act @param {...Node} words */
export function tickBox(attributes, on, act, ...words) {
  const box = html("input", { type: "checkbox", ...attributes });
  box.checked = on;
  box.addEventListener("change", () => act(box.checked));
  return html("label", {}, box, " ", ...words);
}

/** One of some values is chosen, or none. @param {Attributes} attributes @param {string} none how none is called
 * @param {[value: string, text: string, word?: string][]} choices */
export function choice(attributes, none, choices) {
  const options = choices.map(([value, text, word]) => html("option", { value, "data-word": word }, text));
  return html("select", attributes, html("option", { value: "" }, none), ...options);
}

/** A key that does something here goes no further. @param {Event} event */
export function takeEvent(event) {
  event.preventDefault();
  event.stopPropagation();
}

/** A file that the browser saves. @param {string} name @param {string} text @param {string} type */
export function saveFile(name, text, type) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  html("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}
