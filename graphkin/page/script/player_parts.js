/** The quiz and the layers of a mechanism on the page, and what they need of it. */
import { parameterAt } from "./axes.js";
import { DiagramPart } from "./diagram.js";
import { html } from "./dom.js";
import { LayersPart } from "./layers.js";
import { QuizPart } from "./quiz.js";
import { quantityAt } from "./results.js";
import { Tracks } from "./tracks.js";

/** @import { Player } from "./player.js" */

/** @param {Player} player */
export function addParts(player) {
  const { overlays, quiz, values } = player.shown.mechanism;
  const add = (/** @type {string} */ place, /** @type {Element} */ part) => player.element.querySelector(place)?.append(part);
  if (overlays) {
    const diagrams = values.map((value) => new DiagramPart(value, diagramHost(player)));
    const part = new LayersPart(overlays, diagrams, player.figures[0], player.shown);
    add(".panel.layers", part.element);
    add(".figures", part.figures);
  }
  if (quiz?.questions.length) {
    add(".panels", html("div", { class: "panel" }, new QuizPart(quiz, quizHost(player, quiz.at)).element));
  }
}

/** @param {Player} player @returns {import("./diagram.js").DiagramHost} */
function diagramHost({ shown }) {
  const [axis] = shown.mechanism.axes;
  const tracks = new Tracks([axis], shown.mechanism.tracks, shown.mechanism.masks);
  return {
    axis,
    now: () => shown.values[0] * axis.factor,
    quantity(value, place) {
      tracks.moveTo([parameterAt(axis, place / axis.factor)]);
      return tracks.isAround(value.mask) ? quantityAt(value, tracks) : NaN;
    },
  };
}

/** @param {Player} player @param {number[]} at @returns {import("./quiz.js").QuizHost} */
function quizHost(player, at) {
  const figure = (/** @type {string} */ plane) => player.figures.find((each) => each.plane.plane === plane);
  return {
    showUpTo(act) {
      const quizzing = act !== null;
      player.quizzing = quizzing;
      player.element.classList.toggle("quizzing", quizzing);
      player.run?.stop();
      if (!quizzing) return player.goStep(player.shown.step);
      player.shown.values = [...at];
      player.move();
      // the mechanism is given; half of the first act is nothing of it
      for (const each of player.figures) each.showStep(each.plane.plane === "position" ? 0 : act || 0.5);
      return undefined;
    },
    look: (plane) => figure(plane)?.drawing.parentElement?.scrollIntoView({ block: "nearest", inline: "start" }),
    drawing: (plane) => figure(plane)?.drawing ?? null,
    place(plane, name) {
      const point = figure(plane)?.drawing.querySelector(`circle.point[data-name="${CSS.escape(name)}"]`);
      return point ? { x: Number(point.getAttribute("cx")), y: Number(point.getAttribute("cy")) } : null;
    },
  };
}
