// The studio in client-examples: its modules for the pictures' own page, and the page as an artist sees it. Its Vite serves both.
import { createRequire } from "node:module";
import { fileURLToPath, pathToFileURL } from "node:url";

const kRepository = fileURLToPath(new URL("../../", import.meta.url));
const kStudio = `${kRepository}client-examples/studio/`;
const kThree = `${kStudio}node_modules/three/`;

async function serve(config) {
  const { createServer } = await import(pathToFileURL(createRequire(kStudio).resolve("vite")).href);
  const server = await createServer({
    configFile: false,
    logLevel: "warn",
    cacheDir: `${kStudio}node_modules/.vite-pictures`,
    optimizeDeps: { noDiscovery: true },
    ...config,
    server: { host: "127.0.0.1", watch: null, fs: { allow: [kRepository] }, ...config.server }, // on the first free port
  });
  await server.listen();
  return { url: server.resolvedUrls.local[0], close: () => server.close() };
}

/** Serves page.html, which takes the painter from the studio; there is one three.js, the studio's. */
export const servePage = () => serve({
  root: fileURLToPath(new URL(".", import.meta.url)),
  resolve: {
    alias: [
      { find: /^three$/, replacement: `${kThree}build/three.module.js` },
      { find: /^three\/addons\//, replacement: `${kThree}examples/jsm/` },
    ],
  },
});

/** Serves the studio itself. @param service  the address of what answers /v1 */
export const serveStudio = (service) => serve({ root: kStudio, base: "/studio/", server: { proxy: { "/v1": service } } });
