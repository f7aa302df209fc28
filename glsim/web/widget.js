/**
 * The live picture as a widget of anywidget: it shows what Python last sent, and keeps the camera when that changes.
 * @typedef {{get: (name: string) => any, on: (event: string, act: () => void) => void, off: (event: string, act: () => void) => void}} Model
 */
import { Live } from "./live.js";

/** @param {{model: Model, el: HTMLElement}} given */
export function render({ model, el }) {
  const live = /** @type {Live} */ (document.createElement("glsim-live"));
  const put = () => {
    const { buffer, byteOffset, byteLength } = model.get("tape"), orbit = live.scene?.orbit;
    live.load(model.get("data"), new Uint8Array(buffer, byteOffset, byteLength));
    if (orbit) live.orbit(orbit);
  };
  model.on("change:tape", put);
  el.append(live);
  put();
  return () => model.off("change:tape", put);
}
