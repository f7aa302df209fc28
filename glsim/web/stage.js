/**
 * What all elements of a page show in step: scale in CSS pixels for a pixel of the picture, 0 to fit; the centre as a
 * share of the picture's width and height.
 */
const view = { scale: 0, x: 0.5, y: 0.5 };
const LARGEST = 64; // the largest scale
const LEGIBLE = 44; // from this scale on, a pixel has room for its values

/** @typedef {{x: number, y: number, width: number, height: number}} Box  in CSS pixels of the stage */
/** @typedef {{left: number, top: number, scale: number}} Place  where the picture's upper left corner lies */
/** @typedef {{box: Box, clip: Box, image: HTMLCanvasElement, pixels: Pixels, label?: string, labelTop?: number}} Panel
 *   box: where the picture is placed; clip: what is seen of it; labelTop: how high its label may stand, if above the picture */

const clamp = (/** @type {number} */ value, /** @type {number} */ low, /** @type {number} */ high) =>
  Math.max(low, Math.min(high, value));

const SYMBOL = /(?<![\w./-])([A-Za-z])_(\d+|[A-Za-z])(?![\w./])|(?<=[\w)])\^(\d+|[A-Za-z])(?!\w)/g;

/** Text in which "k_d" has an index and "x^n" an exponent, as page.py writes it.
 * @param {string} text @returns {(string | HTMLElement)[]} */
function typeset(text) {
  const parts = [];
  let at = 0;
  for (const { 0: found, 1: letter, 2: index, 3: exponent, index: start } of text.matchAll(SYMBOL)) {
    parts.push(text.slice(at, start) + (letter || ""));
    parts.push(Object.assign(document.createElement(letter ? "sub" : "sup"), { textContent: index || exponent }));
    at = start + found.length;
  }
  return [...parts, text.slice(at)];
}

/** One canvas with the panels of a strip: a picture, a difference, two beside a divider, or all side by side. */
class Stage {
  /** @param {HTMLCanvasElement} canvas @param {{width: number, height: number}} size  of the strip's largest picture */
  constructor(canvas, size) {
    this.canvas = canvas;
    this.size = size;
    /** @type {Panel[]} */
    this.panels = [];
  }

  /** The scale at which the whole picture is seen.  @param {Box} box */
  fit(box) {
    const scale = Math.min(box.width / this.size.width, box.height / this.size.height);
    return scale >= 2 ? Math.floor(scale) : scale; // magnified pixels all have one size
  }

  /** @param {Box} box @returns {Place} */
  place(box) {
    const scale = view.scale || this.fit(box);
    const start = (/** @type {number} */ room, /** @type {number} */ length, /** @type {number} */ centre) =>
      Math.round((length <= room ? (room - length) / 2 : clamp(room / 2 - centre * length, room - length, 0))
        * devicePixelRatio) / devicePixelRatio;
    const left = box.x + start(box.width, this.size.width * scale, view.x);
    const top = box.y + start(box.height, this.size.height * scale, view.y);
    return { left, top, scale };
  }

  /** Let the view be such that ``place`` answers this, as far as the picture's edges allow.
   * @param {Box} box @param {Place} place */
  moveTo(box, { left, top, scale }) {
    view.scale = scale;
    view.x = clamp((box.x + box.width / 2 - left) / (this.size.width * scale), 0, 1);
    view.y = clamp((box.y + box.height / 2 - top) / (this.size.height * scale), 0, 1);
  }

  /** The panel under a point of the stage; the first one if there is none.
   * @param {{x: number, y: number}} point */
  panelAt({ x, y }) {
    const inside = (/** @type {Box} */ box) =>
      x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
    return this.panels.find((panel) => inside(panel.clip)) || this.panels[0];
  }

  /** The pixel under a point of the stage, or null outside of the picture.
   * @param {{x: number, y: number}} point */
  pixelAt(point) {
    const { left, top, scale } = this.place(this.panelAt(point).box);
    const x = Math.floor((point.x - left) / scale), y = Math.floor((point.y - top) / scale);
    return x >= 0 && y >= 0 && x < this.size.width && y < this.size.height ? { x, y } : null;
  }

