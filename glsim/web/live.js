/**
 * <glsim-live>: a picture that can be turned, lit and shaded anew in the browser.  live.py writes its children: the still
 * picture, which a reader without WebGL2 and a printer get; the data as JSON; the tape, compressed, as base64.
 *
 * @typedef {import("./scene.js").Moment} Moment
 * @typedef {import("./scene.js").Layout} Layout
 * @typedef {import("./panel.js").Named} Named
 * @typedef {{name: string, blob: number}} Stage  radiosities of all vertices, three numbers of 16 bits each
 * @typedef {{stages: Stage[], steps: number, choices: Record<string, number>, white: number, gamma: number, tone: string,
 *   parts: {rows: number, count: number}[], stride: number, offset: number}} Radiosity  steps: how many
 *   stages are steps of the solution, which is the last; rows: a blob of vertices whose colours, at offset, are the
 *   tone-mapped radiosity; a stage has the vertices of all parts, one after the other
 * @typedef {{title: string, width: number, height: number, point: [number, number]?, apart: boolean, modes: string[], lobes: string[], frames: string[], mode: string, lobe: string,
 *   pictures: Record<string, number>, moments: Moment[], layout: Layout, controls: string[], named: Named[], notes: string[],
 *   radiosity: Radiosity?}} Data  pictures: "frame mode lobe" -> number on the tape; "frame edges": the polygons' edges
 */
import { Tape, planned } from "./tape.js";
import { Player } from "./player.js";
import { RESTING, Scene } from "./scene.js";
import { pick, vectors } from "./pick.js";
import { literal, lines } from "./source.js";
import { Overlay } from "./overlay.js";
import { turning } from "./turning.js";
import { Panel, button, choices, element, slider, wants } from "./panel.js";
import { foremost, unwatch, watch } from "./awake.js";
import { colours } from "./radiosity.js";

/** @param {string} text  base64 */
async function inflated(text) {
  const packed = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** @param {string} text  base64 */
const bytesOf = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));

export class Live extends HTMLElement {
  /** Resolves when the picture is shown. @type {Promise<void>?} */
  ready = null;
  /** @type {Tape?} */ tape = null;
  /** @type {Record<string, import("./tape.js").Plan>?} */ plans = null;
  /** Draws, as long as the element is near the screen. @type {Player?} */ player = null;
  /** @type {Promise<void>?} */ waiting = null;
  /** @type {import("./pick.js").Point?} */ point = null;
  /** @type {object?} */ #waking = null;

  connectedCallback() {
    try {
      if (!this.data && this.querySelector("script")) this.#build(this.#script("application/json"));
      if (this.data) watch(this);
    } catch (error) {
      this.#fail(/** @type {Error} */ (error));
    }
  }

  disconnectedCallback() {
    unwatch(this);
  }

  /** Show something else than what stands in the page.  @param {string} json  of Data @param {Uint8Array} bytes  of the tape */
  load(json, bytes) {
    this.sleep();
    this.tape = new Tape(bytes);
    this.plans = null;
    this.#build(json);
    watch(this);
  }

