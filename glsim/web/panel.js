/**
 * The controls beside a picture: one for each value, with the call that sets it.
 * @typedef {import("./scene.js").Scene} Scene
 * @typedef {import("./scene.js").Value} Value
 * @typedef {{label: string, values: Record<string, Value>}} Named  a named material
 * @typedef {{set: (name: string, value: Value | undefined) => void}} Owner
 */
import { line } from "./source.js";

/** An element with properties and children.  @param {string} tag @param {Record<string, any>} properties @param {...(Node | string)} children */
export function element(tag, properties = {}, ...children) {
  const { dataset, ...rest } = properties, made = Object.assign(document.createElement(tag), rest);
  Object.assign(made.dataset, dataset);
  made.append(...children);
  return made;
}

/** A group of choices, of which one is pressed.  @param {string} title @param {string[]} names
 * @param {(name: string) => void} choose @param {Record<string, string>} words  what stands for a name */
export function choices(title, names, choose, words = {}) {
  const group = element("div", { className: "choices", role: "group", ariaLabel: title });
  for (const name of names) {
    const button = element("button", { type: "button", textContent: words[name] ?? name, dataset: { name } });
    button.addEventListener("click", () => choose(name));
    group.append(button);
  }
  return group;
}

// name -> least, most, step; a slider reaches further where the value does
const RANGES = {
  shininess: [0, 128, 1], spot_exponent: [0, 128, 1], spot_cutoff: [1, 90, 1], constant_attenuation: [0, 4, 0.01],
  linear_attenuation: [0, 2, 0.01], quadratic_attenuation: [0, 2, 0.01],
};

