/**
 * The values behind a picture, which can be changed while it is shown: lights, materials, the scene's ambient light, the
 * camera.  They reach the GPU in the same uniform blocks in which glsim wrote them (glsim/render/uniforms.py): a row of a
 * block that is equal to what a light or a material had is replaced by what it has now.
 *
 * @typedef {import("./matrix.js").Matrix} Matrix
 * @typedef {import("./matrix.js").Vector} Vector
 * @typedef {number | number[]} Value
 * @typedef {{number: number, row: Uint8Array, values: Record<string, Value>, position: Matrix, direction: Matrix,
 *   turnsPosition: boolean, turnsDirection: boolean, line: number?}} Light  position, direction: the modelview matrix when
 *   they were given; turns...: with the camera, because that matrix held the camera
 * @typedef {{row: Uint8Array, front: Record<string, Value>, back: Record<string, Value>, both: boolean, tracked: string[],
 *   face: string, line: number?}} Material  both: back has front's values; tracked: what follows the current colour
 * @typedef {{projections: {matrix: Matrix, turns: boolean}[], centre: Vector, radius: number, view: Matrix,
 *   up: Vector, hasView: boolean}} Camera  centre, up: in eye space; view: the matrix that gluLookAt made
 * @typedef {{lights: Light[], materials: Material[], ambient: Vector,
 *   localViewer: boolean, camera: Camera}} Moment  what a frame is drawn with
 * @typedef {Record<string, Record<string, number>>} Layout  of the structures and blocks: bytes, "size" of the whole
 * @typedef {{yaw: number, pitch: number, x: number, y: number, zoom: number}} Orbit
 */
import { IDENTITY, inverse, multiply, rotate, rotation, transform, translation, unit } from "./matrix.js";

export const RESTING = Object.freeze({ yaw: 0, pitch: 0, x: 0, y: 0, zoom: 1 });
/** glMaterial's and glLight's names -> members of Face and Light in shaders/state.glsl @type {Record<string, string>} */
const FACE = { ambient: "k_a", diffuse: "k_d", specular: "k_s", emission: "emission", shininess: "n" };
/** @type {Record<string, string>} */
const LIGHT = {
  ambient: "I_a", diffuse: "I_d", specular: "I_s", spot_exponent: "spot_exponent",
  constant_attenuation: "constant_attenuation", linear_attenuation: "linear_attenuation",
  quadratic_attenuation: "quadratic_attenuation",
};

export class Scene {
  /** @param {Moment} moment @param {Layout} layout */
  constructor(moment, layout) {
    this.moment = moment;
    this.layout = layout;
    /** What was changed: "light.0.position", "material.0.front.shininess", "ambient". @type {Map<string, Value>} */
    this.changed = new Map();
    /** @type {Orbit} */ this.orbit = { ...RESTING };
    this.version = 1;
  }

  /** The value under a name, changed or not.  @param {string} name @returns {any} */
  value(name) {
    const [kind, number, ...rest] = name.split(".");
    if (this.changed.has(name)) return this.changed.get(name);
    if (kind === "ambient") return this.moment.ambient;
    if (kind === "light") return this.moment.lights[+number]?.values[rest[0]];
    const material = /** @type {any} */ (this.moment.materials[+number]);
    return rest[0] === "back" && material.both ? this.value(`material.${number}.front.${rest[1]}`) : material?.[rest[0]][rest[1]];
  }

  /** Change a value; undefined gives it back.  @param {string} name @param {Value | undefined} value */
  set(name, value) {
    if (value === undefined) this.changed.delete(name);
    else this.changed.set(name, value);
    this.version++;
  }

  /** Show another frame: what it sets to another value than the one before is no longer changed.  @param {Moment} moment */
  show(moment) {
    const changed = [...this.changed];
    this.changed.clear();
    const before = changed.map(([name]) => String(this.value(name)));
    this.moment = moment;
    changed.forEach(([name, value], k) => String(this.value(name)) === before[k] && this.changed.set(name, value));
    this.version++;
  }

  // ------------------------------------------------------------ the camera

  /** What the camera's turning does to eye space: turned about the centre, then moved by x and y.  @returns {Matrix} */
  get turned() {
    const { camera } = this.moment, { yaw, pitch, x, y } = this.orbit;
    if (!yaw && !pitch && !x && !y) return IDENTITY;
    return [translation([x, y, 0]), translation(camera.centre), rotation(pitch, [1, 0, 0]), rotation(yaw, camera.up),
      translation(camera.centre.map((value) => -value))].reduce((a, b) => multiply(a, b));
  }

