// Builds dist/ from src/: one script, one style sheet, the body of the page, and the licences of what the script holds.
// Usage: node build.mjs [--out DIR]
import { build } from "esbuild";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const at = process.argv.indexOf("--out");
const out = at > 0 ? process.argv[at + 1] : join(here, "dist");
const modules = process.env.SCREE_NODE_MODULES ?? join(here, "node_modules");
const common = { bundle: true, minify: true, charset: "ascii", legalComments: "none", write: false, logLevel: "warning", nodePaths: [modules], absWorkingDir: here };

const script = await build({ ...common, entryPoints: ["src/main.ts"], format: "iife", target: "es2020", metafile: true });
const style = await build({ ...common, stdin: { contents: '@import "uplot/dist/uPlot.min.css";\n@import "./src/style.css";', loader: "css", resolveDir: here } });

// The packages that ended up in the script, each with its licence.
const packages = [...new Set(Object.keys(script.metafile.outputs).flatMap((o) => Object.entries(script.metafile.outputs[o].inputs))
  .filter(([, input]) => input.bytesInOutput > 0).map(([name]) => name.split("node_modules/")[1]).filter(Boolean)
  .map((name) => name.split("/").slice(0, name.startsWith("@") ? 2 : 1).join("/")))].sort();
const licences = packages.map((name) => {
  const { version, license } = JSON.parse(readFileSync(join(modules, name, "package.json"), "utf8"));
  return `${name} ${version} (${license})\n\n${readFileSync(join(modules, name, "LICENSE"), "utf8").trim()}\n`;
});
const header = "The page of `scree report` is part of Scree (GPL-3.0-or-later). It holds these libraries:\n\n";

const ascii = (text) => text.replace(/[\u0080-\u{10ffff}]/gu, (c) => `&#${c.codePointAt(0)};`);
mkdirSync(out, { recursive: true });
writeFileSync(join(out, "viewer.js"), script.outputFiles[0].text);
writeFileSync(join(out, "viewer.css"), style.outputFiles[0].text);
writeFileSync(join(out, "body.html"), ascii(readFileSync(join(here, "src/body.html"), "utf8")));
writeFileSync(join(out, "LICENCES.txt"), (header + licences.join("\n----------------------------------------\n\n")).replace(/[^\x00-\x7f]/g, (c) => ({ "©": "(c)" })[c] ?? "?"));
