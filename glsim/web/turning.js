/**
 * Mouse, fingers and keys on a picture: one finger turns the camera or drags a light, two fingers move it and bring it
 * nearer, the wheel brings it nearer, a click asks about a point.
 *
 * @typedef {{
 *   grab: (x: number, y: number) => boolean,
 *   drag: (x: number, y: number) => void,
 *   turn: (dx: number, dy: number) => void,
 *   move: (dx: number, dy: number) => void,
 *   zoom: (factor: number) => void,
 *   click: (x: number, y: number) => void,
 *   reset: () => void,
 * }} Doing  lengths and places in pixels of the picture, from its upper left corner
 */

const STILL = 4; // CSS pixels: a pointer that moved less has clicked

/** @param {HTMLElement} element  shows the picture @param {number} width  of the picture @param {Doing} doing */
export function turning(element, width, doing) {
  /** @type {Map<number, {x: number, y: number}>} */ const pointers = new Map();
  let travelled = 0, grabbed = false;
  const scale = () => width / element.getBoundingClientRect().width;
  const place = (/** @type {MouseEvent} */ event) => {
    const box = element.getBoundingClientRect();
    return { x: (event.clientX - box.left) * scale(), y: (event.clientY - box.top) * scale() };
  };
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, size: Math.hypot(a.x - b.x, a.y - b.y) };
  };

  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
    if (pointers.size === 1) (travelled = 0), (grabbed = doing.grab(place(event).x, place(event).y));
  });
  element.addEventListener("pointermove", (event) => {
    const old = pointers.get(event.pointerId), now = place(event);
    if (!old) return;
    const [dx, dy] = [now.x - old.x, now.y - old.y];
    travelled += Math.hypot(dx, dy) / scale();
    const before = pointers.size === 2 ? spread() : null;
    pointers.set(event.pointerId, now);
    if (before) {
      const after = spread();
      doing.move(after.x - before.x, after.y - before.y);
      if (before.size > 0) doing.zoom(after.size / before.size);
    } else if (grabbed) doing.drag(now.x, now.y);
    else if (travelled > STILL) event.shiftKey || event.buttons & 2 ? doing.move(dx, dy) : doing.turn(dx, dy);
  });
  const release = (/** @type {PointerEvent} */ event) => {
    if (!pointers.delete(event.pointerId)) return;
    if (event.type === "pointerup" && travelled <= STILL && !grabbed && !pointers.size) doing.click(place(event).x, place(event).y);
    grabbed = grabbed && pointers.size > 0;
  };
  element.addEventListener("pointerup", release);
  element.addEventListener("pointercancel", release);
  element.addEventListener("contextmenu", (event) => event.preventDefault());
  element.addEventListener("wheel", (event) => {
    event.preventDefault();
    doing.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)));
  }, { passive: false });
  element.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (step) event.shiftKey ? doing.move(step[0] * width / 40, step[1] * width / 40) : doing.turn(step[0] * width / 40, step[1] * width / 40);
    else if (event.key === "+" || event.key === "=") doing.zoom(1.1);
    else if (event.key === "-") doing.zoom(1 / 1.1);
    else if (event.key === "0" || event.key === "Escape") doing.reset();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
}