  /** The projection of what turns.  @returns {Matrix} */
  get projection() {
    const projection = this.moment.camera.projections.find(({ turns }) => turns)?.matrix ?? IDENTITY;
    return multiply(this.#scaled, projection);
  }

  /** Zooming in makes all larger in clip space, about the middle: a smaller angle of view.  @returns {Matrix} */
  get #scaled() {
    const { zoom } = this.orbit;
    return zoom === 1 ? IDENTITY : [zoom, 0, 0, 0, 0, zoom, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  }

  /** gluLookAt's nine numbers for the camera as it is turned.  @returns {number[]} */
  get lookAt() {
    const view = multiply(this.turned, this.moment.camera.view), back = /** @type {Matrix} */ (inverse(view));
    const eye = transform(back, [0, 0, 0, 1]), distance = Math.hypot(...this.#centre());
    const at = transform(back, [0, 0, -distance, 1]), up = rotate(back, [0, 1, 0]);
    return [...eye.slice(0, 3), ...at.slice(0, 3), ...up];
  }

  #centre() {
    return transform(this.turned, [...this.moment.camera.centre, 1]).slice(0, 3);
  }

  /** Where a light is in eye space: x, y, z, w.  @param {number} number  in the list of lights @returns {Vector} */
  lightPosition(number) {
    return transform(this.#placed(number), this.value(`light.${number}.position`));
  }

  /** The value that puts a light at a place in eye space.  @param {number} number @param {Vector} place  x, y, z, w */
  lightValueAt(number, place) {
    const back = inverse(this.#placed(number));
    return back ? transform(back, place) : this.value(`light.${number}.position`);
  }

  /** @param {number} number @returns {Matrix} */
  #placed(number) {
    const light = this.moment.lights[number];
    return light.turnsPosition ? multiply(this.turned, light.position) : light.position;
  }

  // ------------------------------------------------------------ uniform blocks

  /** A uniform block's bytes with the present values.  @param {string} block @param {Uint8Array} bytes @returns {Uint8Array} */
  change(block, bytes) {
    const copy = bytes.slice(), view = new DataView(copy.buffer), { layout } = this;
    if (block === "Transforms") this.#transforms(view);
    if (block === "Materials")
      for (let at = 0; at < copy.length; at += layout.Material.size) {
        const number = this.moment.materials.findIndex(({ row }) => same(row, bytes, at));
        if (number >= 0) this.#material(view, number, at);
      }
    if (block === "Lights") {
      this.moment.lights.forEach(({ number, row }, k) => {
        const at = number * layout.Light.size;
        if (same(row, bytes, at)) this.#light(view, k, at);
      });
      const ambient = layout.Lights.I_a_scene;
      if (this.moment.ambient.every((value, k) => view.getFloat32(ambient + 4 * k, true) === Math.fround(value)))
        write(view, ambient, this.value("ambient"));
    }
    if (block === "Raster") this.#planes(view, layout.Raster.clip_planes, 6);
    if (block === "Texturing")
      for (let at = 0; at < copy.length; at += layout.Unit.size) this.#planes(view, at + layout.Unit.eye_plane, 4);
    return copy;
  }

  /** @param {DataView} view */
  #transforms(view) {
    const { modelview_projection, modelview, normal, size } = this.layout.Transform, turn = this.turned;
    if (turn === IDENTITY && this.#scaled === IDENTITY) return;
    for (let at = 0; at + size <= view.byteLength; at += size) {
      const M = read(view, at + modelview, 16), N = read(view, at + normal, 12);
      const projection = this.#projectionOf(M, read(view, at + modelview_projection, 16));
      if (!projection?.turns) continue;
      const turned = multiply(turn, M);
      write(view, at + modelview, turned);
      write(view, at + modelview_projection, multiply(multiply(this.#scaled, projection.matrix), turned));
      for (let column = 0; column < 3; column++) // a turn's inverse transpose is the turn itself
        write(view, at + normal + 16 * column, rotate(turn, N.slice(4 * column, 4 * column + 3)));
    }
  }

  /** Which of the frame's projections makes P from M.  @param {Matrix} M @param {Matrix} P */
  #projectionOf(M, P) {
    const off = ({ matrix } = { matrix: IDENTITY }) => Math.hypot(...multiply(matrix, M).map((value, k) => value - P[k]));
    return [...this.moment.camera.projections].sort((a, b) => off(a) - off(b))[0];
  }

  /** @param {DataView} view @param {number} number @param {number} at */
  #material(view, number, at) {
    for (const face of ["front", "back"])
      for (const [name, member] of Object.entries(FACE))
        write(view, at + this.layout.Material[face] + this.layout.Face[member], this.value(`material.${number}.${face}.${name}`));
  }

  /** @param {DataView} view @param {number} number @param {number} at */
  #light(view, number, at) {
    const { Light } = this.layout, light = this.moment.lights[number], [x, y, z, w] = this.lightPosition(number);
    for (const [name, member] of Object.entries(LIGHT)) write(view, at + Light[member], this.value(`light.${number}.${name}`));
    write(view, at + Light.position, w ? [x / w, y / w, z / w, w] : [...unit([x, y, z]), w]);
    const direction = rotate(light.direction, this.value(`light.${number}.spot_direction`));
    write(view, at + Light.spot_direction, unit(light.turnsDirection ? rotate(this.turned, direction) : direction));
    const cutoff = this.value(`light.${number}.spot_cutoff`);
    write(view, at + Light.cos_spot_cutoff, cutoff === 180 ? -2 : Math.cos((cutoff * Math.PI) / 180));
    if (cutoff === 180) write(view, at + Light.spot_exponent, 0); // no spot: it shines everywhere alike
  }

  /** Planes in eye space: p becomes p times the inverse of the turn.  @param {DataView} view @param {number} at @param {number} count */
  #planes(view, at, count) {
    const back = this.turned === IDENTITY ? null : inverse(this.turned);
    for (let k = 0; back && k < count; k++, at += 16) {
      const plane = read(view, at, 4);
      write(view, at, [0, 1, 2, 3].map((column) => plane.reduce((sum, value, row) => sum + value * back[4 * column + row], 0)));
    }
  }
}

/** Whether these bytes stand in others.  @param {Uint8Array} row @param {Uint8Array} bytes @param {number} at */
function same(row, bytes, at) {
  return at + row.length <= bytes.length && row.every((value, k) => bytes[at + k] === value);
}

/** @param {DataView} view @param {number} at @param {number} count */
function read(view, at, count) {
  return Array.from({ length: count }, (_, k) => view.getFloat32(at + 4 * k, true));
}

/** @param {DataView} view @param {number} at @param {Value} value */
function write(view, at, value) {
  (typeof value === "number" ? [value] : value).forEach((number, k) => view.setFloat32(at + 4 * k, number, true));
}
