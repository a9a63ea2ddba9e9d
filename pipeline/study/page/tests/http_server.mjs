// Serves files by their paths on this machine alone: { "/index.html": Buffer }.
import { createServer } from "node:http";
import { readdir, readFile } from "node:fs/promises";
import { join } from "node:path";

const types = { html: "text/html", js: "text/javascript", css: "text/css", json: "application/json",
  mp4: "video/mp4", webm: "video/webm", glb: "model/gltf-binary" };

/** All files below a folder. */
export async function filesOf(folder) {
  const files = {};
  for (const entry of await readdir(folder, { recursive: true, withFileTypes: true })) {
    if (!entry.isFile()) continue;
    const path = join(entry.parentPath ?? entry.path, entry.name);
    files["/" + path.slice(folder.length).replace(/^\/+/, "")] = await readFile(path);
  }
  return files;
}

/** Files of a zip archive that stores them as they are. */
export async function filesOfZip(archive) {
  const bytes = await readFile(archive);
  const files = {};
  let end = bytes.length - 22;
  while (bytes.readUInt32LE(end) !== 0x06054b50) end -= 1;
  let at = bytes.readUInt32LE(end + 16);
  for (let left = bytes.readUInt16LE(end + 10); left > 0; left -= 1) {
    const [method, size] = [bytes.readUInt16LE(at + 10), bytes.readUInt32LE(at + 20)];
    const lengths = [28, 30, 32].map((offset) => bytes.readUInt16LE(at + offset));
    const local = bytes.readUInt32LE(at + 42);
    const name = bytes.toString("utf8", at + 46, at + 46 + lengths[0]);
    if (method !== 0) throw new Error(`${name} is compressed`);
    const from = local + 30 + bytes.readUInt16LE(local + 26) + bytes.readUInt16LE(local + 28);
    files["/" + name] = bytes.subarray(from, from + size);
    at += 46 + lengths[0] + lengths[1] + lengths[2];
  }
  return files;
}

/** `before(path, answer, request)` may take its time, or answer by itself and then returns true. */
export async function serve(files, before = async () => false) {
  const server = createServer(async (request, answer) => {
    const path = new URL(request.url, "http://localhost").pathname;
    if (await before(path, answer, request)) return;
    const bytes = files[path];
    if (!bytes) return answer.writeHead(404).end();
    answer.writeHead(200, { "Content-Type": types[path.split(".").pop()] ?? "text/plain" });
    answer.end(bytes);
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  return { base: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}
