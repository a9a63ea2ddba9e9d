// Asks a WebAssembly module as pages do, without a browser:
//   node live_module.mjs MODULE LIVE_JS BUNDLE REQUESTS FOLDER
// REQUESTS is a JSON array of requests (wasm_instance.ts). The answer to the i-th goes to FOLDER/i.bin,
// that to opening to FOLDER/open.bin; of one that is refused the words go to FOLDER/i.txt.
import { readFile, writeFile } from "node:fs/promises";
import { runInThisContext } from "node:vm";

const [module, live, bundle, requests, folder] = process.argv.slice(2);
runInThisContext(await readFile(live, "utf8"));
const bytes_of = async (file) => {
  const { buffer, byteOffset, byteLength } = await readFile(file);
  return buffer.slice(byteOffset, byteOffset + byteLength);
};
const ask = globalThis.mien_live.wasmInstance();
const opened = await ask({ what: "open", module: await bytes_of(module), bundle: await bytes_of(bundle) });
await writeFile(`${folder}/open.bin`, new Uint8Array(opened));
let at = 0;
for (const request of JSON.parse(await readFile(requests, "utf8"))) {
  try {
    await writeFile(`${folder}/${at}.bin`, new Uint8Array(await ask(request)));
  } catch (error) {
    await writeFile(`${folder}/${at}.txt`, String(error.message));
  }
  ++at;
}
