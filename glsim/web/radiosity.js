/**
 * Radiosities of vertices as colours: glsim/radiosity/tone.py's tone mapping.
 * @typedef {import("./player.js").Player} Player
 * @typedef {import("./live.js").Radiosity} Radiosity
 */

/** A number of 16 bits (IEEE 754 binary16).  @param {number} half */
export function float16(half) {
  const exponent = (half >> 10) & 31, fraction = half & 1023;
  return (exponent ? (1 + fraction / 1024) * 2 ** (exponent - 15) : (fraction / 1024) * 2 ** -14) * (half >> 15 ? -1 : 1);
}

/** Give the vertices the colours of a stage; nothing if they have them already.
 * @param {Player} player @param {Radiosity} radiosity @param {number} stage @param {number} exposure */
export function colours(player, radiosity, stage, exposure) {
  const { stages, white, gamma, tone, parts, stride, offset } = radiosity, wanted = `${stage} ${exposure}`;
  if (shown.get(player) === wanted) return;
  shown.set(player, wanted);
  const values = player.tape.blobs[stages[stage].blob], halves = new DataView(values.buffer, values.byteOffset, values.byteLength);
  let at = 0;
  for (const { rows, count } of parts) {
    const bytes = player.tape.blobs[rows].slice(), view = new DataView(bytes.buffer);
    for (let vertex = 0; vertex < count; vertex++)
      for (let channel = 0; channel < 3; channel++, at += 2) {
        let L = (float16(halves.getUint16(at, true)) * exposure) / white;
        if (tone === "reinhard") L /= 1 + L;
        view.setFloat32(vertex * stride + offset + 4 * channel, Math.min(1, Math.max(0, L)) ** (1 / gamma), true);
      }
    player.replace(rows, bytes);
  }
}

/** @type {WeakMap<Player, string>} */
const shown = new WeakMap();
