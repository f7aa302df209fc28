/**
 * Reading a tape, whose format glsim/render/tape.py describes, and planning what is drawn for one of its pictures.
 *
 * A tape says in which order buffers are filled and drawn with.  A plan says for each draw which data its buffers hold
 * at that moment, so that data are known by their number alone, are uploaded once, and serve all pictures.
 *
 * @typedef {{name: string, operations: any[][]}} Picture
 * @typedef {[string, number, "f" | "u", number]} Input  name, components, kind, offset in bytes
 * @typedef {{blob: number, stride: number, perInstance: number, inputs: Input[]}} Part
 * @typedef {{binding: number, blob: number, offset: number, size: number}} Block  a uniform block and its data
 * @typedef {{vertex: number, fragment: number}} Program  the blobs with its texts
 * @typedef {{target: number, level: number, internal: number, size: number[], format: number, type: number, blob: number}} Image
 * @typedef {{target: number, images: Map<string, Image>, parameters: Map<number, number>}} Texture
 * @typedef {{kind: "state", name: string, values: number[]}} State
 * @typedef {{kind: "texture", unit: number, texture: Texture}} Bind
 * @typedef {{kind: "parameter", texture: Texture, name: number, value: number, integer: boolean}} Parameter
 * @typedef {{kind: "draw", program: Program, parts: Part[], indices: number, mode: number, count: number, first: number,
 *   instances: number, blocks: Block[]}} Draw
 * @typedef {State | Bind | Parameter | Draw} Step
 * @typedef {{programs: Program[], steps: Step[], draws: Draw[]}} Plan
 */

const MAGIC = "glsimtap", VERSION = 1, HEADER = 16;
const CUBE_MAP = 0x8513, CUBE_FACES = 0x8515; // the first of six targets

/** Instead of a blob: a buffer that nothing was written to.  A program may have the block, but does not read it. */
export const EMPTY = -1;

export class TapeError extends Error {}

/** The data of a tape.  blobs: the data by number; names: their SHA-256, shortened. */
export class Tape {
  /** @param {Uint8Array} bytes  Throws a TapeError if they are no tape. */
  constructor(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength), text = new TextDecoder();
    if (bytes.length < HEADER || text.decode(bytes.subarray(0, 8)) !== MAGIC)
      throw new TapeError("These bytes are no tape of glsim.");
    if (view.getUint32(8, true) !== VERSION)
      throw new TapeError(`This tape has version ${view.getUint32(8, true)} of the format; version ${VERSION} is known.`);
    let at = HEADER + view.getUint32(12, true);
    const head = read(text.decode(bytes.subarray(HEADER, at)));
    /** @type {number} */ this.width = head.width;
    /** @type {number} */ this.height = head.height;
    /** @type {number} */ this.samples = head.samples;
    /** @type {Record<string, number>} */ this.bindings = head.bindings;
    /** @type {Record<string, number>} */ this.samplers = head.samplers;
    /** @type {string} */ this.es = head.es;
    /** @type {Picture[]} */ this.pictures = head.pictures;
    /** @type {Uint8Array[]} */ this.blobs = [];
    /** @type {string[]} */ this.names = [];
    for (const [name, length] of head.blobs) {
      this.blobs.push(bytes.subarray(at, at + length));
      this.names.push(name);
      at += Math.ceil(length / 4) * 4;
    }
    if (at !== bytes.length) throw new TapeError("This tape is cut off.");
  }

  /** The text that a blob is.  @param {number} blob */
  text(blob) {
    return new TextDecoder().decode(this.blobs[blob]);
  }
}

/** A tape's head.  @param {string} text */
function read(text) {
  try {
    const head = JSON.parse(text);
    if (Array.isArray(head.blobs) && Array.isArray(head.pictures)) return head;
  } catch { /* no JSON */ }
  throw new TapeError("This tape is damaged: its head cannot be read.");
}

/** What is drawn for the picture with this number.  Throws a TapeError if its operations make no sense.
 * @param {Tape} tape @param {number} number @returns {Plan} */
export function planned(tape, number) {
  try {
    return new Planner().plan(tape.pictures[number].operations);
  } catch (error) {
    throw new TapeError(`This tape is damaged: picture ${number} cannot be planned (${error}).`);
  }
}

