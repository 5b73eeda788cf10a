// Characters that are posted as files, and the motion that is asked for.
import { fileURLToPath } from "node:url";

const kData = fileURLToPath(new URL("../data/characters/", import.meta.url));
const kWind = { wind: "0.8,0,-0.6", period: "0.5", fps: "24", hold: "2", gust_wavelength: "0.5", spread: "0.15" };

/** By name: the file, and the query of /v1/characters/motion. */
export const kUploads = {
  godette: { file: `${kData}godette.vrm1.vrm`, query: { ...kWind, amplitude: "0.5" } },
  pmca: { file: `${kData}pmca_sample3.glb`, query: { ...kWind, amplitude: "0.7", kinds: "hair,ribbon" } },
};