  /** The still picture, with a sentence.  @param {Error} error */
  #fail(error) {
    unwatch(this);
    this.dataset.state = "failed";
    this.shadowRoot?.replaceChildren(element("slot"));
    this.append(element("p", { className: "live-note", textContent: error.message }));
  }

  wake() {
    this.ready = this.#wake().catch((error) => this.#fail(error));
  }

  async #wake() {
    const waking = (this.#waking = {}), first = !this.plans;
    this.dataset.state = "compiling";
    this.tape ??= new Tape(await inflated(this.#script("application/x-glsim-tape")));
    if (this.#waking !== waking) return;
    const { tape } = this, canvas = /** @type {HTMLCanvasElement} */ (element("canvas", { className: "picture" }));
    this.plans ??= Object.fromEntries(Object.entries(/** @type {Data} */ (this.data).pictures).map(([name, number]) => [name, planned(tape, number)]));
    this.player = new Player(canvas, tape);
    this.player.oncontext = (lost) => {
      this.dataset.state = lost ? "lost" : "ready";
      if (!lost) this.draw();
    };
    await this.#prepare();
    if (this.#waking !== waking) return;
    this.draw();
    this.picture?.replaceWith(canvas);
    this.picture = canvas;
    this.dataset.state = "ready";
    if (first && this.data?.point) this.ask(...this.data.point);
  }

  /** Give the context back; a copy of the picture stays. */
  sleep() {
    const { player, picture } = this;
    this.#waking = this.player = null;
    this.dataset.state = "asleep";
    if (!player) return;
    if (picture === player.canvas) {
      const copy = /** @type {HTMLCanvasElement} */ (element("canvas", { className: "picture", width: picture.width, height: picture.height }));
      copy.getContext("2d")?.drawImage(picture, 0, 0);
      picture.replaceWith(copy);
      this.picture = copy;
    }
    player.release();
  }

  /** The text of a child.  @param {string} kind */
  #script(kind) {
    return this.querySelector(`script[type="${kind}"]`)?.textContent ?? "";
  }

  // ------------------------------------------------------------ what is seen

  /** @param {string} json  of Data */
  #build(json) {
    /** @type {Data} */ const data = JSON.parse(json, (key, value) => (key === "row" ? bytesOf(value) : value));
    this.data = data;
    this.look = { frame: 0, mode: data.mode, lobe: data.lobe, edges: false, stage: (data.radiosity?.steps ?? 1) - 1, exposure: 1 };
    this.scene = new Scene(data.moments[0], data.layout);
    this.point = null;
    const root = this.shadowRoot ?? this.attachShadow({ mode: "open" }), style = new CSSStyleSheet();
    style.replaceSync(LIVE_CSS);
    root.adoptedStyleSheets = [style];
    this.picture = /** @type {HTMLCanvasElement} */ (element("canvas", { className: "picture" }));
    const over = /** @type {HTMLCanvasElement} */ (element("canvas", { className: "over" }));
    this.stage = element("div", { className: "stage", tabIndex: 0, role: "application",
      ariaLabel: `${data.title}: arrow keys turn the camera, plus and minus bring it nearer, 0 puts it back` }, this.picture, over,
      element("p", { className: "state", textContent: "compiling the shaders …" }));
    this.style.setProperty("--width", `${data.width}px`);
    this.stage.style.aspectRatio = `${data.width} / ${data.height}`;
    this.overlay = new Overlay(over, data.width, data.height);
    turning(this.stage, data.width, this.#doing());
    new ResizeObserver(() => this.draw()).observe(this.stage);
    this.gaps = element("ul", { className: "gaps" });
    root.replaceChildren(element("div", { className: "live" }, element("div", { className: "left" }, this.stage, this.gaps),
      element("div", { className: "panel" }, ...this.#controls())), element("slot"));
    this.#restore();
    this.#tell();
  }

  #controls() {
    const data = /** @type {Data} */ (this.data), { controls } = data, parts = [];
    const look = /** @type {NonNullable<typeof this.look>} */ (this.look);
    const choose = (/** @type {"mode" | "lobe"} */ axis) => (/** @type {string} */ name) => ((look[axis] = name), this.change());
    /** @type {Record<string, HTMLElement>} */ this.choices = {};
    const apart = data.apart && data.frames.join("").length <= SHORT;
    if (data.frames.length > 1 && apart)
      this.choices.frame = choices("picture", data.frames, (name) => this.#frame(data.frames.indexOf(name)));
    if (controls.includes("mode") && data.modes.length > 1) this.choices.mode = choices("shade model", data.modes, choose("mode"));
    if (controls.includes("lobe") && data.lobes.length > 1) this.choices.lobe = choices("specular lobe", data.lobes, choose("lobe"), LOBE_NAMES);
    parts.push(...Object.values(this.choices));
    if (data.radiosity) parts.push(...this.#radiosity(data.radiosity));
    if (data.frames.length > 1 && !apart) parts.push(this.#scrubber("picture", data.frames, 0, (number) => this.#frame(number)));
    if (controls.includes("edges") && "0 edges" in data.pictures) parts.push(this.#edges(look));
    this.panel = new Panel(/** @type {Scene} */ (this.scene), { set: (name, value) => this.set(name, value) }, controls, data.named);
    this.source = element("pre", { className: "source", tabIndex: 0 });
    this.changes = element("div", { className: "changes" }, this.source, button("Copy", () => this.#copy(this.source?.textContent ?? "")),
      button("Link", () => this.#copy(this.link())), button("Reset", () => this.reset()));
    return [...parts, this.panel.element, this.changes,
      element("p", { className: "help", textContent: "Drag: turn. Shift or two fingers: move. Wheel or pinch: nearer."
        + (data.moments[0].lights.length ? " Click: N, L, V there." : "") })];
  }

  /** @param {string} title @param {string[]} names @param {number} first @param {(number: number) => void} choose */
  #scrubber(title, names, first, choose) {
    return slider(title, 0, names.length - 1, 1, first, (number) => names[number], choose);
  }

  /** @param {{edges: boolean}} look */
  #edges(look) {
    const input = this.edges = /** @type {HTMLInputElement} */ (element("input", { type: "checkbox" }));
    input.addEventListener("input", () => ((look.edges = input.checked), this.change()));
    return element("label", { className: "row" }, input, " edges of polygons");
  }

  /** @param {string} text */
  #copy(text) {
    navigator.clipboard?.writeText(text);
  }

  /** The light that is shown, and the exposure.  @param {Radiosity} radiosity */
  #radiosity({ stages, steps, choices: stagesByName }) {
    const look = /** @type {NonNullable<typeof this.look>} */ (this.look), names = stages.slice(0, steps).map(({ name }) => name);
    const scrubber = this.#scrubber("light", names, steps - 1, (number) => this.show({ stage: number }));
    const exposure = slider("exposure", -3, 3, 0.05, 0, (value) => literal(2 ** value), (value) => this.show({ exposure: 2 ** value }));
    const group = (this.choices ??= {}).light = choices("light", Object.keys(stagesByName), (name) => {
      look.stage = stagesByName[name];
      scrubber.querySelector("input")?.dispatchEvent(new CustomEvent("put", { detail: look.stage }));
      this.change();
    });
    return [group, scrubber, exposure];
  }

  // ------------------------------------------------------------ what changes it

  /** @returns {import("./turning.js").Doing} */
  #doing() {
    const scene = /** @type {Scene} */ (this.scene), data = /** @type {Data} */ (this.data), overlay = /** @type {Overlay} */ (this.overlay);
    const { orbit } = scene, lit = () => wants(data.controls, "lights.position");
    let held = -1;
    const pixel = () => { // of eye space at the centre's distance
      const { camera } = scene.moment, projection = scene.projection, z = projection[15] === 0 ? camera.centre[2] : 1;
      return (2 * Math.abs(z)) / (projection[0] * data.width);
    };
    return {
      grab: (x, y) => {
        const near = (/** @type {import("./overlay.js").Handle} */ handle) => Math.hypot(handle.x - x, handle.y - y) < 16 * (overlay.unit ?? 1);
        held = lit() ? overlay.handles(scene).find(near)?.number ?? -1 : -1;
        return held >= 0;
      },
      drag: (x, y) => {
        const place = overlay.dragged(scene, held, x, y);
        if (place) this.set(`light.${held}.position`, scene.lightValueAt(held, place).map((/** @type {number} */ value) => Number(value.toFixed(3))));
      },
      turn: (dx, dy) => {
        orbit.yaw = (orbit.yaw + (180 * dx) / data.width) % 360;
        orbit.pitch = Math.max(-180, Math.min(180, orbit.pitch + (180 * dy) / data.width));
        this.turned();
      },
      move: (dx, dy) => ((orbit.x += dx * pixel()), (orbit.y -= dy * pixel()), this.turned()),
      zoom: (factor) => ((orbit.zoom = Math.max(0.2, Math.min(20, orbit.zoom * factor))), this.turned()),
      click: (x, y) => this.ask(x, y),
      reset: () => (Object.assign(orbit, RESTING), this.turned()),
    };
  }

  /** Press a button of the first choice: of the picture, the mode or the lobe.  @param {number} number  1 for the first */
  choose(number) {
    const button = /** @type {HTMLButtonElement | undefined} */ (Object.values(this.choices ?? {})[0]?.children[number - 1]);
    button?.click();
    return Boolean(button);
  }

  /** Change a value, by its name in Scene.changed; undefined gives it back.
   * @param {string} name @param {import("./scene.js").Value | undefined} value */
  set(name, value) {
    this.scene?.set(name, value);
    this.change();
  }

  /** Turn the camera: degrees, lengths of eye space, zoom.  @param {Partial<import("./scene.js").Orbit>} orbit */
  orbit(orbit) {
    Object.assign(/** @type {Scene} */ (this.scene).orbit, orbit);
    this.turned();
  }

  turned() {
    if (this.scene) this.scene.version++;
    this.point = null;
    this.change();
  }

  /** Show another shade model, lobe, stage, exposure or the edges.  @param {Record<string, any>} look */
  show(look) {
    Object.assign(/** @type {object} */ (this.look), look);
    return this.change();
  }

  /** @param {number} number */
  #frame(number) {
    if (!this.look || !this.scene || !this.data) return;
    this.look.frame = number;
    this.scene.show(this.data.moments[number]);
    this.panel?.build();
    this.point = null;
    this.change();
  }

  /** Show the vectors at a point, in pixels from the upper left corner.  @param {number} x @param {number} y */
  ask(x, y) {
    const { tape, scene } = this;
    if (tape && scene) this.point = pick(tape, this.#plan().draws, scene, x, tape.height - y);
    this.change();
  }

  reset() {
    const scene = /** @type {Scene} */ (this.scene), { data } = this;
    scene.changed.clear();
    Object.assign(scene.orbit, RESTING);
    Object.assign(this.look ?? {}, { mode: data?.mode, lobe: data?.lobe });
    this.turned();
  }

  // ------------------------------------------------------------ drawing

  /** Something is different: draw, as soon as the programs are ready.  One picture for each of the screen's.
   * @returns {Promise<void>}  resolves when it is drawn */
  change() {
    this.waiting ??= new Promise((/** @type {(value?: undefined) => void} */ drawn) => requestAnimationFrame(async () => {
      this.waiting = null;
      try {
        this.#tell();
        await this.#prepare();
        this.draw();
      } catch (error) {
        this.#fail(/** @type {Error} */ (error));
      }
      drawn();
    }));
    return this.waiting;
  }

  #plan() {
    const { frame, mode, lobe } = /** @type {NonNullable<typeof this.look>} */ (this.look);
    return /** @type {NonNullable<typeof this.plans>} */ (this.plans)[`${frame} ${mode} ${lobe}`];
  }

  #shown() {
    const { frame, edges } = /** @type {NonNullable<typeof this.look>} */ (this.look);
    return edges ? [this.#plan(), /** @type {any} */ (this.plans)[`${frame} edges`]] : [this.#plan()];
  }

  async #prepare() {
    await this.player?.prepare(...this.#shown());
  }

  draw() {
    const { player, scene, overlay, look, data } = this;
    if (!player || !scene || !overlay || !look || !data) return;
    player.patch = { version: scene.version, change: (block, bytes) => scene.change(block, bytes) };
    if (data.radiosity) colours(player, data.radiosity, look.stage, look.exposure);
    player.draw(...this.#shown());
    const light = scene.moment.lights.length ? scene.lightPosition(0) : null;
    const arrows = this.point && light ? vectors(this.point, light, scene.moment.localViewer, look.lobe === "phong") : [];
    overlay.draw(scene, { point: this.point, arrows, handles: wants(data.controls, "lights.position") });
    const notes = [...data.notes.filter((note) => scene.turned.some((value, k) => value !== +(k % 5 === 0)) || !note.startsWith("Turned: ")), ...player.gaps];
    this.gaps?.replaceChildren(...notes.map((note) => element("li", { textContent: note })));
  }

  /** All controls show what is so, and the changed lines stand below them. */
  #tell() {
    const { scene, look, data } = this;
    if (!scene || !look || !data || !this.source) return;
    this.panel?.update();
    const light = Object.entries(data.radiosity?.choices ?? {}).find(([, stage]) => stage === look.stage)?.[0];
    const pressed = /** @type {Record<string, string | undefined>} */ ({ frame: data.frames[look.frame], mode: look.mode, lobe: look.lobe, light });
    for (const [axis, group] of Object.entries(this.choices ?? {}))
      for (const button of group.children)
        button.ariaPressed = String(/** @type {HTMLElement} */ (button).dataset.name === pressed[axis]);
    if (this.edges) this.edges.checked = look.edges;
    const text = lines(scene, look, data);
    this.source.textContent = text.join("\n");
    this.changes?.classList.toggle("none", text.length === 0);
  }

  // ------------------------------------------------------------ links

  /** The page's address with this element's changes. */
  link() {
    const { look, scene, data } = this, url = new URL(location.href);
    const state = { l: look && { ...look }, o: scene?.orbit, c: Object.fromEntries(scene?.changed ?? []) };
    url.hash = `live${this.#number()}=${encodeURIComponent(JSON.stringify(state))}`;
    return data ? url.href : "";
  }

  #number() {
    return [...document.querySelectorAll("glsim-live")].indexOf(this);
  }

  #restore() {
    const found = location.hash.match(/^#live(\d+)=(.*)$/);
    if (!found || +found[1] !== this.#number() || !this.scene || !this.look || !this.data) return;
    try {
      const { l, o, c } = JSON.parse(decodeURIComponent(found[2]));
      if (`${l.frame} ${l.mode} ${l.lobe}` in this.data.pictures) Object.assign(this.look, l);
      this.scene.show(this.data.moments[this.look.frame]);
      Object.assign(this.scene.orbit, o);
      for (const [name, value] of Object.entries(c)) if (this.scene.value(name) !== undefined) this.scene.set(name, value);
      this.panel?.build();
      this.scrollIntoView({ block: "center" });
    } catch {
      // a link that was cut off: the picture as it was drawn
    }
  }
}

/** @type {Record<string, string>} */
const LOBE_NAMES = { blinn: "(N·H)ⁿ", phong: "(R·V)ⁿ" };
const SHORT = 80; // letters: names of pictures that are buttons

if (!customElements.get("glsim-live")) {
  customElements.define("glsim-live", Live);
  document.addEventListener("keydown", (event) => {
    const inside = /** @type {Element} */ (event.composedPath()[0]), other = event.altKey || event.ctrlKey || event.metaKey;
    if (other || event.defaultPrevented || inside.matches("input:not([type=range]), select, textarea")) return;
    const chosen = event.target instanceof Live ? event.target : /** @type {Live?} */ (foremost());
    if (chosen?.choose(+event.key)) event.preventDefault();
  });
}
