import { defineConfig } from "vite";

// All files lie side by side under /studio/, as the server has them; only index.html is at /.
export default defineConfig({
  base: "/studio/",
  build: {
    target: "es2022",
    assetsDir: "",
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1200,
    rollupOptions: { output: { entryFileNames: "studio.js", chunkFileNames: "[name].js", assetFileNames: "[name][extname]" } },
  },
  // `npm run dev` asks a service that runs beside it.
  server: { fs: { allow: ["../.."] }, proxy: { "/v1": process.env.TUFTWAVE_URL ?? "http://127.0.0.1:8080" } },
});
