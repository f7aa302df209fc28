/**
 * Which live pictures of a page hold a context: those near the screen, the nearest MOST of them.  Browsers take contexts
 * away from a page that holds about 16.
 * @typedef {Element & {wake: () => void, sleep: () => void}} Sleeper
 */

const MOST = 8;
/** @type {Set<Sleeper>} */ const near = new Set();
/** @type {Set<Sleeper>} */ const awake = new Set();

/** @param {Element} one  @returns {number} CSS pixels to the screen, 0 on it */
function distance(one) {
  const { top, bottom } = one.getBoundingClientRect();
  return Math.max(0, top - innerHeight, -bottom);
}

function settle() {
  const chosen = [...near].sort((a, b) => distance(a) - distance(b)).slice(0, MOST);
  for (const one of awake) if (!chosen.includes(one)) awake.delete(one), one.sleep();
  for (const one of chosen) if (!awake.has(one)) awake.add(one), one.wake();
}

const approaching = new IntersectionObserver((entries) => {
  for (const { target, isIntersecting } of entries)
    isIntersecting ? near.add(/** @type {Sleeper} */ (target)) : near.delete(/** @type {Sleeper} */ (target));
  settle();
}, { rootMargin: "100%" });
const arriving = new IntersectionObserver(settle);

/** Wake it when it comes near the screen, let it sleep when it is far.  @param {Sleeper} one  may be watched, and shows
 * something else now */
export function watch(one) {
  if (awake.has(one)) one.wake();
  approaching.observe(one);
  arriving.observe(one);
}

/** The one on the screen whose middle is nearest to the screen's. */
export function foremost() {
  const off = (/** @type {Element} */ one) => {
    const { top, bottom } = one.getBoundingClientRect();
    return Math.abs(top + bottom - innerHeight);
  };
  return [...awake].filter((one) => distance(one) === 0).sort((a, b) => off(a) - off(b)).at(0);
}

/** @param {Sleeper} one */
export function unwatch(one) {
  approaching.unobserve(one);
  arriving.unobserve(one);
  near.delete(one);
  settle();
}