class Planner {
  constructor() {
    /** @type {Map<number, number>} */ this.content = new Map(); // buffer -> blob
    /** @type {Map<number, Program>} */ this.programs = new Map();
    /** @type {Map<number, {program: Program, parts: any[][], indices: number}>} */ this.arrays = new Map();
    /** @type {Map<number, Texture>} */ this.textures = new Map();
    /** @type {Map<string, number>} */ this.bound = new Map(); // "unit target" -> texture
    /** @type {Map<number, {buffer: number, offset: number, size: number}>} */ this.blocks = new Map();
    this.unit = 0;
    /** @type {Step[]} */ this.steps = [];
  }

  /** @param {any[][]} operations @returns {Plan} */
  plan(operations) {
    for (const [name, ...values] of operations) this.#operation(name, values);
    const draws = /** @type {Draw[]} */ (this.steps.filter((step) => step.kind === "draw"));
    return { programs: [...this.programs.values()], steps: this.steps, draws };
  }

  /** @param {string} name @param {any[]} values */
  #operation(name, values) {
    switch (name) {
      case "buffer": break; // only its content matters
      case "write": this.content.set(values[0], values[1]); break;
      case "uniform": this.blocks.set(values[0], { buffer: values[1], offset: values[2], size: values[3] }); break;
      case "program": this.programs.set(values[0], { vertex: values[3], fragment: values[4] }); break;
      case "array": this.#array(values); break;
      case "draw": this.#draw(values); break;
      case "texture": this.#texture(values); break;
      case "image": this.#image(values); break;
      case "glTexParameteri": case "glTexParameterf": this.#parameter(values, name.endsWith("i")); break;
      case "glTexParameterfv": case "glDeleteTextures": break; // GL_TEXTURE_BORDER_COLOR: texture.glsl knows it
      default: this.steps.push({ kind: "state", name: name[2].toLowerCase() + name.slice(3), values });
    }
  }

  /** @param {any[]} values */
  #array([number, program, parts, indices]) {
    this.arrays.set(number, { program: /** @type {Program} */ (this.programs.get(program)), parts, indices });
  }

  /** @param {number[]} values */
  #draw([number, mode, count, first, instances]) {
    const { program, parts, indices } = /** @type {any} */ (this.arrays.get(number));
    const blob = (/** @type {number} */ buffer) => /** @type {number} */ (this.content.get(buffer));
    this.steps.push({
      kind: "draw", program, mode, count, first, instances, indices: blob(indices),
      parts: parts.map((/** @type {any[]} */ [buffer, stride, perInstance, inputs]) =>
        ({ blob: blob(buffer), stride, perInstance, inputs })),
      blocks: [...this.blocks].map(([binding, { buffer, offset, size }]) =>
        ({ binding, blob: blob(buffer) ?? EMPTY, offset, size })),
    });
  }

  /** @param {number[]} values */
  #texture([unit, target, number]) {
    if (!this.textures.has(number)) this.textures.set(number, { target, images: new Map(), parameters: new Map() });
    this.unit = unit;
    this.bound.set(`${unit} ${target}`, number);
    this.#bind(number);
  }

  /** @param {number} number */
  #bind(number) {
    this.steps.push({ kind: "texture", unit: this.unit, texture: /** @type {Texture} */ (this.textures.get(number)) });
  }

  /** An image of the bound texture.  Where there is one already, a new texture takes the place of the old one.
   * @param {any[]} values */
  #image([target, level, internal, size, format, type, blob]) {
    const kind = target >= CUBE_FACES && target < CUBE_FACES + 6 ? CUBE_MAP : target;
    const number = /** @type {number} */ (this.bound.get(`${this.unit} ${kind}`)), key = `${target} ${level}`;
    let texture = /** @type {Texture} */ (this.textures.get(number));
    if (texture.images.has(key)) {
      texture = { target: kind, images: new Map(texture.images), parameters: new Map(texture.parameters) };
      this.textures.set(number, texture);
      this.#bind(number);
    }
    texture.images.set(key, { target, level, internal, size, format, type, blob });
  }

  /** @param {number[]} values @param {boolean} integer */
  #parameter([target, name, value], integer) {
    const texture = /** @type {Texture} */ (this.textures.get(/** @type {number} */ (this.bound.get(`${this.unit} ${target}`))));
    texture.parameters.set(name, value);
    this.steps.push({ kind: "parameter", texture, name, value, integer });
  }
}
