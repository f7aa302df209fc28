/** Mouse, pen and fingers on a stage: hover, click, drag, pinch, and the divider. */
class Hands {
  /** @param {GlsimCompare} element */
  constructor(element) {
    this.element = element;
    /** @type {Map<number, Point>} */
    this.down = new Map();
    this.moved = false;
    this.dividing = false;
    const stage = element.$(".stage");
    stage.addEventListener("pointerdown", (/** @type {PointerEvent} */ event) => this.press(event));
    stage.addEventListener("pointermove", (/** @type {PointerEvent} */ event) => this.move(event));
    stage.addEventListener("pointerup", (/** @type {PointerEvent} */ event) => this.lift(event));
    stage.addEventListener("pointercancel", (/** @type {PointerEvent} */ event) => this.forget(event));
    stage.addEventListener("pointerleave", () => this.hover(null));
  }

  /** @param {PointerEvent} event */
  press(event) {
    if (event.button) return;
    const { element } = this, stage = element.$(".stage");
    this.down.set(event.pointerId, element.pointOf(event));
    if (this.down.size === 1) {
      this.moved = false;
      this.dividing = event.composedPath()[0] === element.$(".divider");
    }
    if (!this.dividing) stage.focus({ preventScroll: true });
    stage.setPointerCapture(event.pointerId);
  }

  /** @param {PointerEvent} event */
  move(event) {
    const { element } = this, point = element.pointOf(event), last = this.down.get(event.pointerId);
    if (!last) return this.hover(event.pointerType === "touch" ? null : point);
    const dx = point.x - last.x, dy = point.y - last.y;
    if (!this.moved && Math.hypot(dx, dy) < 4) return; // a click may tremble
    this.moved = true;
    const other = [...this.down].find(([id]) => id !== event.pointerId)?.[1];
    this.down.set(event.pointerId, point);
    if (this.dividing) return element.slide(point.x / element.$("canvas").clientWidth);
    if (other) this.pinch(last, point, other);
    else element.stage.pan(dx, dy, element.stage.panelAt(point).box);
    redraw();
  }

  /** Two fingers: the distance zooms, the middle pans.  @param {Point} last @param {Point} point @param {Point} other */
  pinch(last, point, other) {
    const { stage } = this.element, distance = (/** @type {Point} */ p) => Math.hypot(p.x - other.x, p.y - other.y);
    const { box } = stage.panelAt(other);
    stage.zoomTo(stage.place(box).scale * (distance(point) / Math.max(distance(last), 1)), other);
  }

  /** @param {PointerEvent} event */
  lift(event) {
    const clicked = this.down.has(event.pointerId) && !this.moved && !this.dividing && this.down.size === 1;
    this.forget(event);
    if (clicked) this.element.mark(this.element.stage.pixelAt(this.element.pointOf(event)));
  }

  /** @param {PointerEvent} event */
  forget(event) {
    this.down.delete(event.pointerId);
  }

  /** @param {Point?} point */
  hover(point) {
    const { element } = this, pixel = point && element.stage.panels.length ? element.stage.pixelAt(point) : null;
    const { hover } = element.marks;
    if (hover?.x === pixel?.x && hover?.y === pixel?.y) return;
    element.marks.hover = pixel;
    element.draw();
  }
}
