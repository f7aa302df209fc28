/**
 * Matrices of 4 x 4 as OpenGL has them: 16 numbers, column by column.
 * @typedef {number[]} Matrix
 * @typedef {number[]} Vector
 */

/** @type {Matrix} */
export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** a b  @param {ArrayLike<number>} a @param {ArrayLike<number>} b @returns {Matrix} */
export function multiply(a, b) {
  const c = [];
  for (let column = 0; column < 4; column++)
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[4 * k + row] * b[4 * column + k];
      c.push(sum);
    }
  return c;
}

/** m v, of four numbers  @param {ArrayLike<number>} m @param {ArrayLike<number>} v @returns {Vector} */
export function transform(m, v) {
  return [0, 1, 2, 3].map((row) => m[row] * v[0] + m[4 + row] * v[1] + m[8 + row] * v[2] + m[12 + row] * v[3]);
}

/** The upper left 3 x 3 of m times v  @param {ArrayLike<number>} m @param {ArrayLike<number>} v @returns {Vector} */
export function rotate(m, v) {
  return [0, 1, 2].map((row) => m[row] * v[0] + m[4 + row] * v[1] + m[8 + row] * v[2]);
}

/** The inverse, by Gauss and Jordan's elimination; null if there is none.  @param {ArrayLike<number>} m @returns {Matrix?} */
export function inverse(m) {
  const rows = [0, 1, 2, 3].map((row) => [0, 1, 2, 3, 4, 5, 6, 7].map((k) => (k < 4 ? m[4 * k + row] : +(k - 4 === row))));
  for (let k = 0; k < 4; k++) {
    let pivot = k;
    for (let row = k; row < 4; row++) if (Math.abs(rows[row][k]) > Math.abs(rows[pivot][k])) pivot = row;
    if (!(Math.abs(rows[pivot][k]) > 1e-30)) return null;
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    const factor = rows[k][k];
    rows[k] = rows[k].map((value) => value / factor);
    for (let row = 0; row < 4; row++) {
      const share = rows[row][k];
      if (row !== k) rows[row] = rows[row].map((value, column) => value - share * rows[k][column]);
    }
  }
  return IDENTITY.map((_, at) => rows[at % 4][4 + Math.floor(at / 4)]);
}

/** @param {ArrayLike<number>} v @returns {Matrix} */
export function translation(v) {
  return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, v[0], v[1], v[2], 1];
}

/** glRotate: by an angle in degrees about an axis  @param {number} degrees @param {Vector} axis @returns {Matrix} */
export function rotation(degrees, axis) {
  const [x, y, z] = unit(axis), c = Math.cos((degrees * Math.PI) / 180), s = Math.sin((degrees * Math.PI) / 180), d = 1 - c;
  return [x * x * d + c, y * x * d + z * s, z * x * d - y * s, 0, x * y * d - z * s, y * y * d + c, z * y * d + x * s, 0,
    x * z * d + y * s, y * z * d - x * s, z * z * d + c, 0, 0, 0, 0, 1];
}

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** @param {Vector} a @param {Vector} b @returns {Vector} */
export function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** Of length 1; the null vector stays.  @param {ArrayLike<number>} v @returns {Vector} */
export function unit(v) {
  const length = Math.hypot(v[0], v[1], v[2]);
  return [v[0], v[1], v[2]].map((value) => (length > 0 ? value / length : value));
}

/** a + t b  @param {Vector} a @param {Vector} b @param {number} t @returns {Vector} */
export function along(a, b, t = 1) {
  return [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
}
