/**
 * <glsim-compare>: pictures that swap in place.  page.py writes its children: a heading and notes, a <figure> for each
 * picture, a <table> of metrics, and JSON with names, captions and equations.  The figures stay for printing.
 * @typedef {{name: string, caption: string, equations: [number, number, string][]}} PictureData
 * @typedef {{title: string, reference: number, gain: number, pictures: PictureData[]}} StripData
 */

const style = new CSSStyleSheet();
style.replaceSync(COMPARE_CSS);
const watch = new IntersectionObserver((entries) => {
  for (const { target, isIntersecting } of entries) {
    const { viewer } = /** @type {GlsimCompare} */ (target);
    if (isIntersecting) viewer?.wake();
    else viewer?.sleep();
  }
}, { rootMargin: "50%" });

class GlsimCompare extends HTMLElement {
  /** @type {Viewer?} */
  viewer = null;

  connectedCallback() {
    if (!("DecompressionStream" in window)) return; // an old browser: the figures as they are
    if (document.readyState === "loading" && !this.viewer) // the children may not be there yet
      document.addEventListener("DOMContentLoaded", () => this.connectedCallback(), { once: true });
    else if (this.isConnected) {
      this.viewer ??= new Viewer(this);
      watch.observe(this);
    }
  }

  disconnectedCallback() {
    watch.unobserve(this);
    this.viewer?.sleep();
  }
}

/** The strip that keys mean when nothing has the focus: the last one touched, else the one that is seen most. */
function addressed() {
  const seen = (/** @type {Viewer} */ { host }) => {
    const { top, bottom } = host.getBoundingClientRect();
    return Math.min(bottom, innerHeight) - Math.max(top, 0);
  };
  const first = (/** @type {Viewer?} */ best, /** @type {Viewer} */ next) =>
    best && seen(best) >= seen(next) ? best : next;
  return active || [...near].reduce(first, null);
}

if (!customElements.get("glsim-compare")) {
  document.addEventListener("keydown", (event) => {
    if (event.target === document.body && addressed()?.key(event)) event.preventDefault();
  });
  customElements.define("glsim-compare", GlsimCompare);
}
