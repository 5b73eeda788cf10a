/**
 * Runs in the page before its own scripts. The canvas keeps its picture, so that it can be read at any time, and a document is there
 * as if it had been kept by an earlier visit.
 * @param kept  { name, hairstyle }, or null
 * @param antialias  false draws a third faster in software
 */
export function beforePage({ kept, antialias }) {
  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (type, options) {
    return getContext.call(this, type, type === "webgl2" ? { ...options, antialias: options?.antialias && antialias, preserveDrawingBuffer: true } : options);
  };
  if (kept && localStorage.getItem("tuftwave.document") === null) localStorage.setItem("tuftwave.document", JSON.stringify(kept));
}
