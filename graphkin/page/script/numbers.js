/** Numbers kept within bounds, turns, and those that a person writes. */

/** @param {number} value @param {number} low @param {number} high */
export function within(value, low, high) {
  return Math.min(Math.max(value, low), high);
}

/** What is left of a value beyond whole turns, never below 0. @param {number} value @param {number} turn */
export function modulo(value, turn) {
  return value - turn * Math.floor(value / turn);
}

/** The angle of a direction, from +x to +y, 0 to 360 [deg]. @param {number} x @param {number} y */
export function directionOf(x, y) {
  return modulo((Math.atan2(y, x) * 180) / Math.PI, 360);
}

/** A number as a person writes it, or null. @param {string} text */
export function numberIn(text) {
  const plain = text.trim().replace(",", ".").replace("−", "-");
  return plain && Number.isFinite(Number(plain)) ? Number(plain) : null;
}
