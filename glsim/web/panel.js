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

/** A slider with its title and words for its value.  @param {string} title @param {number} min @param {number} max
 * @param {number} step @param {number} first
 * @param {(value: number) => string} words @param {(value: number) => void} choose */
export function slider(title, min, max, step, first, words, choose) {
  const output = element("output", { textContent: words(first) });
  const input = /** @type {HTMLInputElement} */ (element("input", { type: "range", min, max, step, value: first, ariaLabel: title }));
  input.addEventListener("input", () => {
    output.textContent = words(+input.value);
    choose(+input.value);
  });
  input.addEventListener("put", (event) => { // by something else than a hand
    input.value = String(/** @type {CustomEvent} */ (event).detail);
    output.textContent = words(+input.value);
  });
  return element("label", { className: "row" }, `${title} `, output, input);
}

/** @param {string} title @param {() => void} act */
export function button(title, act) {
  const made = element("button", { type: "button", textContent: title });
  made.addEventListener("click", act);
  return made;
}

// name -> least, most, step; a slider reaches further where the value does
const RANGES = {
  shininess: [0, 128, 1], spot_exponent: [0, 128, 1], spot_cutoff: [1, 90, 1], constant_attenuation: [0, 4, 0.01],
  linear_attenuation: [0, 2, 0.01], quadratic_attenuation: [0, 2, 0.01],
};

const OF_A_LIGHT = ["position", "diffuse", "specular", "ambient"], OF_A_FACE = ["shininess", "ambient", "diffuse", "specular", "emission"];
const OF_A_PLACE = ["spot_cutoff", "spot_exponent", "spot_direction", "constant_attenuation", "linear_attenuation", "quadratic_attenuation"];

/** Whether controls have a value: "lights.position" is there by that name, or with all of "lights"; "lights.spot" are all
 * values of the spot.  @param {string[]} controls @param {string} name  such as "lights.spot_cutoff" */
export function wants(controls, name) {
  const [kind, part] = name.split(".");
  return controls.some((control) => control === kind || (control.startsWith(`${kind}.`) && part.includes(control.split(".")[1])));
}

/** The controls of a scene's values.  All show what the scene says, whoever changed it (``update``). */
export class Panel {
  /** @param {Scene} scene @param {Owner} owner @param {string[]} controls  "lights", "materials" or some of their values, such
   * as "lights.position"; "ambient" @param {Named[]} named */
  constructor(scene, owner, controls, named) {
    this.scene = scene;
    this.owner = owner;
    this.controls = controls;
    this.named = named;
    this.element = element("div", { className: "groups" });
    /** @type {(() => void)[]} */ this.updates = [];
    this.build();
  }

  /** Make the controls of what the scene's frame has. */
  build() {
    const { lights, materials } = this.scene.moment;
    this.updates = [];
    this.element.replaceChildren(...lights.map((_, number) => this.#light(number)), ...materials.map((_, number) => this.#material(number)),
      ...(lights.length && this.controls.includes("ambient") ? [this.#group("Scene", "lights", [this.#colour("ambient")])] : []));
    this.element.replaceChildren(...[...this.element.children].filter((group) => group.children.length > 1));
  }

  update() {
    for (const update of this.updates) update();
  }

  /** Open if only some values of its kind can be changed.  @param {string} title @param {string} kind @param {Node[]} rows */
  #group(title, kind, rows) {
    return element("details", { open: !this.controls.includes(kind) }, element("summary", { textContent: title }), ...rows);
  }

  /** The names that are wanted.  @param {string} kind  "light" or "material" @param {string} path  such as "0" or "0.front" @param {string[]} parts */
  #wanted(kind, path, parts) {
    return parts.filter((part) => wants(this.controls, `${kind}s.${part}`)).map((part) => `${kind}.${path}.${part}`);
  }

  /** @param {number} number */
  #light(number) {
    const { values, number: light } = this.scene.moment.lights[number], placed = /** @type {number[]} */ (values.position)[3] !== 0;
    const names = this.#wanted("light", String(number), placed ? [...OF_A_LIGHT, ...OF_A_PLACE] : OF_A_LIGHT);
    const before = this.scene.moment.lights.slice(0, number).filter((other) => other.number === light).length;
    const changed = before ? `, changed ${before === 1 ? "once" : `${before} times`}` : "";
    return this.#group(`Light ${light}${changed}`, "lights", names.map((name) => this.#value(name)));
  }

  /** @param {number} number */
  #material(number) {
    const { moment } = this.scene, { tracked, both } = moment.materials[number], whole = this.controls.includes("materials");
    const names = (both ? ["front"] : ["front", "back"]).flatMap((face) => this.#wanted("material", `${number}.${face}`, OF_A_FACE))
      .filter((name) => !tracked.includes(/** @type {string} */ (name.split(".").at(-1))) && this.#alike(name)[0] === name);
    const rows = names.map((name) => this.#value(name));
    if (whole && this.named.length) rows.unshift(this.#named(number));
    if (whole && tracked.length) rows.push(element("p", { textContent: `${tracked.join(", ")}: as glColor says (glColorMaterial)` }));
    const one = moment.materials.length === 1 || (!whole && names.every((name) => this.#alike(name).length === moment.materials.length));
    return this.#group(one ? "Material" : `Material ${number + 1}`, "materials", rows);
  }

  /** What changes with a value: if only some values of materials can be changed, it in all that have the same.  @param {string} name */
  #alike(name) {
    const [kind, , face, part] = name.split("."), materials = /** @type {any[]} */ (this.scene.moment.materials);
    if (kind !== "material" || this.controls.includes("materials")) return [name];
    const own = (/** @type {any} */ material) => String(material[face][part]), value = own(materials[+name.split(".")[1]]);
    return [...materials.keys()].filter((k) => own(materials[k]) === value).map((k) => `material.${k}.${face}.${part}`);
  }

  /** @param {string} name @param {Value | undefined} value */
  #set(name, value) {
    for (const one of this.#alike(name)) this.owner.set(one, value);
  }

  /** The row of a value, of the kind that suits it.  @param {string} name */
  #value(name) {
    const part = /** @type {string} */ (name.split(".").at(-1));
    if (part in RANGES) return this.#slider(name, part === "spot_cutoff");
    return part === "position" || part === "spot_direction" ? this.#vector(name, 3) : this.#colour(name);
  }

  /** Materials by name, such as brass.  @param {number} number */
  #named(number) {
    const { named } = this;
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
    back.addEventListener("click", () => this.#set(name, undefined));
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
    input.addEventListener("input", () => this.#set(name, ends && +input.value > most ? 180 : +input.value));
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
        this.#set(name, value);
      });
      this.updates.push(() => {
        const text = String(Number(this.scene.value(name)[axis].toFixed(4)));
        if (input.value === "" || +input.value !== +text) input.value = text;
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
      this.#set(name, [...rgb, ...this.scene.value(name).slice(3)]);
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
