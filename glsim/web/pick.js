/**
 * Which point of a surface is under a pixel, and the vectors of the illumination equation there.
 *
 * @typedef {import("./tape.js").Tape} Tape
 * @typedef {import("./tape.js").Draw} Draw
 * @typedef {import("./matrix.js").Vector} Vector
 * @typedef {import("./scene.js").Scene} Scene
 * @typedef {{P: Vector, N: Vector}} Point  in eye space; N has length 1
 * @typedef {{name: string, vector: Vector}} Arrow
 */
import { along, cross, dot, inverse, transform, unit } from "./matrix.js";

/** The nearest lit point under (x, y), in pixels of the picture from the lower left corner; null if there is none.
 * @param {Tape} tape @param {Draw[]} draws @param {Scene} scene @param {number} x @param {number} y @returns {Point?} */
export function pick(tape, draws, scene, x, y) {
  const back = inverse(scene.projection);
  if (!back) return null;
  const ends = [-1, 1].map((z) => {
    const [X, Y, Z, W] = transform(back, [(2 * x) / tape.width - 1, (2 * y) / tape.height - 1, z, 1]);
    return [X / W, Y / W, Z / W];
  });
  const ray = along(ends[1], ends[0], -1);
  let nearest = Infinity, found = null;
  for (const draw of draws)
    for (const triangle of triangles(tape, draw, scene)) {
      const hit = crossing(ends[0], ray, triangle.P);
      if (!hit || hit.t >= nearest) continue;
      nearest = hit.t;
      const N = hit.weights.reduce((sum, weight, k) => along(sum, triangle.N[k], weight), [0, 0, 0]);
      found = { P: along(ends[0], ray, hit.t), N: unit(N) };
    }
  return found;
}

/** The triangles of a draw in eye space with their normals; none if it has no normals.
 * @param {Tape} tape @param {Draw} draw @param {Scene} scene @returns {Generator<{P: Vector[], N: Vector[]}>} */
function* triangles(tape, draw, scene) {
  const rows = draw.parts.find(({ inputs }) => inputs.some(([name]) => name === "normal"));
  const block = draw.blocks.find(({ binding }) => binding === tape.bindings.Transforms);
  if (draw.mode !== 4 || !rows || !block) return;
  const offset = (/** @type {string} */ name) => /** @type {any} */ (rows.inputs.find((input) => input[0] === name))?.[3];
  const data = floats(tape.blobs[rows.blob]), indices = words(tape.blobs[draw.indices]), width = rows.stride / 4;
  const position = offset("position") / 4, normal = offset("normal") / 4;
  const { modelview, normal: normals, size } = scene.layout.Transform;
  const transforms = floats(scene.change("Transforms", tape.blobs[block.blob].subarray(block.offset, block.offset + block.size)));
  const object = draw.parts.find(({ inputs }) => inputs.some(([name]) => name === "object"));
  const numbers = object && words(tape.blobs[object.blob]);
  for (let instance = 0; instance < draw.instances; instance++)
    for (let k = draw.first; k + 2 < draw.first + draw.count; k += 3) {
      const corners = [indices[k], indices[k + 1], indices[k + 2]];
      const row = numbers && object ? numbers[object.perInstance ? instance : corners[0]] : 0;
      const M = transforms.subarray((row * size + modelview) / 4), n = transforms.subarray((row * size + normals) / 4);
      yield {
        P: corners.map((corner) => transform(M, [...data.subarray(corner * width + position, corner * width + position + 3), 1])),
        N: corners.map((corner) => {
          const [a, b, c] = data.subarray(corner * width + normal, corner * width + normal + 3);
          return unit([0, 1, 2].map((axis) => a * n[axis] + b * n[4 + axis] + c * n[8 + axis]));
        }),
      };
    }
}

/** Where a ray meets a triangle: t along it, and the corners' weights (Moeller & Trumbore 1997).
 * @param {Vector} from @param {Vector} ray @param {Vector[]} corners */
function crossing(from, ray, [A, B, C]) {
  const u = along(B, A, -1), v = along(C, A, -1), p = cross(ray, v), area = dot(u, p);
  if (area === 0) return null;
  const s = along(from, A, -1), b = dot(s, p) / area, q = cross(s, u), c = dot(ray, q) / area, t = dot(v, q) / area;
  return b >= 0 && c >= 0 && b + c <= 1 && t >= 0 ? { t, weights: [1 - b - c, b, c] } : null;
}

/** N, L, V and R or H at a point, of one light.  @param {Point} point @param {Vector} light  its place: x, y, z, w
 * @param {boolean} localViewer  else V is (0, 0, 1) @param {boolean} phong  whether the lobe is (R.V)^n @returns {Arrow[]} */
export function vectors({ P, N }, light, localViewer, phong) {
  const [x, y, z, w] = light, L = unit(w ? along([x / w, y / w, z / w], P, -1) : [x, y, z]);
  const V = localViewer ? unit(P.map((value) => -value)) : [0, 0, 1];
  const R = along(N.map((value) => 2 * dot(N, L) * value), L, -1), H = unit(along(L, V));
  return [{ name: "N", vector: N }, { name: "L", vector: L }, { name: "V", vector: V },
    phong ? { name: "R", vector: R } : { name: "H", vector: H }];
}

/** @param {Uint8Array} bytes */
function floats(bytes) {
  const aligned = bytes.byteOffset % 4 ? bytes.slice() : bytes;
  return new Float32Array(aligned.buffer, aligned.byteOffset, aligned.byteLength >> 2);
}

/** @param {Uint8Array} bytes */
function words(bytes) {
  const aligned = bytes.byteOffset % 4 ? bytes.slice() : bytes;
  return new Uint32Array(aligned.buffer, aligned.byteOffset, aligned.byteLength >> 2);
}
