// How the pages' modules hang together: node --test modules.mjs
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const source = join(dirname(dirname(fileURLToPath(import.meta.url))), "src");

/** Texts of modules by their names, "studio/heat". */
const modules = new Map(readdirSync(source, { recursive: true }).filter((name) => name.endsWith(".ts"))
  .map((name) => [name.slice(0, -3), readFileSync(join(source, name), "utf8")]));

/** What a module imports or exports again, types too: [module, names]. */
const importsOf = (name, text) => [...text.matchAll(/^(?:import|export) ([^;]*?) from "(\.[^"]*)"/gm)]
  .map(([, names, from]) => [join(dirname(name), from), names.match(/\w+/g)]);

/** The first circle of a graph, "a → b → a"; "" where there is none. */
function circleIn(graph) {
  const done = new Set();
  const from = (name, above) => {
    if (above.includes(name)) return [...above.slice(above.indexOf(name)), name].join(" → ");
    if (done.has(name)) return "";
    for (const next of graph.get(name) ?? []) {
      const found = from(next, [...above, name]);
      if (found) return found;
    }
    done.add(name);
    return "";
  };
  return [...graph.keys()].reduce((found, name) => found || from(name, []), "");
}

test("circles are found", () => {
  assert.equal(circleIn(new Map([["a", ["b", "c"]], ["b", ["c"]], ["c", []]])), "");
  assert.equal(circleIn(new Map([["a", ["b"]], ["b", ["c"]], ["c", ["b"]]])), "b → c → b");
});

test("imports run in no circle", () => {
  const graph = new Map([...modules].map(([name, text]) => [name, importsOf(name, text).map(([from]) => from)]));
  assert.ok([...graph.values()].flat().length > 150);
  for (const from of [...graph.values()].flat()) assert.ok(modules.has(from), from);
  assert.equal(circleIn(graph), "");
});

test("functions and values that are exported are used elsewhere", () => {
  const used = new Set([...modules].flatMap(([name, text]) =>
    importsOf(name, text).flatMap(([from, names]) => names.map((one) => `${from} ${one}`))));
  const unused = [...modules].flatMap(([name, text]) =>
    [...text.matchAll(/^export (?:async )?(?:function|class|const|let) (\w+)/gm)]
      .map(([, exported]) => `${name} ${exported}`));
  assert.deepEqual(unused.filter((one) => !used.has(one)), []);
});
