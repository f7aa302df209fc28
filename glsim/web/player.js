/**
 * Draws the pictures of a tape with WebGL2, by the GLSL that glsim draws with.
 *
 *     const player = new Player(canvas, tape);
 *     await player.prepare(planned(tape, 0));
 *     player.draw(planned(tape, 0));
 *
 * What OpenGL has and WebGL2 lacks is done in another way (LACKING), or the player's ``gaps`` say it in a sentence: no
 * picture is wrong in silence.
 *
 * @typedef {import("./tape.js").Tape} Tape
 * @typedef {import("./tape.js").Plan} Plan
 * @typedef {import("./tape.js").Draw} Draw
 * @typedef {import("./tape.js").Part} Part
 * @typedef {import("./tape.js").Program} Program
 * @typedef {import("./tape.js").Texture} Texture
 * @typedef {import("./made.js").Linked} Linked
 */
import { EMPTY } from "./tape.js";
import { DESTINATION_UNIT, destinationShader } from "./destination.js";
import { Made } from "./made.js";

/** A sentence for people: what is missing, and what they can do. */
export class PlayerError extends Error {}

const NO_WEBGL2 = "This browser has no WebGL2, with which the picture is drawn. Try a current Firefox, Chrome, Edge or Safari,"
  + " or turn on hardware acceleration in its settings.";
const COMPLETED = 0x91b1; // COMPLETION_STATUS_KHR
const GAPS = {
  alphaToOne: "GL_SAMPLE_ALPHA_TO_ONE beside GL_SAMPLE_ALPHA_TO_COVERAGE: WebGL2 lacks it; alpha stays as it is.",
  singleSample: "glDisable(GL_MULTISAMPLE): in WebGL2 a picture with samples is always multisampled.",
  depthClamp: "Wide lines that the near or far plane cuts: this browser lacks EXT_depth_clamp, so they may end early.",
  border: "GL_CLAMP or GL_CLAMP_TO_BORDER with mipmaps: WebGL2 has no borders; in the smaller levels the border is too sharp.",
  overlap: "A logic operation on more than 256 primitives at once: where they overlap, only the last one counts.",
  clipped: "glClipPlane on a picture with samples: WebGL2 cuts whole pixels, so edges that a plane makes are not smooth.",
  samples: "A logic operation on a picture with samples: the picture is drawn with one sample.",
};
// capabilities that are always on, or done in the shader
const ALWAYS = new Set([0x8642, 0x884f]);
const CLIP_PLANES = new Set([0x3000, 0x3001, 0x3002, 0x3003, 0x3004, 0x3005]);
const DEPTH_CLAMP = 0x864f, MULTISAMPLE = 0x809d, ALPHA_TO_COVERAGE = 0x809e, ALPHA_TO_ONE = 0x809f, COLOR_LOGIC_OP = 0x0bf2;
const OPAQUE = "void main() { glsim_main(); fragment_color.a = 1.0; }\n";
const LOD_BIAS = 0x8501, BORDER = 0x812d, EDGE = 0x812f;
const DEPTH24 = 0x81a6;

