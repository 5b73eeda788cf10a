import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const at = (path: string) => fileURLToPath(new URL(path, import.meta.url));

// The tests lie in tests/studio, where no node_modules has three.js.
export default defineConfig({
  resolve: { alias: { three: at("node_modules/three") } },
  test: { globals: true, include: ["tests/studio/**/*.test.ts"] },
});
