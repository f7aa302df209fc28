const SCALES = [1 / 8, 1 / 4, 1 / 2, 1, 1.5, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];
const VIEW_KEYS = { p: "picture", s: "swipe", d: "difference", a: "side" };
const LABEL = 34; // CSS pixels above each picture side by side

/** @type {Set<Viewer>} */
const near = new Set(); // strips on the screen or close to it: only they hold pixels
/** @type {Viewer?} */
let active = null; // the strip that was touched last: keys go to it when nothing has the focus

/** All strips follow when the view changes. */
function redraw() {
  for (const viewer of near) viewer.draw();
}

/** What a reader does with one strip: which pictures are seen, how, and which pixel is asked for. */
class Viewer {
  /** Put the controls into the element's shadow and take its heading and its table there.
   * @param {HTMLElement} host */
  constructor(host) {
    /** @type {StripData} */
    this.data = JSON.parse(host.querySelector("script")?.textContent || "");
    this.host = host;
    this.figures = [...host.querySelectorAll("img")];
    const root = host.attachShadow({ mode: "open" });
    root.adoptedStyleSheets = [style];
    root.innerHTML = CONTROLS;
    this.root = root;
    this.$(".head").append(...host.querySelectorAll(":scope > h2, :scope > h3, :scope > p"));
    this.$(".metrics").append(/** @type {Node} */ (host.querySelector("table")));

    this.pictures = this.data.pictures;
    this.reference = this.data.reference;
    this.current = 0;
    this.previous = this.pictures.length > 1 ? 1 : 0; // the picture that Space goes back to
    this.view = "picture";
    this.gain = GAINS.includes(this.data.gain) ? this.data.gain : 8;
    this.divider = 0.5;
    /** @type {{hover: Point?, mark: Point?, point: Point?}} */
    this.marks = { hover: null, mark: null, point: null };
    /** @type {Pixels[]} */
    this.pixels = []; // empty while the strip is far from the screen
    /** @type {Map<string, {image: HTMLCanvasElement, pixels: Pixels}>} */
    this.images = new Map();
    const largest = (/** @type {string} */ side) =>
      Math.max(...this.figures.map((image) => Number(image.getAttribute(side))));
    this.stage = new Stage(this.$("canvas"), { width: largest("width"), height: largest("height") });
    this.$(".stage").style.aspectRatio = `${this.stage.size.width} / ${this.stage.size.height}`;
    this.$(".ui").classList.toggle("single", this.pictures.length < 2);
    fillChoices(this.$(".pictures"), "pictures", this.pictures.map(({ name }) => name), "123456789");
    fillChoices(this.$(".views"), "views", Object.values(VIEWS), "PSDA");
    for (const gain of GAINS) this.$("select").add(new Option(`× ${gain}`, String(gain)));
    for (const { name, caption } of [...this.pictures, this.pictures[0]]) { // the last is seen, the others keep room
      this.$(".captions").append(document.createElement("p"));
      this.caption(name, caption);
    }
    this.listen();
    this.update();
  }

  /** A part of the controls.  @param {string} selector @returns {any} */
  $(selector) {
    return this.root.querySelector(selector);
  }

