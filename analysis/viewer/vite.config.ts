// SPDX-License-Identifier: BSD-3-Clause
import { readFileSync } from "node:fs";
import { defineConfig } from "vite";

// three.js is in the bundle, so its licence must be too.
const license = readFileSync("node_modules/three/LICENSE", "utf8").trim();
const banner = `/*! The views in space are drawn by three.js.\n\n${license}\n*/`;

// One classic script and one style sheet with fixed names: report.py writes both into the page.
export default defineConfig({
  build: {
    target: "es2020",
    outDir: "dist",
    emptyOutDir: true,
    cssCodeSplit: false,
    lib: { entry: "src/main.ts", formats: ["iife"], name: "NarrowsReport", fileName: () => "viewer.js" },
    rollupOptions: { output: { assetFileNames: "viewer[extname]", banner } },
  },
});
