/** Elements of the page. */

/** An element that is surely there. @param {ParentNode} within @param {string} selector @returns {any} */
export function partOf(within, selector) {
  const element = within.querySelector(selector);
  if (!element) throw new Error(`no element ${selector}`);
  return element;
}

/** @param {string} id @returns {HTMLElement} */
export function byId(id) {
  return partOf(document, `[id="${id}"]`);
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

/** What the buttons within do, by their `data-action`. @param {Node} within @param {Record<string, () => void>} acts */
export function onActions(within, acts) {
  within.addEventListener("click", (event) => {
    const pressed = /** @type {Element} */ (event.target).closest("[data-action]");
    acts[pressed?.getAttribute("data-action") ?? ""]?.();
  });
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
