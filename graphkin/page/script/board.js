/** The drawing board: a problem, papers, tools, rows of equations, boxes for answers; handed in as one file. */
import { boardFileName, openBoard, saveBoard } from "./board_file.js";
import { bindForms, emptyFields } from "./board_forms.js";
import {
  erase, nameStep, papers, setTool, showFields, takeBack, takeLine, tell, tool, toolField,
} from "./board_hand.js";
import { BOARD, lettersOf, onWork, paperOf, recallWork, takeUp, work, WORK_PLACE } from "./board_state.js";
import { letteredPoints, lineWords, stepsOf, stepWords } from "./board_steps.js";
import { allLines } from "./board_tools.js";
import { button, byId, html } from "./dom.js";
import { signNodes } from "./signs.js";
import { svg } from "./svg.js";
import { fillWords, inEachLanguage, language, say, setLanguage } from "./words.js";

function showSteps() {
  for (const { plane } of BOARD.papers) {
    byId(`steps-${plane}`).replaceChildren(...stepsOf(plane).map((step) => {
      const label = say("erase this", { step: stepWords(step) });
      return html("li", { value: work.steps.indexOf(step) + 1 }, stepWords(step), " ",
        button({ class: "small", "aria-label": label }, () => erase(step), "×"));
    }));
  }
  const chosen = toolField("line").value;
  toolField("line").replaceChildren(html("option", { value: "" }, "—"),
    ...allLines().map(({ name }) => html("option", { value: name }, lineWords(name))));
  toolField("line").value = chosen;
  const offered = BOARD.papers.flatMap(({ plane, points, vectors }) => {
    const taken = [...letteredPoints(plane), ...stepsOf(plane)].map(({ name }) => name);
    return [...points.map((name) => ({ name, kind: "point" })), ...vectors.map((name) => ({ name, kind: "vector" }))]
      .filter(({ name }) => !taken.includes(name));
  });
  byId("offers").replaceChildren(...offered.map(({ name, kind }) =>
    button({ class: `offer ${kind}`, "data-offer": name }, () => {
      toolField("name").value = name;
      nameStep(name);
    }, html("span", { class: "name" }, ...signNodes(lettersOf(name))))));
}

/** @param {string} key */
function act(key) {
  if (key === "hand-in") {
    const empty = emptyFields();
    const name = saveBoard(".svg", figure);
    if (empty.length) tell("handed in, empty", { name, empty: empty.join(", ") });
    else tell("handed in", { name });
  } else if (key === "save") tell("saved", { name: saveBoard(".work.svg", figure) });
  else if (key === "open") byId("file").click();
  else if (key === "anew" && confirm(say("really anew"))) takeUp({});
  else if (key === "language") setLanguage(language() === "en" ? "zh" : "en");
}

/** @param {string} data @param {(value: string) => void} pressed */
function onEach(data, pressed) {
  for (const one of document.querySelectorAll(`[${data}]`)) {
    one.addEventListener("click", () => pressed(one.getAttribute(data) ?? ""));
  }
}

function listen() {
  onEach("data-tool", (name) => (name === "undo" ? takeBack() : setTool(name)));
  onEach("data-action", act);
  onEach("data-zoom", (words) => {
    const [plane, factor] = words.split(" ");
    papers.find((paper) => paper.plane === plane)?.zoom(Number(factor));
  });
  toolField("name").addEventListener("keydown", (event) => {
    if (event instanceof KeyboardEvent && event.key === "Enter") nameStep(toolField("name").value.trim());
  });
  toolField("line").addEventListener("change", () => takeLine(toolField("line").value));
  toolField("kind").addEventListener("change", showFields);
  byId("student").addEventListener("input", showFileName);
  byId("file").addEventListener("change", async (event) => {
    const field = /** @type {HTMLInputElement} */ (event.target);
    const file = field.files?.[0];
    if (file) tell(openBoard(await file.text()), { name: file.name });
    field.value = "";
  });
  addEventListener("keydown", (event) => {
    const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
    if (!typing && (event.ctrlKey || event.metaKey) && event.key === "z") {
      event.preventDefault();
      takeBack();
    }
  });
  addEventListener("storage", ({ key }) => key === WORK_PLACE && recallWork()); // drawn in another tab
  addEventListener("beforeprint", () => papers.forEach((paper) => paper.printed()));
  addEventListener("afterprint", () => papers.forEach((paper) => paper.onScreen()));
}

function showFileName() {
  byId("file-name").textContent = boardFileName(".svg");
}

/** The figure lies on the paper of the mechanism, if it is drawn where the problem is. */
function layFigure() {
  const corner = BOARD.given.corner;
  const given = byId("figure").querySelector("svg");
  const paper = papers.find(({ plane }) => plane === "position");
  if (!corner || !given || !paper) return null;
  byId("figure").hidden = true;
  given.remove();
  const group = svg("g", { class: "given", transform: `translate(${-corner[0]} ${-corner[1]})` });
  for (const child of given.children) if (child.tagName !== "title") group.append(child.cloneNode(true));
  paper.element.insertBefore(group, paper.drawn);
  return given;
}

const figure = layFigure();
bindForms();
onWork(() => papers.forEach((paper) => paper.draw()));
onWork(showSteps);
onWork(showFileName);
recallWork();
fillWords(document);
inEachLanguage(() => {
  showSteps();
  for (const { plane, element } of papers) {
    element.setAttribute("aria-label", say("paper", { plane: say(plane), pole: paperOf(plane).pole }));
  }
  document.title = `${BOARD.title[language()]} · ${say("board")}`;
  byId("said").textContent = say(`hint ${tool}`);
});
listen();
setTool("line");
showFileName();
