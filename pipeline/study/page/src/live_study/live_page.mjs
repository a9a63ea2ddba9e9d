import { readFile } from "node:fs/promises";

/** The index.html of an experiment with live motions. */
export async function livePage(name) {
  const page = await readFile(new URL("index.html", import.meta.url), "utf8");
  return page.replaceAll("{name}", name).replace("{title}", name[0].toUpperCase() + name.slice(1));
}