/** The controls of a scene's values.  All show what the scene says, whoever changed it (``update``). */
export class Panel {
  /** @param {Scene} scene @param {Owner} owner @param {string[]} wanted  "lights", "materials", "ambient" @param {Named[]} named */
  constructor(scene, owner, wanted, named) {
    this.scene = scene;
    this.owner = owner;
    /** @type {(() => void)[]} */ this.updates = [];
    this.groups = [];
    if (wanted.includes("lights")) scene.moment.lights.forEach((_, number) => this.groups.push(this.#light(number)));
    if (wanted.includes("materials")) scene.moment.materials.forEach((_, number) => this.groups.push(this.#material(number, named)));
    if (wanted.includes("ambient") && scene.moment.lights.length)
      this.groups.push(this.#group("Scene", [this.#colour("ambient")]));
  }

  update() {
    for (const update of this.updates) update();
  }

  /** @param {string} title @param {Node[]} rows */
  #group(title, rows) {
    return element("details", {}, element("summary", { textContent: title }), ...rows);
  }

  /** @param {number} number */
  #light(number) {
    const { values, number: light } = this.scene.moment.lights[number], name = (/** @type {string} */ part) => `light.${number}.${part}`;
    const placed = /** @type {number[]} */ (values.position)[3] !== 0;
    const rows = [this.#vector(name("position"), 3), ...["diffuse", "specular", "ambient"].map((part) => this.#colour(name(part)))];
    if (placed) {
      rows.push(this.#slider(name("spot_cutoff"), true), this.#slider(name("spot_exponent")), this.#vector(name("spot_direction"), 3));
      for (const part of ["constant", "linear", "quadratic"]) rows.push(this.#slider(name(`${part}_attenuation`)));
    }
    const before = this.scene.moment.lights.slice(0, number).filter((other) => other.number === light).length;
    return this.#group(`Light ${light}${before ? `, changed ${before === 1 ? "once" : `${before} times`}` : ""}`, rows);
  }

  /** @param {number} number @param {Named[]} named */
  #material(number, named) {
    const { moment } = this.scene, { tracked, both } = moment.materials[number], rows = [];
    if (named.length) rows.push(this.#named(number, named));
    for (const face of both ? ["front"] : ["front", "back"]) {
      rows.push(this.#slider(`material.${number}.${face}.shininess`));
      for (const part of ["ambient", "diffuse", "specular", "emission"])
        if (!tracked.includes(part)) rows.push(this.#colour(`material.${number}.${face}.${part}`));
    }
    if (tracked.length) rows.push(element("p", { textContent: `${tracked.join(", ")}: as glColor says (glColorMaterial)` }));
    return this.#group(moment.materials.length > 1 ? `Material ${number + 1}` : "Material", rows);
  }

  /** Materials by name, such as brass.  @param {number} number @param {Named[]} named */
  #named(number, named) {
    const select = /** @type {HTMLSelectElement} */ (element("select", { ariaLabel: "a named material" },
      element("option", { textContent: "a named material …", value: "" }),
      ...named.map(({ label }) => element("option", { textContent: label, value: label }))));
    select.addEventListener("change", () => {
      const values = named.find(({ label }) => label === select.value)?.values ?? {};
      for (const [part, value] of Object.entries(values)) this.owner.set(`material.${number}.front.${part}`, value);
    });
    return element("label", { className: "row" }, select);
  }

  /** The row of one value: the call, which is literal source, and what changes it.
   * @param {string} name @param {...HTMLElement} inputs */
  #row(name, ...inputs) {
    const call = element("code");
    const back = element("button", { type: "button", className: "back", title: "as it was", ariaLabel: "as it was", textContent: "↺" });
    back.addEventListener("click", () => this.owner.set(name, undefined));
    this.updates.push(() => {
      call.textContent = line(this.scene, name);
      back.hidden = !this.scene.changed.has(name);
    });
    return element("div", { className: "row", dataset: { name } }, call, back, ...inputs);
  }

  /** @param {string} name @param {boolean} ends  whether the greatest value stands for 180 degrees: no spot */
  #slider(name, ends = false) {
    const [least, most, step] = RANGES[/** @type {keyof typeof RANGES} */ (name.split(".").at(-1))];
    const input = this.#input("range", name, { min: least, step, max: ends ? most + step : most });
    input.addEventListener("input", () => this.owner.set(name, ends && +input.value > most ? 180 : +input.value));
    this.updates.push(() => {
      const value = this.scene.value(name);
      if (!ends) input.max = String(Math.max(+input.max, value));
      input.value = String(ends && value > most ? most + step : value);
    });
    return this.#row(name, input);
  }

  /** The first numbers of a vector.  @param {string} name @param {number} count */
  #vector(name, count) {
    const inputs = Array.from({ length: count }, (_, axis) => {
      const input = this.#input("number", name, { step: 0.1 });
      input.ariaLabel = `${line(this.scene, name)}: ${"xyz"[axis]}`;
      input.addEventListener("input", () => {
        if (input.value === "" || !Number.isFinite(+input.value)) return;
        const value = [...this.scene.value(name)];
        value[axis] = +input.value;
        this.owner.set(name, value);
      });
      this.updates.push(() => {
        const text = String(Number(this.scene.value(name)[axis].toFixed(4)));
        if (+input.value !== +text) input.value = text;
      });
      return input;
    });
    return this.#row(name, element("span", { className: "numbers" }, ...inputs));
  }

  /** Red, green and blue; alpha stays.  @param {string} name */
  #colour(name) {
    const input = this.#input("color", name, {});
    input.addEventListener("input", () => {
      const rgb = [1, 3, 5].map((at) => Number((parseInt(input.value.slice(at, at + 2), 16) / 255).toFixed(3)));
      this.owner.set(name, [...rgb, ...this.scene.value(name).slice(3)]);
    });
    this.updates.push(() => {
      const byte = (/** @type {number} */ value) => Math.round(255 * Math.min(1, Math.max(0, value))).toString(16).padStart(2, "0");
      input.value = `#${this.scene.value(name).slice(0, 3).map(byte).join("")}`;
    });
    return this.#row(name, input);
  }

  /** @param {string} type @param {string} name @param {Record<string, any>} properties */
  #input(type, name, properties) {
    const input = /** @type {HTMLInputElement} */ (element("input", { type, ...properties }));
    input.ariaLabel = line(this.scene, name).replace(/, [^,]*\)$|, \[.*$/, "") + ")";
    return input;
  }
}
