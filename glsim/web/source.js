/**
 * The changed values as lines of the program: literal source that can be copied.
 * @typedef {import("./scene.js").Scene} Scene
 */

/** @type {Record<string, string>} */
const SHADE_MODELS = { flat: "GL_FLAT", gouraud: "GL_SMOOTH", phong: "GL_PHONG_WIN" };
/** @type {Record<string, string>} */
const LOBES = { blinn: "GL_BLINN_TORRANCE_GLSIM", phong: "GL_PHONG_LOBE_GLSIM" };

/** A number as people write it.  @param {number} value */
export function literal(value) {
  return String(Number(value.toFixed(4)));
}

/** @param {number[]} values */
function list(values) {
  return `[${values.map(literal).join(", ")}]`;
}

/** The line that sets a value.  @param {Scene} scene @param {string} name  as in Scene.changed */
export function line(scene, name) {
  const [kind, number, ...rest] = name.split("."), value = scene.value(name);
  if (kind === "ambient") return `glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ${list(value)})`;
  const light = kind === "light", parameter = `GL_${rest[light ? 0 : 1].toUpperCase()}`;
  const thing = light ? scene.moment.lights[+number] : scene.moment.materials[+number];
  const target = light ? `GL_LIGHT${/** @type {any} */ (thing).number}` : faceName(scene, +number, rest[0]);
  const command = (light ? "glLight" : "glMaterial") + (Array.isArray(value) ? "fv" : "f");
  return `${command}(${target}, ${parameter}, ${Array.isArray(value) ? list(value) : literal(value)})`;
}

/** @param {Scene} scene @param {number} number @param {string} face */
function faceName(scene, number, face) {
  const material = scene.moment.materials[number];
  return face === "back" ? "GL_BACK" : material.face;
}

/** The call that makes a projection matrix: gluPerspective if the middle is in the middle, else glFrustum; or glOrtho; or, of
 * another kind, glLoadMatrixf.  @param {number[]} P */
export function projectionLine(P) {
  const perspective = P[11] === -1 && P[15] === 0;
  const usual = [0, 5, 10, 14, ...(perspective ? [8, 9, 11] : [12, 13, 15])]; // where numbers other than 0 may stand
  if (P.some((value, k) => value !== 0 && !usual.includes(k)) || (!perspective && P[15] !== 1)) return `glLoadMatrixf(${list(P)})`;
  const ends = (/** @type {number} */ axis) => // of the picture, per unit of depth in perspective
    [-1, 1].map((end) => (end + (perspective ? P[8 + axis] : -P[12 + axis])) / P[5 * axis]);
  const write = (/** @type {string} */ name, /** @type {number[]} */ numbers) => `${name}(${numbers.map(literal).join(", ")})`;
  if (!perspective) return write("glOrtho", [...ends(0), ...ends(1), (P[14] + 1) / P[10], (P[14] - 1) / P[10]]);
  const near = P[14] / (P[10] - 1), far = P[14] / (P[10] + 1);
  if (P[8] || P[9]) return write("glFrustum", [...[...ends(0), ...ends(1)].map((end) => end * near), near, far]);
  return write("gluPerspective", [(360 / Math.PI) * Math.atan(1 / P[5]), P[5] / P[0], near, far]);
}

/** All changed lines, each with the line of the program in which it stands, if that is known.
 * @param {Scene} scene @param {{mode: string, lobe: string}} look @param {{mode: string, lobe: string}} first  as it was drawn */
export function lines(scene, look, first) {
  const { yaw, pitch, x, y, zoom } = scene.orbit, result = [];
  if (look.mode !== first.mode && SHADE_MODELS[look.mode]) result.push(`glShadeModel(${SHADE_MODELS[look.mode]})`);
  if (look.lobe !== first.lobe && LOBES[look.lobe])
    result.push(`glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, ${LOBES[look.lobe]})`);
  if (zoom !== 1) result.push(projectionLine(scene.projection));
  if (yaw || pitch || x || y) {
    const where = scene.moment.camera.hasView ? "" : "  # before all other changes of the modelview matrix";
    result.push(`gluLookAt(${scene.lookAt.map(literal).join(", ")})${where}`);
  }
  for (const name of scene.changed.keys()) {
    const [kind, number] = name.split(".");
    const thing = kind === "light" ? scene.moment.lights[+number] : kind === "material" ? scene.moment.materials[+number] : null;
    if (kind !== "ambient" && !thing) continue; // this frame does not have it
    result.push(line(scene, name) + (thing?.line ? `  # line ${thing.line}` : ""));
  }
  return [...new Set(result)]; // materials that are changed together have one line
}
