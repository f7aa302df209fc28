/**
 * <glsim-compare>: pictures that swap in place.  page.py writes its children: a heading and notes, a <figure> for each
 * picture, a <table> of metrics, and JSON with names, captions and equations.  The figures stay for printing.
 * @typedef {{name: string, caption: string, equations: [number, number, string][]}} PictureData
 * @typedef {{title: string, reference: number, pictures: PictureData[]}} StripData
 */

const VIEWS = { picture: "Picture", swipe: "Swipe", difference: "Difference", side: "Side by side" };
const VIEW_KEYS = { p: "picture", s: "swipe", d: "difference", a: "side" };
const GAINS = [1, 2, 4, 8, 16, 32, 64];
const SCALES = [1 / 8, 1 / 4, 1 / 2, 1, 1.5, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];
const LABEL = 34; // CSS pixels above each picture side by side

/** @type {Set<GlsimCompare>} */
const near = new Set(); // elements on the screen or close to it: only they hold pixels
/** @type {GlsimCompare?} */
let active = null; // the element that was touched last: keys go to it when nothing has the focus
let scrolled = 0; // when the page was scrolled last
const style = new CSSStyleSheet();
style.replaceSync(CSS);
const watch = new IntersectionObserver(
  (entries) => entries.forEach(({ target, isIntersecting }) => /** @type {any} */ (target).approach(isIntersecting)),
  { rootMargin: "50%" },
);
const resize = new ResizeObserver((entries) => entries.forEach(({ target }) =>
  /** @type {any} */ (/** @type {ShadowRoot} */ (target.getRootNode()).host).draw()));

const CONTROLS = `
<div class="head"></div>
<div class="ui">
  <div class="bar">
    <fieldset class="pictures"><legend>Picture</legend></fieldset>
    <fieldset class="views"><legend>View</legend></fieldset>
    <label class="gain">amplified <select></select></label>
    <div class="zoom">
      <button data-zoom="out" aria-label="Zoom out" title="Zoom out (−)">−</button><output></output
      ><button data-zoom="in" aria-label="Zoom in" title="Zoom in (+)">+</button>
      <button data-zoom="fit" title="Fit (F)">Fit</button><button data-zoom="full" title="100 % (0)">100 %</button>
    </div>
  </div>
  <div class="columns">
    <div class="main">
      <p class="caption"></p>
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
  <p class="help keys"><kbd>1</kbd>–<kbd>9</kbd> picture <kbd>Space</kbd> the one before
    <kbd>P</kbd> <kbd>S</kbd> <kbd>D</kbd> <kbd>A</kbd> view <kbd>,</kbd> <kbd>.</kbd> divider, amplification
    <kbd>+</kbd> <kbd>−</kbd> wheel: zoom <kbd>F</kbd> fit <kbd>0</kbd> 100 % <kbd>←</kbd> <kbd>↑</kbd> drag: pan
    <kbd>Shift</kbd> <kbd>←</kbd> click: pixel</p>
  <p class="help touch">Drag to pan, pinch to zoom, tap a pixel for its values.</p>
</div>
<div class="print"><slot></slot></div>`;

class GlsimCompare extends HTMLElement {
  connectedCallback() {
    if (!("DecompressionStream" in window)) return; // an old browser: the figures as they are
    if (document.readyState === "loading" && !this.shadowRoot)
      document.addEventListener("DOMContentLoaded", () => this.connectedCallback(), { once: true });
    else if (this.isConnected) {
      if (!this.shadowRoot) this.build();
      watch.observe(this);
    }
  }

  disconnectedCallback() {
    watch.unobserve(this);
    this.approach(false);
  }

