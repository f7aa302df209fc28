/**
 * Blending that WebGL2 lacks, in the fragment shader: logic operations, and factors that mix the constant colour with
 * its alpha.  The shader reads what is there (the destination) from a copy of the picture.
 */

export const DESTINATION_UNIT = 5; // a texture unit behind those of tapes
const CONSTANT_COLOR = 0x8001, ONE_MINUS_CONSTANT_COLOR = 0x8002, CONSTANT_ALPHA = 0x8003, ONE_MINUS_CONSTANT_ALPHA = 0x8004;

// glLogicOp from GL_CLEAR on: of s, what the fragment brings, and d, what is there (OpenGL 1.5 table 4.2)
const OPERATIONS = ["0", "s & d", "s & ~d", "s", "~s & d", "d", "s ^ d", "s | d", "~(s | d)", "~(s ^ d)", "~d", "s | ~d",
  "~s", "~s | d", "~(s & d)", "255"];
const CLEAR = 0x1500;

/** glBlendFunc's factors (table 4.1) @type {Record<number, string>} */
const FACTORS = {
  0: "vec4(0)", 1: "vec4(1)", 0x300: "s", 0x301: "1. - s", 0x302: "s.aaaa", 0x303: "1. - s.aaaa", 0x304: "d.aaaa",
  0x305: "1. - d.aaaa", 0x306: "d", 0x307: "1. - d", 0x308: "vec4(vec3(min(s.a, 1. - d.a)), 1)", [CONSTANT_COLOR]: "c",
  [ONE_MINUS_CONSTANT_COLOR]: "1. - c", [CONSTANT_ALPHA]: "c.aaaa", [ONE_MINUS_CONSTANT_ALPHA]: "1. - c.aaaa",
};
/** glBlendEquation @type {Record<number, string>} */
const EQUATIONS = {
  0x8006: "s * S + d * D", 0x800a: "s * S - d * D", 0x800b: "d * D - s * S", 0x8007: "min(s, d)", 0x8008: "max(s, d)",
};

/** The blending state, and a copy of the picture. */
export class Blending {
  /** @param {WebGL2RenderingContext} gl @param {number} width @param {number} height */
  constructor(gl, width, height) {
    this.gl = gl;
    this.width = width;
    this.height = height;
    this.enabled = false;
    this.logical = false;
    this.operation = CLEAR;
    this.equation = 0x8006;
    /** @type {number[]} */ this.color = [0, 0, 0, 0];
    /** source and destination, of colours and of alpha @type {number[]} */ this.factors = [1, 0, 1, 0];
    /** @type {WebGLTexture?} */ this.texture = null;
  }

  /** Whether WebGL2 refuses the factors: constant colour and constant alpha together. */
  get mixed() {
    const [source, destination] = this.factors;
    const color = (/** @type {number} */ factor) => factor === CONSTANT_COLOR || factor === ONE_MINUS_CONSTANT_COLOR;
    const alpha = (/** @type {number} */ factor) => factor === CONSTANT_ALPHA || factor === ONE_MINUS_CONSTANT_ALPHA;
    return (color(source) && alpha(destination)) || (alpha(source) && color(destination));
  }

  emulated() {
    return this.logical || (this.enabled && this.mixed);
  }

  /** @param {number[]} factors */
  setFactors(factors) {
    this.factors = factors;
    if (!this.mixed) this.gl.blendFuncSeparate(factors[0], factors[1], factors[2], factors[3]);
  }

  /** @param {boolean} on */
  setEnabled(on) {
    this.enabled = on;
    if (on) this.gl.enable(this.gl.BLEND);
    else this.gl.disable(this.gl.BLEND);
  }

  /** Copy the picture to the texture that the shader reads.
   * @param {WebGLFramebuffer} target @param {WebGLFramebuffer?} resolved  for a target with samples */
  copy(target, resolved) {
    const { gl, width, height } = this;
    gl.activeTexture(gl.TEXTURE0 + DESTINATION_UNIT);
    if (!this.texture) {
      this.texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, this.texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
      for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    }
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    if (resolved) {
      const scissor = gl.isEnabled(gl.SCISSOR_TEST);
      gl.disable(gl.SCISSOR_TEST);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, resolved);
      gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
      if (scissor) gl.enable(gl.SCISSOR_TEST);
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, resolved);
    }
    gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
  }
}

/** What stands behind a fragment shader, whose main is called glsim_main.  @param {Blending} blending */
export function destinationShader({ logical, operation, factors, equation, color }) {
  const [source, destination, sourceAlpha, destinationAlpha] = factors.map((factor) => FACTORS[factor]);
  const blended = `vec4 c = vec4(${color.map((value) => value.toFixed(9)).join(", ")});
    vec4 S = vec4((${source}).rgb, (${sourceAlpha}).a), D = vec4((${destination}).rgb, (${destinationAlpha}).a);
    fragment_color = ${EQUATIONS[equation]};`;
  const combined = `ivec4 s = ivec4(clamp(fragment_color, 0.0, 1.0) * 255.0 + 0.5), d = ivec4(there * 255.0 + 0.5);
    fragment_color = vec4((${logical ? OPERATIONS[operation - CLEAR].replace(/^(0|255)$/, "ivec4($1)") : ""}) & 255) / 255.0;`;
  return `uniform highp sampler2D destination;
void main() {
    glsim_main();
    vec4 there = texelFetch(destination, ivec2(gl_FragCoord.xy), 0);
    ${logical ? combined : `vec4 s = fragment_color, d = there;\n    ${blended}`}
}
`;
}
