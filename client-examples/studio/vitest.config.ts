import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const at = (path: string) => fileURLToPath(new URL(path, import.meta.url));

// The tests lie in tests/studio; what they import is what the studio has.
export default defineConfig({
  resolve: { alias: { three: at("node_modules/three"), fflate: at("node_modules/fflate") } },
  test: { globals: true, include: ["tests/studio/**/*.test.ts"] },
});
