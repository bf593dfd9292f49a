/** Steps as elements of a drawing, with the classes and data of drawing files; on the board and in the file. */
import { acrossPaper, angleOf, apart, laidOff, nearestOn, toEdge } from "./board_geometry.js";
import { belongsTo, letterAt, letteredPoints, shapeOf, spotOf, stepsOf } from "./board_steps.js";
import { BOARD, lettersOf, work } from "./board_state.js";
import { setAttributes } from "./dom.js";
import { LETTER_FONT, svg } from "./svg.js";

/** @import { Spot } from "./board_geometry.js" */
/** @import { Step } from "./board_state.js" */
/** @import { Sign } from "./signs.js" */

/** Colours of a plane's arrows, as on the sheets. */
export const PLANE_COLOURS = { position: "#1a1a1a", velocity: "#0b4f9c", acceleration: "#a3200d" };

/** How steps are drawn: where the pole is [mm, y down], how long a pixel of the screen is [mm], the size of letters,
 * and how far lines go that have no end.
 * @typedef {{pole: Spot, pixel: number, letters: number, box?: import("./board_geometry.js").Box}} Pen */

/** A place on a drawing, whose y is down. @param {Pen} pen @param {Spot} spot */
function onDrawing(pen, spot) {
  return { x: pen.pole.x + spot.x, y: pen.pole.y - spot.y };
}

/** @param {number} size @returns {string} a millimetre's ten-thousandths, as drawing files have them */
export function decimals(size) {
  return size.toFixed(4);
}

/** @param {Pen} pen @param {Spot} from @param {Spot} to */
function lineEnds(pen, from, to) {
  const [a, b] = [onDrawing(pen, from), onDrawing(pen, to)];
  return { x1: decimals(a.x), y1: decimals(a.y), x2: decimals(b.x), y2: decimals(b.y) };
}

/** All that is drawn on a plane's paper. @param {string} plane @param {Pen} pen @returns {SVGElement[]} */
export function drawnSteps(plane, pen) {
  const steps = stepsOf(plane);
  const lines = steps.filter((step) => step.tool !== "vector" && step.tool !== "point");
  const vectors = steps.filter((step) => step.tool === "vector");
  return [
    ...lines.map((step) => auxiliaryLine(step, pen)),
    ...vectors.flatMap((step) => arrow(step, pen)),
    ...ownPoints(plane).map(({ name, spot }) => pointMark(plane, name, spot, pen)),
    ...steps.filter((step) => step.tool === "point" && !step.name)
      .map((step) => pointMark(plane, "", spotOf(step.at[0]), pen)),
    ...labels(plane, pen),
  ];
}

/** The lettered points that the figure does not show itself. @param {string} plane */
function ownPoints(plane) {
  return letteredPoints(plane).filter(({ name }) => plane !== "position" || !(name in BOARD.given.points));
}

/** @param {Step} step @param {Pen} pen */
function auxiliaryLine(step, pen) {
  const number = work.steps.indexOf(step) + 1 || "";
  const paint = { stroke: "#5a6470", "stroke-width": decimals(pen.pixel), fill: "none" };
  const data = { class: "construction", "data-plane": step.plane, "data-step": number };
  const shape = shapeOf(step);
  if (shape?.kind === "circle") {
    const { x, y } = onDrawing(pen, shape.centre);
    const r = decimals(shape.radius);
    const path = `M${decimals(x - shape.radius)} ${decimals(y)}a${r} ${r} 0 1 1 ${decimals(2 * shape.radius)} 0`
      + `a${r} ${r} 0 1 1 ${decimals(-2 * shape.radius)} 0`;
    return svg("path", { ...data, ...paint, d: path });
  }
  return svg("line", { ...data, ...paint, ...lineEnds(pen, ...endsWithin(step, pen.box)) });
}

/** The ends of a line; of one across the paper where a box ends. @param {Step} step
 * @param {import("./board_geometry.js").Box} [box] @returns {[Spot, Spot]} */
function endsWithin(step, box) {
  const [from, to] = step.at.map(spotOf);
  if (box && step.point) return acrossPaper(spotOf(step.point), angleOf(from, to), box);
  const angle = step.angle ?? 0;
  if (box && step.tool === "protractor") return [from, laidOff(from, angle, toEdge(from, angle, box))];
  return [from, to];
}

/** An arrow from tail to head, and its head apart: the line alone is what is measured. @param {Step} step
 * @param {Pen} pen @returns {SVGElement[]} */
function arrow(step, pen) {
  const colour = PLANE_COLOURS[/** @type {keyof typeof PLANE_COLOURS} */ (step.plane)];
  const [tail, head] = step.at.map(spotOf);
  const line = svg("line", {
    class: "vector", "data-plane": step.plane, "data-name": step.name || null,
    "data-tail": letterAt(step.plane, tail) || null, "data-head": letterAt(step.plane, head) || null,
    "data-step": work.steps.indexOf(step) + 1 || "", ...lineEnds(pen, tail, head),
    stroke: colour, "stroke-width": decimals(2 * pen.pixel),
  });
  const length = apart(tail, head);
  if (length < 1e-6) return [line];
  const size = Math.min(11 * pen.pixel, 0.6 * length);
  const angle = angleOf(tail, head);
  const foot = laidOff(head, angle, -size);
  const corners = [head, laidOff(foot, angle - 90, 0.3 * size), laidOff(foot, angle + 90, 0.3 * size)];
  const points = corners.map((corner) => Object.values(onDrawing(pen, corner)).map(decimals).join(",")).join(" ");
  return [line, svg("polygon", { class: "tip", points, fill: colour })];
}

