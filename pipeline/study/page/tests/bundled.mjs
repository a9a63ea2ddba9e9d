// Modules of the pages for Node.js.
import { webcrypto } from "node:crypto";
import { build } from "esbuild";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

// Browsers have it, and so does Node.js from version 19 on; Debian 12 has 18.
globalThis.crypto ??= webcrypto;

const source = join(dirname(dirname(fileURLToPath(import.meta.url))), "src");

/** What a module of src exports. */
export async function bundled(file) {
  const folder = await mkdtemp(join(tmpdir(), "mien-module-"));
  try {
    const outfile = join(folder, "module.mjs");
    await build({ entryPoints: [join(source, file)], bundle: true, format: "esm", outfile, logLevel: "warning" });
    return await import(pathToFileURL(outfile));
  } finally {
    await rm(folder, { recursive: true });
  }
}
