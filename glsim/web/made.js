/**
 * Everything that lives in a WebGL2 context, and goes with it: framebuffers, programs, buffers, textures.
 *
 * @typedef {import("./tape.js").Tape} Tape
 * @typedef {import("./tape.js").Draw} Draw
 * @typedef {import("./tape.js").Program} Program
 * @typedef {import("./tape.js").Texture} Texture
 * @typedef {{program: WebGLProgram, shaders: WebGLShader[], inputs: Map<string, number>?,
 *   arrays: WeakMap<Draw, WebGLVertexArrayObject>}} Linked
 * @typedef {{size: number, patched: number, gl: WebGLBuffer}} Uploaded
 */
import { Blending } from "./destination.js";

const EXTENSIONS = ["EXT_color_buffer_float", "OES_texture_float_linear", "KHR_parallel_shader_compile"];

export class Made {
  /** @param {WebGL2RenderingContext} gl @param {Tape} tape */
  constructor(gl, { width, height, samples }) {
    for (const name of EXTENSIONS) gl.getExtension(name);
    this.depthClamp = gl.getExtension("EXT_depth_clamp");
    /** By program, then by the added text. @type {WeakMap<Program, Map<string, Linked>>} */
    this.programs = new WeakMap();
    /** By the texts: programs of several pictures may have the same. @type {Map<string, Linked>} */ this.byText = new Map();
    /** @type {Map<string, Uploaded>} */ this.buffers = new Map();
    /** @type {WeakMap<Texture, WebGLTexture>} */ this.textures = new WeakMap();
    this.samples = Math.min(samples, gl.getParameter(gl.MAX_SAMPLES));
    this.target = this.#framebuffer(gl, width, height, this.samples);
    this.resolved = this.samples ? this.#framebuffer(gl, width, height, 0) : this.target;
    this.blending = new Blending(gl, width, height);
  }

  /** @param {WebGL2RenderingContext} gl @param {number} width @param {number} height @param {number} samples */
  #framebuffer(gl, width, height, samples) {
    const framebuffer = /** @type {WebGLFramebuffer} */ (gl.createFramebuffer());
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    for (const [format, attachment] of [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH24_STENCIL8, gl.DEPTH_STENCIL_ATTACHMENT]]) {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, samples, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
    }
    return framebuffer;
  }
}
