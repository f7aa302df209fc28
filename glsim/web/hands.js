let scrolled = -Infinity; // when the page was scrolled last, in milliseconds
document.addEventListener("scroll", () => (scrolled = performance.now()), { capture: true, passive: true });

/** Mouse, pen and fingers on a stage: hover, click, drag, pinch, and the divider. */
class Hands {
  /** @param {Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    /** @type {Map<number, Point>} */
    this.down = new Map();
    this.moved = false;
    this.dividing = false;
    const stage = viewer.$(".stage");
    stage.addEventListener("pointerdown", (/** @type {PointerEvent} */ event) => this.press(event));
    stage.addEventListener("pointermove", (/** @type {PointerEvent} */ event) => this.move(event));
    stage.addEventListener("pointerup", (/** @type {PointerEvent} */ event) => this.lift(event));
    stage.addEventListener("pointercancel", (/** @type {PointerEvent} */ event) => this.forget(event));
    stage.addEventListener("wheel", (/** @type {WheelEvent} */ event) => this.wheel(event), { passive: false });
    stage.addEventListener("pointerleave", () => this.hover(null));
  }

  /** @param {WheelEvent} event  zooms; the page scrolls on where a scroll has only come across, or all is seen */
  wheel(event) {
    const { viewer } = this;
    if (!viewer.pixels.length) return;
    const point = viewer.pointOf(event), { box } = viewer.stage.panelAt(point), { scale } = viewer.stage.place(box);
    const fit = viewer.stage.fit(box), factor = Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.002));
    if (!event.ctrlKey && (performance.now() - scrolled < 300 || (factor < 1 && scale <= fit))) return;
    event.preventDefault();
    if (scale * factor <= fit && scale > fit) return viewer.zoom("fit");
    viewer.stage.zoomTo(scale * factor, point);
    redraw();
  }

  /** @param {PointerEvent} event */
  press(event) {
    if (event.button || !this.viewer.pixels.length) return;
    const { viewer } = this, stage = viewer.$(".stage");
    this.down.set(event.pointerId, viewer.pointOf(event));
    if (this.down.size === 1) {
      this.moved = false;
      this.dividing = event.composedPath()[0] === viewer.$(".divider");
    }
    if (!this.dividing) stage.focus({ preventScroll: true });
    stage.setPointerCapture(event.pointerId);
  }

  /** @param {PointerEvent} event */
  move(event) {
    const { viewer } = this, point = viewer.pointOf(event), last = this.down.get(event.pointerId);
    if (!last) return this.hover(event.pointerType === "touch" ? null : point);
    const dx = point.x - last.x, dy = point.y - last.y;
    if (!this.moved && Math.hypot(dx, dy) < 4) return; // a click may tremble
    this.moved = true;
    const other = [...this.down].find(([id]) => id !== event.pointerId)?.[1];
    this.down.set(event.pointerId, point);
    if (this.dividing) return viewer.slide(point.x / viewer.$("canvas").clientWidth);
    if (other) this.pinch(last, point, other);
    else viewer.stage.pan(dx, dy, viewer.stage.panelAt(point).box);
    redraw();
  }

  /** Two fingers: the distance zooms, the middle pans.  @param {Point} last @param {Point} point @param {Point} other */
  pinch(last, point, other) {
    const { stage } = this.viewer, distance = (/** @type {Point} */ p) => Math.hypot(p.x - other.x, p.y - other.y);
    const { box } = stage.panelAt(other);
    stage.zoomTo(stage.place(box).scale * (distance(point) / Math.max(distance(last), 1)), other);
  }

  /** @param {PointerEvent} event */
  lift(event) {
    const clicked = this.down.has(event.pointerId) && !this.moved && !this.dividing && this.down.size === 1;
    this.forget(event);
    if (clicked) this.viewer.mark(this.viewer.stage.pixelAt(this.viewer.pointOf(event)));
  }

  /** @param {PointerEvent} event */
  forget(event) {
    this.down.delete(event.pointerId);
  }

  /** @param {Point?} point */
  hover(point) {
    const { viewer } = this, pixel = point && viewer.pixels.length ? viewer.stage.pixelAt(point) : null;
    const { hover } = viewer.marks;
    if (hover?.x === pixel?.x && hover?.y === pixel?.y) return;
    viewer.marks.hover = pixel;
    viewer.draw();
  }
}