  listen() {
    this.root.addEventListener("change", (event) => {
      const { name, value } = /** @type {HTMLInputElement} */ (event.target);
      if (name === "pictures") this.show(Number(value));
      else if (name === "views") this.look(Object.keys(VIEWS)[Number(value)]);
      else this.set({ gain: Number(value) });
    });
    this.root.addEventListener("click", (event) => {
      const how = /** @type {HTMLElement} */ (event.target).dataset.zoom;
      if (how) this.zoom(how);
    });
    this.host.addEventListener("keydown", (event) => {
      if (event.defaultPrevented || !this.key(event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    for (const event of ["pointerenter", "focusin"]) this.host.addEventListener(event, () => (active = this));
    new Hands(this);
    new ResizeObserver(() => this.draw()).observe(this.$("canvas"));
  }

  /** Decode the pictures and draw. */
  async wake() {
    near.add(this);
    const pixels = await Promise.all(this.figures.map((image) => decodePNG(image.src)));
    if (!near.has(this)) return;
    this.pixels = pixels;
    this.update();
  }

  /** Give the pictures' memory back. */
  sleep() {
    near.delete(this);
    if (active === this) active = null;
    this.pixels = [];
    this.images.clear();
    Object.assign(this.$("canvas"), { width: 0, height: 0 });
  }

  /** @param {Partial<{current: number, previous: number, view: string, gain: number, divider: number}>} changes */
  set(changes) {
    Object.assign(this, changes);
    this.update();
  }

  /** @param {number} index  of the picture to show in place of the present one */
  show(index) {
    if (index < this.pictures.length && index !== this.current) this.set({ previous: this.current, current: index });
  }

  /** The picture that the reference is compared with: the one that is shown, or was before. */
  partner() {
    const { current, previous, reference } = this;
    return [current, previous, 0, 1].find((index) => index !== reference && index < this.pictures.length) ?? reference;
  }

  /** @param {string} view  of VIEWS; the reference against itself shows nothing, so another picture comes instead */
  look(view) {
    if (this.pictures.length < 2) return;
    if ((view === "swipe" || view === "difference") && this.current === this.reference)
      this.show(this.partner());
    this.set({ view });
  }

  /** @param {string} how  "in", "out", "fit" or "full" */
  zoom(how) {
    const { box } = this.stage.panels[0], { scale } = this.stage.place(box);
    const centre = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    if (how === "fit") Object.assign(view, { scale: 0, x: 0.5, y: 0.5 });
    else {
      const next = how === "in" ? SCALES.find((step) => step > 1.01 * scale) : SCALES.findLast((step) => step < 0.99 * scale);
      this.stage.zoomTo(how === "full" ? 1 : next || scale, centre);
    }
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
    if (event.ctrlKey || event.metaKey || event.altKey || target.localName === "select" || !this.pixels.length) return false;
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
    else if (onStage && key === " ") this.show(this.previous);
    else if (onStage && event.shiftKey && (dx || dy)) this.mark(this.beside(dx, dy));
    else if (onStage && (dx || dy) && view.scale) this.stage.pan(-60 * dx, -60 * dy), redraw();
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
      difference: [`| ${name} − ${reference} |`, `${this.gain} times amplified`],
      side: ["All pictures", ""],
    }[this.view] || [name, caption];
    this.caption(words[0], words[1]);
    this.$("canvas").setAttribute("aria-label", `${this.data.title}: ${words.join(" ")}`);
    this.$(".stage").setAttribute("aria-label", `${this.data.title}: arrows pan, Shift and arrows choose a pixel`);
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

  /** @param {string} name @param {string} words */
  caption(name, words) {
    const bold = document.createElement("b");
    bold.append(...typeset(name));
    this.$(".captions p:last-child").replaceChildren(bold, " ", ...typeset(words));
  }

  /** The equation of the point nearest to the marked pixel, if one is within the points' grid. */
  equation() {
    const { mark } = this.marks, { name, equations } = this.pictures[this.current];
    const found = mark && nearest(equations, mark);
    this.marks.point = found && { x: found[0], y: found[1] };
    this.$(".equation").hidden = !mark || !this.pictures.some((picture) => picture.equations.length);
    if (!mark) return;
    this.$(".equation h4").replaceChildren(...typeset(found ? `${name} at (${found[0]}, ${found[1]})` : name));
    this.$(".equation pre").replaceChildren(...typeset(found ? found[2] : "There is no equation near this pixel."));
  }

  draw() {
    if (!this.pixels.length || !this.host.isConnected) return;
    const panels = this.panels(), colour = getComputedStyle(this.host);
    const [ink, paper] = ["--ink", "--paper"].map((name) => colour.getPropertyValue(name));
    this.$(".message").textContent = panels.length ? "" : this.sizes();
    if (!panels.length) panels.push({ ...this.panel(this.current), clip: { x: 0, y: 0, width: 0, height: 0 } });
    this.stage.draw(panels, { ink, paper }, this.marks);
    this.$(".zoom output").textContent = `${Math.round(100 * this.stage.place(panels[0].box).scale)} %`;
    this.$("[data-zoom=fit]").setAttribute("aria-pressed", String(!view.scale));
    this.$(".stage").classList.toggle("zoomed", Boolean(view.scale));
    const shown = this.view === "side" ? this.pictures.keys() : new Set([this.reference, this.partner()]);
    const rows = [...shown].map((index) => ({ name: this.pictures[index].name, pixels: this.pixels[index] }));
    fillValues(this.$(".values"), this.marks.hover || this.marks.mark, rows);
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
      return [{ ...this.panel(current), ...this.image(`${current} x ${this.gain}`, () => differenceOf(a, b, this.gain)) }];
    }
    if (this.view === "side") return this.grid(width, height);
    return [this.panel(current)];
  }

  /** A picture on the whole stage.  @param {number} index @returns {Panel} */
  panel(index) {
    const { clientWidth: width, clientHeight: height } = this.$("canvas"), box = { x: 0, y: 0, width, height };
    return { box, clip: box, ...this.image(`${index}`, () => this.pixels[index]) };
  }

  /** What ``make`` makes, and a canvas of it; made once.  @param {string} key @param {() => Pixels} make */
  image(key, make) {
    let made = this.images.get(key);
    if (!made) {
      const pixels = make();
      this.images.set(key, (made = { pixels, image: imageOf(pixels) }));
    }
    return made;
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
    const counts = this.pictures.map((_, index) => index + 1);
    const columns = counts.reduce((best, next) => (scale(next) > scale(best) ? next : best));
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
}