  /** Controls once; pixels come when the element is near. */
  build() {
    /** @type {StripData} */
    this.data = JSON.parse(this.querySelector("script")?.textContent || "");
    this.images = [...this.querySelectorAll("img")];
    const root = this.attachShadow({ mode: "open" });
    root.adoptedStyleSheets = [style];
    root.innerHTML = CONTROLS;
    /** @param {string} name @returns {any} */
    this.$ = (name) => root.querySelector(name);
    this.$(".head").append(...this.querySelectorAll(":scope > h2, :scope > h3, :scope > p"));
    this.$(".metrics").append(/** @type {Node} */ (this.querySelector("table")));

    const { pictures, reference } = this.data;
    this.pictures = pictures;
    this.reference = reference;
    this.current = 0;
    this.before = pictures.length > 1 ? 1 : 0; // the picture that Space goes back to
    this.view = "picture";
    this.gain = 8;
    this.divider = 0.5;
    /** @type {{hover: Point?, mark: Point?, point: Point?}} */
    this.marks = { hover: null, mark: null, point: null };
    /** @type {Pixels[]} */
    this.pixels = [];
    /** @type {Map<number | string, HTMLCanvasElement>} */
    this.canvases = new Map();
    const largest = (/** @type {"width" | "height"} */ side) => Math.max(...this.images.map((image) => image[side]));
    this.stage = new Stage(this.$("canvas"), {
      width: Math.max(...this.images.map((image) => Number(image.getAttribute("width")))),
      height: Math.max(...this.images.map((image) => Number(image.getAttribute("height")))),
    });
    this.$(".stage").style.aspectRatio = `${this.stage.size.width} / ${this.stage.size.height}`;
    this.$(".ui").classList.toggle("single", pictures.length < 2);
    this.fill();
    this.listen();
    this.update();
  }

  /** The choices: names of pictures, views, amplifications. */
  fill() {
    const choose = (/** @type {string} */ group, /** @type {string[]} */ labels, /** @type {string[]} */ keys) =>
      labels.forEach((label, index) => {
        const choice = document.createElement("label"), input = document.createElement("input");
        Object.assign(input, { type: "radio", name: group, value: String(index) });
        const words = document.createElement("span");
        if (keys[index]) words.append(Object.assign(document.createElement("kbd"), { textContent: keys[index] }));
        words.append(label);
        choice.append(input, words);
        this.$(`.${group}`).append(choice);
      });
    choose("pictures", this.pictures.map(({ name }) => name), [..."123456789"]);
    choose("views", Object.values(VIEWS), [..."PSDA"]);
    for (const gain of GAINS) this.$("select").add(new Option(`× ${gain}`, String(gain)));
  }

