/**
 * What is drawn over a picture: places of lights that can be dragged, and the vectors at a point.
 * @typedef {import("./scene.js").Scene} Scene
 * @typedef {import("./matrix.js").Vector} Vector
 * @typedef {import("./pick.js").Point} Point
 * @typedef {import("./pick.js").Arrow} Arrow
 * @typedef {{x: number, y: number, number: number}} Handle  of a light, in pixels of the picture from the upper left corner
 */
import { along, dot, inverse, transform, unit } from "./matrix.js";
import { literal } from "./source.js";

const ARROW = 0.22; // length of a vector, in heights of the picture
const COLOURS = { N: "#ffd24d", L: "#ff7b54", V: "#6ec6ff", R: "#b388ff", H: "#69f0ae" };

export class Overlay {
  /** @param {HTMLCanvasElement} canvas  @param {number} width @param {number} height  of the picture */
  constructor(canvas, width, height) {
    this.pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
    this.canvas = canvas;
    this.width = width;
    this.height = height;
  }

  /** Where a point in eye space is, in pixels from the upper left corner; null behind the eye.
   * @param {Scene} scene @param {Vector} P */
  place(scene, P) {
    const [x, y, , w] = transform(scene.projection, [...P, 1]);
    return w > 0 ? { x: (0.5 + (0.5 * x) / w) * this.width, y: (0.5 - (0.5 * y) / w) * this.height } : null;
  }

  /** The lights' places, at the picture's border if they are outside; a directional light stands beside the scene's
   * middle, where it comes from.  @param {Scene} scene @returns {Handle[]} */
  handles(scene) {
    const inside = (/** @type {number} */ at, /** @type {number} */ end) => Math.max(12, Math.min(end - 12, at));
    return scene.moment.lights.flatMap((_, number) => {
      const at = this.place(scene, this.#shown(scene, number));
      return at ? [{ x: inside(at.x, this.width), y: inside(at.y, this.height), number }] : [];
    });
  }

  /** @param {Scene} scene @param {number} number @returns {Vector} */
  #shown(scene, number) {
    const [x, y, z, w] = scene.lightPosition(number), { camera } = scene.moment;
    if (w) return [x / w, y / w, z / w];
    const centre = transform(scene.turned, [...camera.centre, 1]).slice(0, 3);
    return along(centre, unit([x, y, z]), camera.radius);
  }

  /** The light's position (as scene.lightPosition) when its handle is dragged to (x, y): a place stays as far from the
   * eye; a direction turns, towards the viewer.  @param {Scene} scene @param {number} number @param {number} x @param {number} y
   * @returns {Vector?} */
  dragged(scene, number, x, y) {
    const [, , , w] = scene.lightPosition(number), shown = this.#shown(scene, number), back = inverse(scene.projection);
    if (!back) return null;
    const [, , depth, q] = transform(scene.projection, [...shown, 1]);
    const [X, Y, Z, W] = transform(back, [(2 * x) / this.width - 1, 1 - (2 * y) / this.height, depth / q, 1]);
    if (w) return [(X / W) * w, (Y / W) * w, (Z / W) * w, w];
    const centre = transform(scene.turned, [...scene.moment.camera.centre, 1]).slice(0, 3), { radius } = scene.moment.camera;
    const across = along([X / W, Y / W, centre[2]], centre, -1), far = Math.hypot(across[0], across[1]) / radius;
    const [a, b] = far > 1 ? [across[0] / far, across[1] / far] : across;
    return [a / radius, b / radius, Math.sqrt(Math.max(0, 1 - (a * a + b * b) / radius ** 2)), 0];
  }