export class Player {
  /**
   * @param {HTMLCanvasElement} canvas  gets the tape's size.  Throws a PlayerError without WebGL2.
   * @param {Tape} tape
   */
  constructor(canvas, tape) {
    const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, preserveDrawingBuffer: true });
    if (!gl) throw new PlayerError(NO_WEBGL2);
    this.gl = gl;
    this.canvas = canvas;
    this.tape = tape;
    Object.assign(canvas, { width: tape.width, height: tape.height });
    /** Sentences about what the last picture shows otherwise than OpenGL would. @type {Set<string>} */
    this.gaps = new Set();
    /** Changes a uniform block's bytes before they are used; same version, same change.
     * @type {{version: number, change: (block: string, bytes: Uint8Array) => Uint8Array}?} */
    this.patch = null;
    /** Vertex data that stand for those of a blob. @type {Map<number, Uint8Array>} */
    this.replaced = new Map();
    this.depthReversed = false;
    this.opaque = false; // GL_SAMPLE_ALPHA_TO_ONE
    /** Called when the context is lost and when it is back: then the picture must be drawn again. @type {(lost: boolean) => void} */
    this.oncontext = () => {};
    canvas.addEventListener("webglcontextlost", (event) => (event.preventDefault(), this.oncontext(true)));
    canvas.addEventListener("webglcontextrestored", () => ((this.made = new Made(gl, tape)), this.oncontext(false)));
    this.made = new Made(gl, tape);
  }

  // ------------------------------------------------------------ programs

  /** Compile what the plans need; a driver that can does it while the page goes on.
   * @param {...Plan} plans @returns {Promise<void>}  Rejects with a PlayerError if a program does not compile. */
  async prepare(...plans) {
    const linked = plans.flatMap((plan) => plan.programs.map((program) => this.#linked(program, "", "")));
    const gl = this.gl;
    if (gl.getExtension("KHR_parallel_shader_compile"))
      while (!gl.isContextLost() && !linked.every(({ program }) => gl.getProgramParameter(program, COMPLETED)))
        await new Promise((resume) => setTimeout(resume, 4));
    if (!gl.isContextLost()) linked.forEach((one) => this.#inputs(one));
  }

  /** A program with text appended to its shaders, compiled when it is first wanted.
   * @param {Program} program @param {string} vertexEnd @param {string} fragmentEnd @returns {Linked} */
  #linked(program, vertexEnd, fragmentEnd) {
    const variants = this.made.programs.get(program) ?? new Map();
    const variant = vertexEnd + fragmentEnd;
    let linked = variants.get(variant);
    if (!linked) {
      const texts = [this.#text(program.vertex, vertexEnd), this.#text(program.fragment, fragmentEnd)];
      linked = this.made.byText.get(texts.join("\0")) ?? this.#compiled(texts);
      this.made.byText.set(texts.join("\0"), linked);
      this.made.programs.set(program, variants.set(variant, linked));
    }
    return linked;
  }

  /** @param {string[]} texts  of the vertex and of the fragment shader @returns {Linked} */
  #compiled(texts) {
    const gl = this.gl, program = /** @type {WebGLProgram} */ (gl.createProgram());
    const shaders = texts.map((text, stage) => {
      const shader = /** @type {WebGLShader} */ (gl.createShader(stage ? gl.FRAGMENT_SHADER : gl.VERTEX_SHADER));
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      return shader;
    });
    gl.linkProgram(program);
    return { program, shaders, inputs: null, arrays: new WeakMap() };
  }

  /** A shader's text; ``end`` stands behind it and calls the shader's main as glsim_main.
   * @param {number} blob @param {string} end */
  #text(blob, end) {
    const text = this.tape.text(blob);
    return this.tape.es + (end ? `#define main glsim_main\n${text}\n#undef main\n${end}` : text);
  }

  /** The inputs' places; blocks and samplers get the tape's numbers.  @param {Linked} linked @returns {Map<string, number>} */
  #inputs(linked) {
    if (linked.inputs) return linked.inputs;
    const gl = this.gl, { program, shaders } = linked;
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new PlayerError("A program of this picture does not compile here: "
        + shaders.map((shader) => gl.getShaderInfoLog(shader)).join(" ") + gl.getProgramInfoLog(program));
    for (const [name, binding] of Object.entries(this.tape.bindings)) {
      const index = gl.getUniformBlockIndex(program, name);
      if (index !== gl.INVALID_INDEX) gl.uniformBlockBinding(program, index, binding);
    }
    gl.useProgram(program);
    for (const [name, unit] of Object.entries(this.tape.samplers)) gl.uniform1i(gl.getUniformLocation(program, name), unit);
    gl.uniform1i(gl.getUniformLocation(program, "destination"), DESTINATION_UNIT);
    linked.inputs = new Map();
    for (let k = gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES) - 1; k >= 0; k--) {
      const { name } = /** @type {WebGLActiveInfo} */ (gl.getActiveAttrib(program, k));
      const place = gl.getAttribLocation(program, name);
      if (place >= 0) linked.inputs.set(name, place);
    }
    return linked.inputs;
  }

  // ------------------------------------------------------------ drawing

  /** Draw a plan's picture and show it.  Programs that are not ready are waited for.  @param {...Plan} plans  one over the other */
  draw(...plans) {
    const gl = this.gl;
    if (gl.isContextLost()) return;
    this.gaps.clear();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.made.target);
    this.#clear();
    for (const { steps } of plans)
      for (const step of steps) {
        if (step.kind === "state") this.#state(step.name, step.values);
        else if (step.kind === "texture") this.#bind(step.unit, step.texture);
        else if (step.kind === "parameter") this.#parameter(step.texture.target, step.name, step.value, step.integer);
        else this.#draw(step);
      }
    this.#show();
  }

  /** OpenGL's initial state, as far as a picture may leave another, and an empty picture. */
  #clear() {
    const gl = this.gl;
    gl.disable(gl.SCISSOR_TEST);
    gl.colorMask(true, true, true, true);
    gl.depthMask(true);
    gl.stencilMask(0xffffffff);
    gl.clearColor(0, 0, 0, 0);
    gl.clearDepth(1);
    gl.clearStencil(0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    this.depthReversed = this.opaque = false;
    this.made.blending.logical = false;
  }

  /** A command that sets state.  @param {string} name @param {number[]} values */
  #state(name, values) {
    const gl = /** @type {any} */ (this.gl), [first, ...rest] = values;
    if (name === "provokingVertex") return; // the last vertex, as always in WebGL2
    if (name === "enable" || name === "disable") this.#switch(first, name === "enable");
    else if (name === "logicOp") this.made.blending.operation = first;
    else if (name === "depthRange") {
      this.depthReversed = first > rest[0]; // which WebGL2 forbids: the vertex shader turns depth round
      gl.depthRange(Math.min(first, rest[0]), Math.max(first, rest[0]));
    } else if (name === "blendFuncSeparate") this.made.blending.setFactors(values);
    else if (name === "blendEquation") gl.blendEquation((this.made.blending.equation = first));
    else if (name === "blendColor") gl.blendColor(...(this.made.blending.color = values));
    else if (name === "colorMask" || name === "depthMask") gl[name](...values.map(Boolean));
    else if (name === "sampleCoverage") gl.sampleCoverage(first, Boolean(rest[0]));
    else gl[name](...values);
  }

  /** @param {number} capability @param {boolean} on */
  #switch(capability, on) {
    const gl = this.gl;
    if (capability === COLOR_LOGIC_OP) this.made.blending.logical = on;
    else if (capability === gl.BLEND) this.made.blending.setEnabled(on);
    else if (capability === DEPTH_CLAMP) {
      if (this.made.depthClamp) on ? gl.enable(DEPTH_CLAMP) : gl.disable(DEPTH_CLAMP);
      else if (on) this.gaps.add(GAPS.depthClamp);
    } else if (capability === MULTISAMPLE) on || !this.made.samples || this.gaps.add(GAPS.singleSample);
    else if (CLIP_PLANES.has(capability)) on && this.made.samples && this.gaps.add(GAPS.clipped);
    else if (capability === ALPHA_TO_ONE) this.opaque = on && this.made.samples > 0;
    else if (!ALWAYS.has(capability)) on ? gl.enable(capability) : gl.disable(capability);
  }

  /** @param {Draw} draw */
  #draw(draw) {
    const gl = this.gl, emulated = this.made.blending.emulated();
    const opaque = this.opaque && !gl.isEnabled(ALPHA_TO_COVERAGE);
    if (this.opaque && (emulated || !opaque)) this.gaps.add(GAPS.alphaToOne);
    const linked = this.#linked(draw.program,
      this.depthReversed ? "void main() { glsim_main(); gl_Position.z = -gl_Position.z; }\n" : "",
      emulated ? destinationShader(this.made.blending) : opaque ? OPAQUE : "");
    this.#inputs(linked);
    gl.useProgram(linked.program);
    gl.bindVertexArray(this.#array(draw, linked));
    for (const { binding, blob, offset, size } of draw.blocks)
      gl.bindBufferRange(gl.UNIFORM_BUFFER, binding, this.#block(binding, blob, offset + size), offset, size);
    if (emulated) this.#emulated(draw);
    else this.#call(draw, draw.first, draw.count);
    gl.bindVertexArray(null);
  }

  /** @param {Draw} draw @param {number} first @param {number} count */
  #call({ mode, instances }, first, count) {
    const gl = this.gl;
    if (instances > 1) gl.drawElementsInstanced(mode, count, gl.UNSIGNED_INT, 4 * first, instances);
    else gl.drawElements(mode, count, gl.UNSIGNED_INT, 4 * first);
  }

  /** Blending in the shader, which reads a copy of the picture: one primitive at a time, as they may overlap.
   * @param {Draw} draw */
  #emulated(draw) {
    const corners = draw.mode === this.gl.TRIANGLES ? 3 : draw.mode + 1;
    const many = draw.count / corners > 256 || draw.instances > 1, step = many ? draw.count : corners;
    if (many) this.gaps.add(GAPS.overlap);
    if (this.made.samples) this.gaps.add(GAPS.samples);
    this.gl.disable(this.gl.BLEND);
    for (let first = 0; first < draw.count; first += step) {
      this.made.blending.copy(this.made.target, this.made.samples ? this.made.resolved : null);
      this.#call(draw, draw.first + first, step);
    }
    this.made.blending.setEnabled(this.made.blending.enabled);
  }

  // ------------------------------------------------------------ data

  /** @param {Draw} draw @param {Linked} linked */
  #array(draw, linked) {
    let array = linked.arrays.get(draw);
    if (array) return array;
    const gl = this.gl, inputs = this.#inputs(linked);
    array = /** @type {WebGLVertexArrayObject} */ (gl.createVertexArray());
    gl.bindVertexArray(array);
    for (const { blob, stride, perInstance, inputs: list } of draw.parts) {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffer(gl.ARRAY_BUFFER, blob));
      for (const [name, components, kind, offset] of list) {
        const place = inputs.get(name);
        if (place === undefined) continue;
        gl.enableVertexAttribArray(place);
        if (kind === "u") gl.vertexAttribIPointer(place, components, gl.UNSIGNED_INT, stride, offset);
        else gl.vertexAttribPointer(place, components, gl.FLOAT, false, stride, offset);
        gl.vertexAttribDivisor(place, perInstance);
      }
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.#buffer(gl.ELEMENT_ARRAY_BUFFER, draw.indices));
    linked.arrays.set(draw, array);
    return array;
  }

  /** A blob in a buffer: uploaded once.  @param {number} target @param {number} blob */
  #buffer(target, blob) {
    const gl = this.gl, key = `${target} ${blob}`;
    let uploaded = this.made.buffers.get(key);
    if (!uploaded) {
      uploaded = { size: 0, patched: 0, gl: /** @type {WebGLBuffer} */ (gl.createBuffer()) };
      this.made.buffers.set(key, uploaded);
      gl.bindBuffer(target, uploaded.gl);
      gl.bufferData(target, this.replaced.get(blob) ?? this.tape.blobs[blob], gl.STATIC_DRAW);
    }
    return uploaded.gl;
  }

  /** Let other vertex data stand for a blob's from now on.  @param {number} blob @param {Uint8Array} bytes */
  replace(blob, bytes) {
    const gl = this.gl, uploaded = this.made.buffers.get(`${gl.ARRAY_BUFFER} ${blob}`);
    this.replaced.set(blob, bytes);
    if (!uploaded) return;
    gl.bindBuffer(gl.ARRAY_BUFFER, uploaded.gl);
    gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.DYNAMIC_DRAW);
  }

  /** The data of a uniform block, with ``size`` bytes at least.  @param {number} binding @param {number} blob @param {number} size */
  #block(binding, blob, size) {
    const gl = this.gl, key = `${binding} ${blob}`, version = this.patch?.version ?? 0;
    let uploaded = this.made.buffers.get(key);
    if (!uploaded || uploaded.size < size || uploaded.patched !== version) {
      const block = Object.keys(this.tape.bindings).find((name) => this.tape.bindings[name] === binding) ?? "";
      const bytes = blob === EMPTY ? new Uint8Array() : this.tape.blobs[blob];
      const changed = this.patch ? this.patch.change(block, bytes) : bytes;
      uploaded ??= { size: 0, patched: 0, gl: /** @type {WebGLBuffer} */ (gl.createBuffer()) };
      uploaded.size = Math.max(uploaded.size, size, bytes.length);
      uploaded.patched = version;
      const filled = new Uint8Array(uploaded.size);
      filled.set(changed);
      gl.bindBuffer(gl.UNIFORM_BUFFER, uploaded.gl);
      gl.bufferData(gl.UNIFORM_BUFFER, filled, gl.DYNAMIC_DRAW);
      this.made.buffers.set(key, uploaded);
    }
    return uploaded.gl;
  }

  // ------------------------------------------------------------ textures

  /** @param {number} unit @param {Texture} texture */
  #bind(unit, texture) {
    const gl = this.gl, known = this.made.textures.get(texture), name = known ?? /** @type {WebGLTexture} */ (gl.createTexture());
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(texture.target, name);
    const { parameters } = texture, mipmapped = (parameters.get(gl.TEXTURE_MIN_FILTER) ?? 0) >= gl.NEAREST_MIPMAP_NEAREST;
    if (mipmapped && [...parameters.values()].includes(BORDER)) this.gaps.add(GAPS.border);
    if (known) return;
    this.made.textures.set(texture, name);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    for (const { target, level, internal, size, format, type, blob } of texture.images.values()) {
      const bytes = this.tape.blobs[blob];
      const data = type === gl.FLOAT ? new Float32Array(bytes.slice().buffer) : bytes;
      const kept = internal === DEPTH24 ? gl.DEPTH_COMPONENT32F : internal; // WebGL2 takes no floats for 24 bits
      if (size.length === 3) gl.texImage3D(target, level, kept, size[0], size[1], size[2], 0, format, type, data);
      else gl.texImage2D(target, level, kept, size[0], size[1], 0, format, type, data);
    }
    for (const [parameter, value] of texture.parameters) this.#parameter(texture.target, parameter, value, Number.isInteger(value));
  }

  /** Of the bound texture; what WebGL2 lacks, texture.glsl does.
   * @param {number} target @param {number} name @param {number} value @param {boolean} integer */
  #parameter(target, name, value, integer) {
    const gl = this.gl;
    if (name === LOD_BIAS) return;
    if (integer) gl.texParameteri(target, name, value === BORDER ? EDGE : value);
    else gl.texParameterf(target, name, value);
  }

  // ------------------------------------------------------------ the picture

  #resolve() {
    const gl = this.gl, { width, height } = this.tape;
    if (!this.made.samples) return;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.made.target);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.made.resolved);
    gl.disable(gl.SCISSOR_TEST);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  }

  /** Copy the picture to the canvas. */
  #show() {
    const gl = this.gl, { width, height } = this.tape;
    this.#resolve();
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.made.resolved);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.disable(gl.SCISSOR_TEST);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  }

  /** Give the context back: a browser has no more than about 16.  Nothing can be drawn afterwards. */
  release() {
    this.oncontext = () => {};
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  /** The picture: RGBA of 8 bits, bottom row first. */
  pixels() {
    const gl = this.gl, { width, height } = this.tape, pixels = new Uint8Array(4 * width * height);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.made.resolved);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  }
}