  listen() {
    const stage = this.$(".stage"), root = /** @type {ShadowRoot} */ (this.shadowRoot);
    root.addEventListener("change", (event) => {
      const input = /** @type {HTMLInputElement} */ (event.target);
      if (input.name === "pictures") this.show(Number(input.value));
      else if (input.name === "views") this.look(Object.keys(VIEWS)[Number(input.value)]);
      else this.set({ gain: Number(input.value) });
    });
    root.addEventListener("click", (event) => {
      const how = /** @type {HTMLElement} */ (event.target).dataset.zoom;
      if (how) this.zoom(how);
    });
    this.addEventListener("pointerenter", () => (active = this));
    this.addEventListener("focusin", () => (active = this));
    this.addEventListener("keydown", (event) => {
      if (event.defaultPrevented || !this.key(event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    stage.addEventListener("wheel", (/** @type {WheelEvent} */ event) => this.wheel(event), { passive: false });
    this.hands = new Hands(this);
    resize.observe(this.$("canvas"));
  }

  /** Come near: decode the pictures and draw.  Go away: give their memory back.  @param {boolean} isNear */
  async approach(isNear) {
    if (!isNear) {
      near.delete(this);
      if (active === this) active = null;
      this.pixels = [];
      this.canvases?.clear();
      if (this.shadowRoot) Object.assign(this.$("canvas"), { width: 0, height: 0 });
      return;
    }
    near.add(this);
    const pixels = await Promise.all(this.images.map((image) => decodePNG(image.src)));
    if (!near.has(this)) return;
    this.pixels = pixels;
    this.update();
  }

  /** @param {Partial<{current: number, before: number, view: string, gain: number, divider: number}>} changes */
  set(changes) {
    Object.assign(this, changes);
    this.update();
  }

  /** @param {number} index  of the picture to show in place of the present one */
  show(index) {
    if (index < this.pictures.length && index !== this.current) this.set({ before: this.current, current: index });
  }

  /** @param {string} view  of VIEWS; the reference against itself shows nothing, so another picture comes instead */
  look(view) {
    if (this.pictures.length < 2) return;
    if ((view === "swipe" || view === "difference") && this.current === this.reference)
      this.show(this.before !== this.reference ? this.before : this.reference ? 0 : 1);
    this.set({ view });
  }

  /** @param {string} how  "in", "out", "fit" or "full" */
  zoom(how) {
    const { box, clip } = this.stage.panels[0], { scale } = this.stage.place(box);
    const centre = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    if (how === "fit") Object.assign(view, { scale: 0, x: 0.5, y: 0.5 });
    else {
      const next = how === "in" ? SCALES.find((step) => step > 1.01 * scale) : SCALES.findLast((step) => step < scale / 1.01);
      this.stage.zoomTo(how === "full" ? 1 : next || scale, centre);
    }
    redraw();
  }

  /** @param {WheelEvent} event  zooms; the page scrolls on where a scroll has only come across, or all is seen */
  wheel(event) {
    const point = this.pointOf(event), { box } = this.stage.panelAt(point), { scale } = this.stage.place(box);
    const fit = this.stage.fit(box), factor = Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.002));
    if (!event.ctrlKey && (performance.now() - scrolled < 300 || (factor < 1 && scale <= fit))) return;
    event.preventDefault();
    if (scale * factor <= fit && scale > fit) return this.zoom("fit");
    this.stage.zoomTo(scale * factor, point);
    redraw();
  }

  /** @param {{clientX: number, clientY: number}} event */
  pointOf({ clientX, clientY }) {
    const { left, top } = this.$("canvas").getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  /** What a key does; false if it is none of ours.  @param {KeyboardEvent} event */
  key(event) {
    const target = /** @type {HTMLElement} */ (event.composedPath()[0]);
    if (event.ctrlKey || event.metaKey || event.altKey || target.localName === "select") return false;
    const key = event.key.toLowerCase(), onStage = target === this.$(".stage"), onDivider = target === this.$(".divider");
    const [dx, dy] = { arrowleft: [-1, 0], arrowright: [1, 0], arrowup: [0, -1], arrowdown: [0, 1] }[key] || [0, 0];
    if (/^[1-9]$/.test(key)) this.show(Number(key) - 1);
    else if (key in VIEW_KEYS) this.look(VIEW_KEYS[/** @type {keyof typeof VIEW_KEYS} */ (key)]);
    else if (key === "+" || key === "=") this.zoom("in");
    else if (key === "-") this.zoom("out");
    else if (key === "f") this.zoom("fit");
    else if (key === "0") this.zoom("full");
    else if (key === "," || key === ".") this.step(key === "." ? 1 : -1);
    else if (onDivider && (dx || dy)) this.slide(this.divider + (dx - dy) * 0.02);
    else if (onStage && key === " ") this.show(this.before);
    else if (onStage && event.shiftKey && (dx || dy)) this.mark(this.beside(dx, dy));
    else if (onStage && (dx || dy)) this.stage.pan(-60 * dx, -60 * dy), redraw();
    else if (onStage && key === "enter") this.mark(this.beside(0, 0));
    else if (onStage && key === "escape" && this.marks.mark) this.mark(null);
    else return false;
    return true;
  }

  /** One step of what the view has: the divider, or the amplification.  @param {number} sign */
  step(sign) {
    if (this.view === "swipe") this.slide(this.divider + 0.02 * sign);
    else this.set({ gain: GAINS[clamp(GAINS.indexOf(this.gain) + sign, 0, GAINS.length - 1)] });
  }

  /** @param {number} divider  share of the stage's width */
  slide(divider) {
    this.set({ divider: clamp(divider, 0, 1) });
  }

  /** The pixel beside the marked one; at first the pixel in the middle of the stage.
   * @param {number} dx @param {number} dy @returns {Point?} */
  beside(dx, dy) {
    const { box } = this.stage.panels[0], { width, height } = this.stage.size;
    const middle = this.stage.pixelAt({ x: box.x + box.width / 2, y: box.y + box.height / 2 });
    const from = this.marks.mark || middle;
    return from && { x: clamp(from.x + dx, 0, width - 1), y: clamp(from.y + dy, 0, height - 1) };
  }

  /** Mark a pixel, show its values and the nearest equation.  @param {Point?} mark */
  mark(mark) {
    this.marks.mark = mark;
    this.marks.hover = null;
    this.update();
  }

  /** What is seen changed: the controls say so, then it is drawn. */
  update() {
    const { name, caption } = this.pictures[this.current], reference = this.pictures[this.reference].name;
    const words = {
      picture: [name, caption],
      swipe: [`${reference}  |  ${name}`, caption],
      difference: [`| ${name} − ${reference} |`, `${this.gain} times amplified`],
      side: ["Side by side", ""],
    }[this.view] || [];
    this.$(".caption").replaceChildren(Object.assign(document.createElement("b"), { textContent: words[0] }), " " + words[1]);
    this.$("canvas").setAttribute("aria-label", `${this.data?.title}: ${words.join(" ")}`);
    this.$(".stage").setAttribute("aria-label", `${this.data?.title}: arrows pan, Shift and arrows choose a pixel`);
    this.$(`.pictures input[value="${this.current}"]`).checked = true;
    this.$(`.views input[value="${Object.keys(VIEWS).indexOf(this.view)}"]`).checked = true;
    this.$("select").value = String(this.gain);
    this.$(".ui").dataset.view = this.view;
    this.$(".divider").style.left = `${100 * this.divider}%`;
    this.$(".divider").ariaValueNow = String(Math.round(100 * this.divider));
    this.$(".metrics").querySelectorAll("tbody tr").forEach((/** @type {HTMLElement} */ row, /** @type {number} */ index) =>
      row.classList.toggle("current", index === this.current));
    this.equation();
    this.draw();
  }

  /** The equation of the point nearest to the marked pixel, if one is within the points' grid. */
  equation() {
    const { mark } = this.marks, { name, equations } = this.pictures[this.current];
    const found = mark && nearest(equations, mark);
    this.marks.point = found && { x: found[0], y: found[1] };
    this.$(".equation").hidden = !mark || !this.pictures.some((picture) => picture.equations.length);
    if (!mark) return;
    this.$(".equation h4").textContent = found ? `${name} at (${found[0]}, ${found[1]})` : name;
    this.$(".equation pre").textContent = found ? found[2] : "There is no equation near this pixel.";
  }

  draw() {
    if (!this.pixels.length || !this.isConnected) return;
    const panels = this.panels(), colour = getComputedStyle(this);
    const [ink, paper, accent] = ["--ink", "--paper", "--accent"].map((name) => colour.getPropertyValue(name));
    this.$(".message").textContent = panels.length ? "" : this.sizes();
    if (!panels.length) panels.push({ ...this.panel(this.current), clip: { x: 0, y: 0, width: 0, height: 0 } });
    this.stage.draw(panels, { ink, paper, accent }, this.marks);
    this.$(".zoom output").textContent = `${Math.round(100 * this.stage.place(panels[0].box).scale)} %`;
    this.$("[data-zoom=fit]").setAttribute("aria-pressed", String(!view.scale));
    this.$(".stage").classList.toggle("zoomed", Boolean(view.scale));
    this.readout();
  }

  /** @returns {Panel[]}  none if the view cannot be made of these pictures */
  panels() {
    const { clientWidth: width, clientHeight: height } = this.$("canvas"), { current, reference } = this;
    if (this.view === "swipe") {
      const x = Math.round(this.divider * width);
      return [
        { ...this.panel(reference), clip: { x: 0, y: 0, width: x, height }, label: this.pictures[reference].name },
        { ...this.panel(current), clip: { x, y: 0, width: width - x, height }, label: this.pictures[current].name },
      ];
    }
    if (this.view === "difference") {
      const [a, b] = [this.pixels[reference], this.pixels[current]];
      if (a.width !== b.width || a.height !== b.height) return [];
      const key = `${current} ${this.gain}`, pixels = differenceOf(a, b, this.gain);
      if (!this.canvases.has(key)) this.canvases.set(key, imageOf(pixels));
      return [{ ...this.panel(current), image: /** @type {HTMLCanvasElement} */ (this.canvases.get(key)), pixels }];
    }
    if (this.view === "side") return this.grid(width, height);
    return [this.panel(current)];
  }

  /** A picture on the whole stage.  @param {number} index @returns {Panel} */
  panel(index) {
    const { clientWidth: width, clientHeight: height } = this.$("canvas"), box = { x: 0, y: 0, width, height };
    if (!this.canvases.has(index)) this.canvases.set(index, imageOf(this.pixels[index]));
    return { box, clip: box, image: /** @type {HTMLCanvasElement} */ (this.canvases.get(index)), pixels: this.pixels[index] };
  }

  /** All pictures, in as many columns as make them largest.  @param {number} width @param {number} height */
  grid(width, height) {
    const count = this.pictures.length, { size } = this.stage, gap = 8;
    const cell = (/** @type {number} */ columns) => ({
      width: (width - gap * (columns - 1)) / columns,
      height: height / Math.ceil(count / columns) - LABEL,
    });
    const scale = (/** @type {number} */ columns) =>
      Math.min(cell(columns).width / size.width, cell(columns).height / size.height);
    const columns = this.pictures.map((_, index) => index + 1).reduce((best, next) => (scale(next) > scale(best) ? next : best));
    const { width: w, height: h } = cell(columns);
    return this.pictures.map(({ name }, index) => {
      const top = Math.floor(index / columns) * (h + LABEL);
      const box = { x: (index % columns) * (w + gap), y: top + LABEL, width: w, height: h };
      return { ...this.panel(index), box, clip: box, label: name, labelTop: top + 5 };
    });
  }

  sizes() {
    const size = (/** @type {number} */ index) => `${this.pixels[index].width} × ${this.pixels[index].height}`;
    return `The sizes differ: ${size(this.reference)} and ${size(this.current)}.`;
  }

  /** The values of the pixel under the pointer, or of the marked one. */
  readout() {
    const pixel = this.marks.hover || this.marks.mark, { current, reference } = this;
    const shown = this.view === "side" ? this.pictures.map((_, index) => index) : [...new Set([reference, current])];
    const rows = [["", pixel ? `(${pixel.x}, ${pixel.y})` : "Pixel", "R", "G", "B", "A"]];
    for (const index of shown) {
      const values = pixel ? valuesAt(this.pixels[index], pixel) : [];
      rows.push([`rgb(${values.slice(0, 3)})`, this.pictures[index].name, ...[0, 1, 2, 3].map((c) => String(values[c] ?? "–"))]);
    }
    if (current !== reference) {
      const [a, b] = [reference, current].map((index) => (pixel ? valuesAt(this.pixels[index], pixel) : []));
      const signed = (/** @type {number} */ d) => (d > 0 ? `+${d}` : d < 0 ? `−${-d}` : "0");
      rows.push(["", "Difference", ...[0, 1, 2, 3].map((c) => (a.length && b.length ? signed(b[c] - a[c]) : "–"))]);
    }
    this.$(".values").replaceChildren(...rows.map(([swatch, name, ...cells], number) => {
      const row = document.createElement("tr");
      const head = Object.assign(document.createElement("th"), { scope: number ? "row" : "col" });
      if (swatch) head.append(Object.assign(document.createElement("i"), { style: `background: ${pixel ? swatch : "none"}` }));
      head.append(name);
      row.append(head, ...cells.map((cell) => Object.assign(document.createElement(number ? "td" : "th"), { textContent: cell })));
      return row;
    }));
  }
}

/** The equation nearest to a pixel, null if it is farther than the points are from each other.
 * @param {[number, number, string][]} equations @param {Point} pixel */
function nearest(equations, { x, y }) {
  const step = (/** @type {0 | 1} */ axis) => {
    const places = [...new Set(equations.map((equation) => equation[axis]))].sort((a, b) => a - b);
    return Math.min(...places.slice(1).map((place, index) => place - places[index]));
  };
  const far = ([px, py]) => Math.hypot(px - x, py - y);
  const best = equations.reduce((a, b) => (a && far(a) <= far(b) ? a : b), /** @type {any} */ (null));
  const reach = [step(0), step(1)].filter(Number.isFinite);
  const most = reach.length ? Math.max(...reach) : 32;
  return best && Math.abs(best[0] - x) <= most && Math.abs(best[1] - y) <= most ? best : null;
}

/** All elements follow when the view changes. */
function redraw() {
  for (const element of near) element.draw();
}

/** The element that keys mean when nothing has the focus: the last one touched, else the one that is seen most. */
function addressed() {
  if (active?.isConnected) return active;
  const seen = (/** @type {Element} */ element) => {
    const { top, bottom } = element.getBoundingClientRect();
    return Math.min(bottom, innerHeight) - Math.max(top, 0);
  };
  return [...near].reduce((best, next) => (best && seen(best) >= seen(next) ? best : next), /** @type {any} */ (null));
}

if (!customElements.get("glsim-compare")) {
  document.addEventListener("scroll", () => (scrolled = performance.now()), { capture: true, passive: true });
  document.addEventListener("keydown", (event) => {
    if (event.target === document.body && addressed()?.key(event)) event.preventDefault();
  });
  customElements.define("glsim-compare", GlsimCompare);
}