  /** @param {Scene} scene @param {{point: Point?, arrows: Arrow[], handles: boolean}} what */
  draw(scene, { point, arrows, handles }) {
    const { pen, canvas } = this, ratio = devicePixelRatio || 1, width = canvas.clientWidth || this.width;
    const size = [width * ratio, ((width * this.height) / this.width) * ratio].map(Math.round);
    if (canvas.width !== size[0] || canvas.height !== size[1]) Object.assign(canvas, { width: size[0], height: size[1] });
    const scale = size[0] / this.width;
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.clearRect(0, 0, this.width, this.height);
    this.unit = ratio / scale; // a CSS pixel in pixels of the picture
    if (handles) for (const handle of this.handles(scene)) this.#lamp(scene, handle);
    const at = point && this.place(scene, point.P);
    if (!point || !at) return;
    const [, , , w] = transform(scene.projection, [...point.P, 1]), length = (ARROW * 2 * w) / scene.projection[5];
    for (const { name, vector } of arrows) {
      const end = this.place(scene, along(point.P, vector, length));
      if (end) this.#arrow(at, end, name);
    }
    this.#numbers(arrows);
  }

  /** @param {Scene} scene @param {Handle} handle */
  #lamp(scene, { x, y, number }) {
    const { pen } = this, u = this.unit ?? 1;
    pen.beginPath();
    pen.arc(x, y, 7 * u, 0, 7);
    const [r, g, b] = scene.value(`light.${number}.diffuse`).map((/** @type {number} */ value) => 255 * Math.min(1, Math.max(0, value)));
    pen.fillStyle = `rgb(${r} ${g} ${b})`;
    pen.fill();
    for (const [colour, wide] of [["#000", 3], ["#fff", 1.5]]) {
      pen.strokeStyle = String(colour);
      pen.lineWidth = +wide * u;
      pen.stroke();
    }
    this.#word(String(scene.moment.lights[number].number), x + 11 * u, Math.max(y - 9 * u, 9 * u), "#fff");
  }

  /** @param {{x: number, y: number}} from @param {{x: number, y: number}} to @param {string} name */
  #arrow(from, to, name) {
    const { pen } = this, u = this.unit ?? 1, angle = Math.atan2(to.y - from.y, to.x - from.x);
    const path = new Path2D();
    path.moveTo(from.x, from.y);
    path.lineTo(to.x, to.y);
    for (const side of [-0.45, 0.45]) {
      path.moveTo(to.x, to.y);
      path.lineTo(to.x - 10 * u * Math.cos(angle + side), to.y - 10 * u * Math.sin(angle + side));
    }
    const colour = COLOURS[/** @type {keyof typeof COLOURS} */ (name)];
    for (const [stroke, wide] of [["#000", 5], [colour, 2.5]]) {
      pen.strokeStyle = String(stroke);
      pen.lineWidth = +wide * u;
      pen.lineCap = "round";
      pen.stroke(path);
    }
    this.#word(name, to.x + 12 * u * Math.cos(angle), to.y + 12 * u * Math.sin(angle), colour);
  }

  /** N.L and the highlight's cosine, in the lower left corner.  @param {Arrow[]} arrows */
  #numbers(arrows) {
    const by = Object.fromEntries(arrows.map(({ name, vector }) => [name, vector])), u = this.unit ?? 1;
    const words = [`N·L = ${literal(dot(by.N, by.L))}`];
    words.push(by.H ? `N·H = ${literal(dot(by.N, by.H))}` : `R·V = ${literal(dot(by.R, by.V))}`);
    words.forEach((text, k) => this.#word(text, 8 * u, this.height - (12 + 20 * (words.length - 1 - k)) * u, "#fff", "left"));
  }

  /** @param {string} text @param {number} x @param {number} y @param {string} colour @param {CanvasTextAlign} align */
  #word(text, x, y, colour, align = "center") {
    const { pen } = this, u = this.unit ?? 1;
    pen.font = `600 ${14 * u}px system-ui, sans-serif`;
    pen.textAlign = align;
    pen.textBaseline = "middle";
    pen.lineJoin = "round";
    pen.lineWidth = 4 * u;
    pen.strokeStyle = "#000";
    pen.strokeText(text, x, y);
    pen.fillStyle = colour;
    pen.fillText(text, x, y);
  }
}
