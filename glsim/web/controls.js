const VIEWS = { picture: "Picture", swipe: "Swipe", difference: "Difference", side: "Side by side" };
const GAINS = [1, 2, 4, 8, 16, 32, 64];

const CONTROLS = `
<div class="head"></div>
<div class="print"><slot></slot></div>
<div class="ui">
  <div class="bar">
    <fieldset class="pictures"><legend>Picture</legend></fieldset>
    <fieldset class="views"><legend>View</legend></fieldset>
    <select class="gain" aria-label="Amplification of the difference"></select>
    <div class="zoom">
      <button data-zoom="out" aria-label="Zoom out" title="Zoom out (−)">−</button><output></output
      ><button data-zoom="in" aria-label="Zoom in" title="Zoom in (+)">+</button>
      <button data-zoom="fit" title="Fit (F)">Fit</button><button data-zoom="full" title="100 % (0)">100 %</button>
    </div>
  </div>
  <div class="columns">
    <div class="main">
      <div class="captions"></div>
      <div class="stage" tabindex="0" role="application">
        <canvas role="img"></canvas>
        <div class="divider" role="slider" tabindex="0" aria-label="Divider" aria-valuemin="0" aria-valuemax="100"></div>
        <p class="message"></p>
      </div>
    </div>
    <div class="side">
      <table class="values" aria-label="Values of the pixel"></table>
      <div class="equation" hidden><h4></h4><pre tabindex="0"></pre></div>
      <div class="metrics"></div>
    </div>
  </div>
  <p class="help keys"><span><kbd>1</kbd>–<kbd>9</kbd> picture</span> <span><kbd>Space</kbd> the one before</span>
    <span><kbd>P</kbd> <kbd>S</kbd> <kbd>D</kbd> <kbd>A</kbd> view</span>
    <span><kbd>,</kbd> <kbd>.</kbd> divider, amplification</span>
    <span><kbd>+</kbd> <kbd>−</kbd> or wheel: zoom</span> <span><kbd>F</kbd> fit</span> <span><kbd>0</kbd> 100 %</span>
    <span><kbd>←</kbd> <kbd>↑</kbd> or drag: pan</span> <span><kbd>Shift</kbd> <kbd>←</kbd> or click: pixel</span></p>
  <p class="help touch">Drag to pan, pinch to zoom, tap a pixel for its values.</p>
</div>`;

/** A group of radio buttons: the browser's own arrow keys choose in it.
 * @param {HTMLElement} group @param {string} name @param {string[]} labels @param {string} keys  a letter for each */
function fillChoices(group, name, labels, keys) {
  labels.forEach((label, index) => {
    const choice = document.createElement("label"), input = document.createElement("input");
    const words = document.createElement("span"), text = document.createElement("bdi");
    Object.assign(input, { type: "radio", name, value: String(index) });
    if (keys[index]) words.append(Object.assign(document.createElement("kbd"), { textContent: keys[index] }));
    text.append(...typeset(label)); // one item of the row, with its indices
    words.append(text);
    choice.append(input, words);
    group.append(choice);
  });
}

/**
 * What is read off a pixel: a row for each picture and, for two pictures, their difference, the second minus the first.
 * @param {HTMLElement} table @param {Point?} pixel @param {{name: string, pixels: Pixels}[]} pictures
 */
function fillValues(table, pixel, pictures) {
  const values = pictures.map(({ pixels }) => (pixel ? valuesAt(pixels, pixel) : []));
  const signed = (/** @type {number} */ d) => (d > 0 ? `+${d}` : d < 0 ? `−${-d}` : "0");
  const four = (/** @type {(channel: number) => string | undefined} */ text) => [0, 1, 2, 3].map((c) => text(c) ?? "–");
  const row = (/** @type {string} */ name, /** @type {string[]} */ cells, /** @type {string} */ kind) => {
    const tr = document.createElement("tr"), head = document.createElement("th");
    head.scope = kind === "th" ? "col" : "row";
    head.append(...typeset(name));
    tr.append(head, ...cells.map((textContent) => Object.assign(document.createElement(kind), { textContent })));
    return tr;
  };
  const rows = pictures.map(({ name }, index) => {
    const tr = row(name, four((c) => values[index][c]?.toString()), "td"), swatch = document.createElement("i");
    if (values[index].length) swatch.style.background = `rgb(${values[index].slice(0, 3)})`;
    tr.cells[0].prepend(swatch);
    return tr;
  });
  const [a, b] = values;
  if (pictures.length === 2)
    rows.push(row("Difference", four((c) => (a.length && b.length ? signed(b[c] - a[c]) : undefined)), "td"));
  table.replaceChildren(row(pixel ? `(${pixel.x}, ${pixel.y})` : "Pixel", [..."RGBA"], "th"), ...rows);
}

/** The equation nearest to a pixel, null if it is farther than the points are from each other.
 * @param {[number, number, string][]} equations @param {Point} pixel */
function nearest(equations, { x, y }) {
  const step = (/** @type {0 | 1} */ axis) => {
    const places = [...new Set(equations.map((equation) => equation[axis]))].sort((a, b) => a - b);
    return Math.min(...places.slice(1).map((place, index) => place - places[index]));
  };
  const far = (/** @type {[number, number, string]} */ [px, py]) => Math.hypot(px - x, py - y);
  const best = equations.reduce((a, b) => (a && far(a) <= far(b) ? a : b), /** @type {any} */ (null));
  const reach = [step(0), step(1)].filter(Number.isFinite);
  const most = reach.length ? Math.max(...reach) : 32;
  return best && Math.abs(best[0] - x) <= most && Math.abs(best[1] - y) <= most ? best : null;
}
