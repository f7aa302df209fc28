"use strict";
// What a page of the course can do beyond being read: questions before figures, figures alone on the screen, slides.

const cells = [...document.querySelectorAll(".cell")];

// ---- The answer to a question, its figure and its words, opens when the reader has chosen one.

const question = document.querySelector(".predict");
const answers = [...document.querySelectorAll("details.answer")];
const options = [...(question?.querySelectorAll("ul > li") ?? [])];
for (const option of options) {
  const button = document.createElement("button");
  button.type = "button";
  button.setAttribute("aria-pressed", "false");
  button.append(...option.childNodes);
  option.append(button);
  button.addEventListener("click", () => {
    for (const other of options) other.firstChild.setAttribute("aria-pressed", String(other === option));
    for (const answer of answers) answer.open = true;
  });
}
for (const answer of answers) {
  answer.querySelector("summary").addEventListener("click", (event) => {
    if (!options.length || question.querySelector("[aria-pressed=true]")) return;
    event.preventDefault();
    question.scrollIntoView({ block: "center" });
  });
}

// ---- Paper shows everything; browsers that know ::details-content need no script for it.

let unfolded = [];
addEventListener("beforeprint", () => {
  unfolded = [...document.querySelectorAll("main details:not([open])")];
  for (const details of unfolded) details.open = true;
});
addEventListener("afterprint", () => {
  for (const details of unfolded) details.open = false;
});

// ---- A click shows a picture alone on the screen.

const dialog = document.createElement("dialog");
dialog.className = "zoom";
document.body.append(dialog);
dialog.addEventListener("click", () => dialog.close());
for (const image of document.querySelectorAll("figure.picture img")) {
  image.tabIndex = 0;
  image.setAttribute("role", "button");
  const enlarge = () => {
    const copy = document.createElement("img");
    copy.src = image.src;
    copy.alt = image.alt;
    dialog.replaceChildren(copy);
    dialog.showModal();
  };
  image.addEventListener("click", enlarge);
  image.addEventListener("keydown", (event) => {
    if (event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      enlarge();
    }
  });
}

// ---- Slides: one cell a screen, with the arrow keys.

const start = document.querySelector("button.slides");
if (cells.length) {
  const place = document.createElement("span");
  place.className = "place";
  start.before(place);
  start.hidden = false;
  let current = 0;
  const show = (number) => {
    current = Math.max(0, Math.min(cells.length - 1, number));
    cells.forEach((cell, k) => cell.classList.toggle("current", k === current));
    place.textContent = `${current + 1} / ${cells.length}`;
  };
  const toggle = (on) => {
    if (on) show(Math.max(0, cells.findIndex((cell) => cell.getBoundingClientRect().bottom > 80)));
    document.body.classList.toggle("showing", on);
    start.textContent = on ? "Page" : "Slides";
    if (!on) cells[current].scrollIntoView();
    history.replaceState(null, "", on ? "#slides" : location.pathname.split("/").pop());
  };
  start.addEventListener("click", () => toggle(!document.body.classList.contains("showing")));
  document.addEventListener("keydown", (event) => {
    const inside = event.target instanceof Element && event.target.closest("glsim-compare, glsim-live, input, select, textarea, dialog");
    if (!document.body.classList.contains("showing") || inside || event.altKey || event.ctrlKey || event.metaKey) return;
    const steps = { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1 };
    if (event.key in steps) show(current + steps[event.key]);
    else if (event.key === "Home") show(0);
    else if (event.key === "End") show(cells.length - 1);
    else if (event.key === "Escape") toggle(false);
    else return;
    event.preventDefault();
  });
  if (location.hash === "#slides") toggle(true);
}

// ---- The table of contents closes with Escape and with a click elsewhere.

const contents = document.querySelector(".contents");
document.addEventListener("click", (event) => {
  if (contents && !contents.contains(event.target)) contents.open = false;
});
contents?.addEventListener("keydown", (event) => {
  if (event.key === "Escape") contents.open = false;
});