/** A step that is pointed at, or would be drawn. @param {Step} step @param {Pen} pen @returns {SVGElement[]} */
export function litStep(step, pen) {
  const { x, y } = spotOf(step.at[0]);
  if (!shapeOf(step)) return [svg("circle", { class: "lit", cx: x, cy: -y, r: 5 * pen.pixel })];
  const marks = step.tool === "vector" ? arrow(step, pen) : [auxiliaryLine(step, pen)];
  for (const mark of marks) mark.setAttribute("class", "lit");
  return marks;
}

/** What is read off between two places. @param {Spot} from @param {Spot} to @param {string} words @param {Pen} pen */
export function litReading(from, to, words, pen) {
  const at = { x: to.x + 10 * pen.pixel, y: -to.y - 10 * pen.pixel, "font-size": 14 * pen.pixel };
  return [svg("line", { class: "lit", ...lineEnds(pen, from, to), "stroke-width": pen.pixel }),
    svg("text", { class: "reading", ...at }, words)];
}

/** @param {string} plane @param {string} name @param {Spot} spot @param {Pen} pen */
function pointMark(plane, name, spot, pen) {
  const { x, y } = onDrawing(pen, spot);
  return svg("circle", {
    class: name ? "point" : "mark", "data-plane": plane, "data-name": name || null,
    "data-of": name ? belongsTo(plane, name) : null, cx: decimals(x), cy: decimals(y), r: decimals(2.2 * pen.pixel),
    fill: "#ffffff", stroke: "#111111", "stroke-width": decimals(pen.pixel),
  });
}

const SPREAD = [-0.5, -0.33, -0.17, 0, 0.17, 0.33, 0.5]; // places along a name

/** Names beside what they name, where the least is drawn. @param {string} plane @param {Pen} pen */
function labels(plane, pen) {
  const shapes = stepsOf(plane).map(shapeOf).filter((shape) => shape !== null);
  /** @type {Spot[]} */
  const taken = letteredPoints(plane).map(({ spot }) => spot);
  /** @type {Map<string | Step, {signs: Sign[], about: Spot, off: number}>} by place, or of an arrow */
  const asked = new Map();
  for (const { name, spot } of ownPoints(plane)) {
    const place = `${spot.x.toFixed(1)} ${spot.y.toFixed(1)}`;
    const there = asked.get(place);
    const signs = /** @type {Sign[]} */ ([...(there ? [...there.signs, [", "]] : []), ...lettersOf(name)]);
    asked.set(place, { signs, about: there?.about ?? spot, off: 0.95 });
  }
  for (const step of stepsOf(plane)) {
    if (step.tool !== "vector" || !step.name) continue;
    const [tail, head] = step.at.map(spotOf);
    asked.set(step, { signs: lettersOf(step.name), about: { x: (tail.x + head.x) / 2, y: (tail.y + head.y) / 2 }, off: 1.1 });
  }
  return [...asked.values()].map(({ signs, about, off }) => {
    const [wide, high] = [widthOf(signs) * pen.letters, 0.7 * pen.letters];
    let best = about;
    let most = -Infinity;
    for (let k = 0; k < 48; k++) { // all round, then farther off
      const turn = (k * Math.PI) / 8;
      const away = off * pen.letters * (1 + 0.8 * Math.floor(k / 16));
      const middle = { x: about.x + (away + wide / 2) * Math.cos(turn), y: about.y + away * Math.sin(turn) };
      const corners = SPREAD.map((part) => ({ x: middle.x + part * wide, y: middle.y }));
      const room = Math.min(0.9 * pen.letters, ...corners.flatMap((corner) =>
        [...taken, ...shapes.map((shape) => nearestOn(shape, corner))].map((spot) => apart(spot, corner))));
      if (room > most + 1e-9) [best, most] = [middle, room];
    }
    taken.push(...SPREAD.map((part) => ({ x: best.x + part * wide, y: best.y })));
    const corner = onDrawing(pen, { x: best.x - wide / 2, y: best.y - high / 2 });
    const drawn = lettersOnDrawing(signs, corner, pen.letters);
    setAttributes(drawn, { fill: "#111111", "font-family": LETTER_FONT });
    return drawn;
  });
}

/** About how wide signs are, in parts of their height. @param {Sign[]} signs */
function widthOf(signs) {
  return signs.reduce((sum, [base, , low = "", high = ""]) => sum + 0.5 * base.length + 0.36 * (low + high).length, 0);
}

/** Signs on a drawing, so high. @param {Sign[]} signs @param {Spot} at the left end of their base line, y down
 * @param {number} size */
function lettersOnDrawing(signs, at, size) {
  const drawn = svg("text", { x: at.x.toFixed(3), y: at.y.toFixed(3), "font-size": size.toFixed(3), class: "letters" });
  let drop = 0;
  const add = (/** @type {string} */ text, /** @type {number} */ goal, /** @type {boolean} */ leans) => {
    const shift = goal === drop ? {} : { dy: ((goal - drop) * size).toFixed(3) };
    const small = goal ? { "font-size": (0.7 * size).toFixed(3) } : {};
    if (text) drawn.append(svg("tspan", { ...small, ...shift, ...(leans ? { "font-style": "italic" } : {}) }, text));
    if (text) drop = goal;
  };
  for (const [base, leans, low = "", high = ""] of signs) {
    add(base, 0, Boolean(leans));
    add(high, -0.38, true);
    add(low, 0.28, false);
  }
  return drawn;
}
