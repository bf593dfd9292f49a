/** The address's hash, `#AB=60&step=7&lang=zh`: what a page shows, so that it can be sent and come back to. */

/** @returns {Map<string, string>} */
export function readHash() {
  return new Map(new URLSearchParams(location.hash.slice(1)));
}

let written = "";

/** Changed without a new entry in the browser's history. A frame without an address of its own keeps none.
 * @param {Map<string, string>} entries */
export function writeHash(entries) {
  written = "#" + new URLSearchParams([...entries]).toString();
  if (written === location.hash || location.protocol === "about:") return;
  try {
    history.replaceState(null, "", written);
  } catch {
    // too many changes in a second: the next one is written
  }
}

/** Do something when somebody else changes the hash. @param {(entries: Map<string, string>) => void} act */
export function onHash(act) {
  addEventListener("hashchange", () => {
    if (location.hash !== written) act(readHash());
  });
}