  /** @param {number} scale @param {{x: number, y: number}} point  that stays where it is */
  zoomTo(scale, point) {
    const { box } = this.panelAt(point);
    const place = this.place(box);
    scale = clamp(scale, Math.min(1, this.fit(box)), LARGEST);
    const grow = scale / place.scale;
    const left = point.x - (point.x - place.left) * grow, top = point.y - (point.y - place.top) * grow;
    this.moveTo(box, { left, top, scale });
  }

  /** @param {number} dx @param {number} dy  in CSS pixels, of the picture @param {Box} box */
  pan(dx, dy, box = this.panels[0].box) {
    const { left, top, scale } = this.place(box);
    if (view.scale) this.moveTo(box, { left: left + dx, top: top + dy, scale });
  }

  /** @param {Panel[]} panels @param {{ink: string, paper: string}} colours
   * @param {{hover: Point?, mark: Point?, point: Point?}} marks */
  draw(panels, colours, marks) {
    this.panels = panels;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const [w, h] = [width, height].map((length) => Math.round(length * devicePixelRatio));
    if (this.canvas.width !== w || this.canvas.height !== h) Object.assign(this.canvas, { width: w, height: h });
    const pen = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext("2d"));
    pen.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    pen.clearRect(0, 0, width, height);
    for (const panel of panels) {
      const place = this.place(panel.box);
      pen.save();
      pen.beginPath();
      pen.rect(panel.clip.x, panel.clip.y, panel.clip.width, panel.clip.height);
      pen.clip();
      this.#picture(pen, panel, place);
      if (place.scale >= LEGIBLE) this.#values(pen, panel, place);
      this.#marks(pen, place, marks);
      pen.restore();
    }
    for (const panel of panels) this.#label(pen, panel, colours);
  }

  /** @param {CanvasRenderingContext2D} pen @param {Panel} panel @param {Place} place */
  #picture(pen, { image, pixels }, { left, top, scale }) {
    const box = [left, top, image.width * scale, image.height * scale];
    if (!pixels.opaque) { // what is transparent shows squares
      const squares = document.createElement("canvas");
      Object.assign(squares, { width: 16, height: 16 });
      const small = /** @type {CanvasRenderingContext2D} */ (squares.getContext("2d"));
      for (const [colour, x, y, side] of [["#fff", 0, 0, 16], ["#ccc", 0, 0, 8], ["#ccc", 8, 8, 8]])
        (small.fillStyle = String(colour)), small.fillRect(+x, +y, +side, +side);
      pen.fillStyle = /** @type {CanvasPattern} */ (pen.createPattern(squares, "repeat"));
      pen.fillRect(box[0], box[1], box[2], box[3]);
    }
    pen.imageSmoothingEnabled = scale < 2 && !Number.isInteger(scale * devicePixelRatio);
    pen.imageSmoothingQuality = "high";
    pen.drawImage(image, box[0], box[1], box[2], box[3]);
  }

  /** R, G, B (and A) of each pixel, written into it.
   * @param {CanvasRenderingContext2D} pen @param {Panel} panel @param {Place} place */
  #values(pen, { clip, pixels }, { left, top, scale }) {
    pen.font = `${Math.min(14, scale / 4.4)}px ui-monospace, monospace`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    const first = Math.max(0, Math.floor((clip.x - left) / scale)), end = (clip.x + clip.width - left) / scale;
    const highest = Math.max(0, Math.floor((clip.y - top) / scale)), bottom = (clip.y + clip.height - top) / scale;
    for (let y = highest; y < Math.min(bottom, pixels.height); y++) {
      for (let x = first; x < Math.min(end, pixels.width); x++) {
        const [r, g, b, a] = valuesAt(pixels, { x, y });
        const lines = a === 255 ? [r, g, b] : [r, g, b, a];
        pen.fillStyle = a > 127 && 0.2126 * r + 0.7152 * g + 0.0722 * b < 140 ? "#fff" : "#000";
        lines.forEach((value, line) =>
          pen.fillText(String(value), left + (x + 0.5) * scale, top + (y + (line + 1) / (lines.length + 1)) * scale));
        pen.strokeStyle = "#8884";
        pen.strokeRect(left + x * scale, top + y * scale, scale, scale);
      }
    }
  }

  /** The pixel under the pointer, the marked one, and the point whose equation is shown.
   * @param {CanvasRenderingContext2D} pen @param {Place} place
   * @param {{hover: Point?, mark: Point?, point: Point?}} marks */
  #marks(pen, { left, top, scale }, { hover, mark, point }) {
    const middle = (/** @type {Point} */ { x, y }) => [left + (x + 0.5) * scale, top + (y + 0.5) * scale];
    const stroke = (/** @type {Path2D} */ path) => {
      for (const [colour, width] of [["#000", 4], ["#fff", 2]])
        (pen.strokeStyle = String(colour)), (pen.lineWidth = +width), pen.stroke(path);
    };
    for (const pixel of [hover, mark]) {
      if (!pixel) continue;
      const path = new Path2D(), [x, y] = middle(pixel), half = Math.max(scale / 2, 2);
      if (pixel === mark || scale >= 4) path.rect(x - half, y - half, 2 * half, 2 * half);
      if (pixel === mark)
        for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]])
          path.moveTo(x + dx * (half + 3), y + dy * (half + 3)), path.lineTo(x + dx * (half + 11), y + dy * (half + 11));
      stroke(path);
    }
    if (point) {
      const path = new Path2D(), [x, y] = middle(point);
      path.arc(x, y, Math.max(7, scale / 2), 0, 7);
      stroke(path);
    }
  }

  /** The name: in the upper left corner, or right above the picture.
   * @param {CanvasRenderingContext2D} pen @param {Panel} panel @param {{ink: string, paper: string}} colours */
  #label(pen, { box, clip, label, labelTop }, { ink, paper }) {
    if (!label) return;
    const place = this.place(box), above = labelTop !== undefined;
    const x = above ? Math.max(clip.x, place.left) : clip.x + 6;
    const y = above ? Math.max(labelTop, place.top - 29) : clip.y + 6;
    pen.textAlign = "left";
    pen.textBaseline = "middle";
    const runs = typeset(label).map((part) => {
      const [text, size, drop] = typeof part === "string" ? [part, 14, 0]
        : [part.textContent || "", 10, part.localName === "sub" ? 4 : -4];
      pen.font = `600 ${size}px system-ui, sans-serif`;
      return { text, font: pen.font, drop, width: pen.measureText(text).width };
    });
    const whole = runs.reduce((sum, run) => sum + run.width, 0);
    const width = Math.min(whole + 16, clip.x + clip.width - x - 6);
    if (width < 24) return;
    pen.fillStyle = paper;
    pen.beginPath();
    pen.roundRect(x, y, width, 24, 5);
    pen.fill();
    pen.fillStyle = ink;
    let left = x + 8;
    for (const { text, font, drop, width: own } of runs) {
      const room = (own * (width - 16)) / whole; // narrower where the label does not fit
      pen.font = font;
      pen.fillText(text, left, y + 12.5 + drop, room);
      left += room;
    }
  }
}

/** @typedef {{x: number, y: number}} Point  a pixel, from the upper left corner */

/** R, G, B, A of a pixel, 0 to 255; empty outside of the picture.
 * @param {Pixels} pixels @param {Point} point @returns {number[]} */
function valuesAt({ width, height, data }, { x, y }) {
  return x < width && y < height ? [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 4)] : [];
}

/** |b - a| of each channel, amplified, as an opaque picture; where alpha differs, all channels show it.
 * @param {Pixels} a @param {Pixels} b @param {number} gain @returns {Pixels} */
function differenceOf(a, b, gain) {
  const data = new Uint8ClampedArray(a.data.length);
  for (let i = 0; i < data.length; i += 4) {
    const alpha = Math.abs(b.data[i + 3] - a.data[i + 3]);
    for (let c = i; c < i + 3; c++) data[c] = gain * Math.max(Math.abs(b.data[c] - a.data[c]), alpha);
    data[i + 3] = 255;
  }
  return { width: a.width, height: a.height, data, opaque: true };
}

/** @param {Pixels} pixels @returns {HTMLCanvasElement} */
function imageOf({ width, height, data }) {
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  canvas.getContext("2d")?.putImageData(new ImageData(data, width, height), 0, 0);
  return canvas;
}
