// Manifests edited with their comments kept: node --test manifest_edit.mjs. MIEN_MANIFESTS: the folder of
// the manifests that come with mien.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { parse } from "yaml";
import { bundled } from "../bundled.mjs";

const { edited } = await bundled("studio/manifest_edit.ts");

const valueOf = (text) => parse(text, { merge: true });
/** A document changed in place. */
const changed = (text, change) => {
  const document = structuredClone(valueOf(text));
  change(document);
  return document;
};
const edit = (text, change) => edited(text, "m.yaml", valueOf(text), changed(text, change));
const refusal = (text, change) => {
  try {
    edit(text, change);
  } catch (error) {
    return error.message;
  }
  return "";
};

const study = `# what it is for
mien: 1   # version
look: {scene: studio, 'figure': stick}   # quiet
stimuli:
  # first
  - id: a   # the one
    adjectives:
      quickness: 0.7   # brisk
      largeness: 0.65

  # second
  - id: "b"
    weights: {normal: 0.6, proud: 0.4}
`;
const withText = (before, after) => {
  assert.ok(study.includes(before));
  return study.replace(before, after);
};

test("sets a number and nothing else", () => {
  assert.equal(edit(study, (m) => { m.stimuli[0].adjectives.quickness = 0.25; }), withText("0.7 ", "0.25 "));
});

test("keeps the quotes of texts", () => {
  assert.equal(edit(study, (m) => { m.stimuli[1].id = "new b"; }), withText('"b"', '"new b"'));
  assert.equal(edit("a: 'it''s'   # x\n", (m) => { m.a = "that's"; }), "a: 'that''s'   # x\n");
});

test("adds members where the map ends", () => {
  assert.equal(edit(study, (m) => { m.stimuli[0].adjectives.clearness = 0.5; }),
    withText("0.65\n", "0.65\n      clearness: 0.5\n"));
  assert.equal(edit(study, (m) => { m.look.camera = "side"; }), withText("stick}", "stick, camera: side}"));
});

test("removes members with their lines", () => {
  assert.equal(edit(study, (m) => { delete m.stimuli[0].adjectives.quickness; }),
    withText("      quickness: 0.7   # brisk\n", ""));
  const removed = (text, change, after) => assert.equal(edit(text, change), after);
  removed("a: {b: 1, c: 2}\n", (m) => { delete m.a.b; }, "a: {c: 2}\n");
  removed("a: {b: 1, c: 2}\n", (m) => { delete m.a.c; }, "a: {b: 1}\n");
  removed("a:\n  b: 1\nc: 2\n", (m) => { delete m.a.b; }, "a:\n  {}\nc: 2\n");
  removed("a:\n  - b: 1\n    c: 2\n", (m) => { delete m.a[0].b; }, "a:\n  - c: 2\n");
  removed("a: 1\nb: 2", (m) => { delete m.b; }, "a: 1");
  removed("a: 1\r\nb: 2", (m) => { delete m.b; }, "a: 1");
});

test("adds and removes stimuli", () => {
  const added = { id: "c", weights: { sad: 1 } };
  const lines = "  - id: c\n    weights: {sad: 1}\n";
  assert.equal(edit(study, (m) => { m.stimuli.push(added); }), study + lines);
  assert.equal(edit(study, (m) => { m.stimuli.splice(1, 0, added); }), withText("0.65\n", `0.65\n${lines}`));
  assert.equal(edit(study, (m) => { m.stimuli.unshift(added); }),
    withText("  - id: a", `${lines}  - id: a`));
  assert.equal(edit(study, (m) => { m.stimuli.pop(); }), study.slice(0, study.indexOf('  - id: "b"')));
});

test("keeps line breaks of Windows and a byte order mark", () => {
  assert.equal(edit("a:\r\n  b: 1 # x\r\n", (m) => { m.a.c = 2; }), "a:\r\n  b: 1 # x\r\n  c: 2\r\n");
  assert.equal(edit("a: 1\r\nb: 2\r\n", (m) => { delete m.a; }), "b: 2\r\n");
  assert.equal(edit("\uFEFFa: 1 # x\n", (m) => { m.b = 2; }), "\uFEFFa: 1 # x\nb: 2\n");
});

test("fills what is empty", () => {
  assert.equal(edit("a:\nb: 2\n", (m) => { m.a = "x"; }), "a: x\nb: 2\n");
  assert.equal(edit("a: # why\nb: 2\n", (m) => { m.a = "x"; }), "a: x # why\nb: 2\n");
  assert.equal(edit("a:    # why\n", (m) => { m.a = 1; }), "a:    1 # why\n");
  assert.equal(edit("a: ~\n", (m) => { m.a = 1; }), "a: 1\n");
  assert.equal(edit("a: {}\n", (m) => { m.a.b = 1; }), "a: {b: 1}\n");
  assert.equal(edit("a: []\n", (m) => { m.a.push(1); }), "a: [1]\n");
  assert.equal(edit("a: {b, c: 1}\n", (m) => { m.a.b = 2; }), "a: {b: 2, c: 1}\n");
});

test("quotes what would be read as something else", () => {
  const texts = ["true", "12", "", "a: b", "x # y", "${HOME}", "~", "No", "1e3", '"', "'", "a\nb", "- a", "日本", "{", "*a",
    "&a", "!a", "%a", "@a", "`a", " a ", "0x1F", ".5", "null", "two words", "1_000", "2026-11-25"];
  for (const text of texts) {
    for (const before of ["a: 1\n", "a: 'x'\n", 'a: "x"\n', "a: [1]\n", "b: {a: 1}\n"]) {
      const holder = (document) => (before.startsWith("b") ? document.b : document);
      const after = edit(before, (m) => { holder(m).a = text; });
      assert.equal(holder(valueOf(after)).a.replaceAll("$${", "${"), text, after);
      // By YAML 1.1, too.
      assert.equal(typeof holder(parse(after, { version: "1.1" })).a, "string", after);
    }
  }
  assert.equal(edit("a: 1\n", (m) => { m.a = "${HOME}"; }), 'a: "$${HOME}"\n');
});

test("leaves variables that were expanded as they stand", () => {
  // The server's document has what stands in the environment.
  const text = "out: ${PLACE}   # from outside\nprice: $${X}\na: 1\n";
  const document = { out: "/home", price: "${X}", a: 1 };
  assert.equal(edited(text, "m.yaml", document, { ...document, a: 2 }), text.replace("a: 1", "a: 2"));
});

test("writes long maps below each other", () => {
  const long = Object.fromEntries(Array.from({ length: 12 }, (_, i) => [`parameter-${i}`, 0.125]));
  const text = edit("a:\n  b: 1\n", (m) => { m.a.c = long; });
  assert.ok(text.startsWith("a:\n  b: 1\n  c:\n    parameter-0: 0.125\n"), text);
  assert.deepEqual(valueOf(text).a.c, long);
  const replaced = edit("a: {x: 1}   # kept\nb: 2\n", (m) => { m.a = [long, long]; });
  assert.ok(replaced.startsWith("a:\n  - parameter-0: 0.125\n    parameter-1: 0.125\n"), replaced);
  assert.ok(replaced.endsWith("   # kept\nb: 2\n"), replaced);
  const short = edit("a:\n  b: 1\n", (m) => { m.a.c = { d: [{ e: 1 }, long] }; });
  assert.ok(short.startsWith("a:\n  b: 1\n  c:\n    d:\n      - {e: 1}\n      - parameter-0: 0.125\n"), short);
});

test("refuses aliases and merge keys", () => {
  const text = "base: &base {a: 1, b: 2}\nuse: *base\nmerged:\n  <<: *base\n  c: 3\nfree: &f {a: 1}\n";
  assert.equal(refusal(text, (m) => { m.use = { a: 5, b: 2 }; }),
    "m.yaml:2:6: this value is defined elsewhere in the file, through an alias; write the value out here, or edit it by "
    + "hand at its anchor");
  assert.equal(refusal(text, (m) => { m.base = { a: 5, b: 2 }; }),
    "m.yaml:1:13: this value is used again by the alias on line 2; write the value out there, or change it by hand");
  assert.match(refusal(text, (m) => { delete m.merged.a; }), /"a" comes from the merge key << of this map; write/);
  // What a merge key brings may be set over, and an anchor that nothing names is in nobody's way.
  assert.equal(valueOf(edit(text, (m) => { m.merged.a = 7; })).merged.a, 7);
  assert.ok(edit(text, (m) => { m.free.a = 7; }).includes("free: &f {a: 7}"));
  // A part that is used elsewhere does not go with the whole.
  assert.match(refusal("a: {b: &b 1}\nc: *b\n", (m) => { delete m.a; }), /a cannot be changed in this form of YAML/);
});

test("refuses several documents, and what is no YAML", () => {
  assert.match(refusal("a: 1\n---\nb: 2\n", (m) => { m.a = 2; }), /document/);
  assert.throws(() => edited("a: {b\n", "m.yaml", { a: 1 }, { a: 2 }), /m\.yaml:\d+:\d+: .*correct it in the file by hand/);
});

test("refuses to lose comments", () => {
  const text = "a: [1, # one\n    2]\nb: 1\n";
  assert.match(refusal(text, (m) => { m.a.shift(); }), /a comment beside this value would be lost/);
  assert.ok(edit(text, (m) => { m.a[0] = 5; m.a[1] = 6; }).includes("[5, # one"));
});

test("block texts, anchors, tags and nested lists stay whole", () => {
  const text = "a: |\n  one\n  two\n\n# end\nb: &x !!str text   # kept\nc:\n- - 1\n  - 2\n-\n  d: 1\n";
  assert.equal(edit(text, (m) => { m.b = "other"; }), text.replace("text", "other"));
  assert.equal(edit(text, (m) => { m.c[0].push(3); }), text.replace("  - 2\n", "  - 2\n  - 3\n"));
  assert.equal(edit(text, (m) => { m.c[1].e = 2; }), `${text}  e: 2\n`);
  assert.equal(edit(text, (m) => { m.a = "short"; }), text.replace("|\n  one\n  two", "short"));
});

/** Random numbers of a seed (mulberry32). */
const randomOf = (seed) => (below) => {
  seed = (seed + 0x6d2b79f5) | 0;
  let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) % below;
};
const isStructured = (value) => typeof value === "object" && value !== null;

function randomValue(random) {
  return [() => random(1000) / 1000, () => random(100) - 50, () => random(2) === 0,
    () => ["plain", "two words", "it's: so # quoted"][random(3)], () => [randomValue(random), "x"],
    () => ({ a: randomValue(random), "b c": 1 }), () => ({})][random(7)]();
}

/** Goes down at random, and changes something there. */
function changeSomewhere(value, random) {
  const keys = isStructured(value) ? Object.keys(value) : [];
  const key = keys[random(Math.max(1, keys.length))];
  if (key !== undefined && random(4) !== 0) {
    if (isStructured(value[key])) changeSomewhere(value[key], random);
    else value[key] = randomValue(random);
  } else if (Array.isArray(value)) {
    const at = random(value.length + 1);
    if (random(2) === 0 || at === value.length) value.splice(at, 0, randomValue(random));
    else value.splice(at, 1);
  } else if (key === undefined || random(2) === 0) value[`new-${random(100)}`] = randomValue(random);
  else delete value[key];
}

const manifests = readdirSync(process.env.MIEN_MANIFESTS).filter((name) => /^[^.]+\.yaml$/.test(name))
  .map((name) => [name, readFileSync(join(process.env.MIEN_MANIFESTS, name), "utf8")]);
const commentsIn = (text) => text.split("\n").filter((line) => /^ *#/.test(line));

for (const seed of [1, 2, 3]) {
  test(`says what was wanted and keeps the comments, changed at random (${seed})`, () => {
    const random = randomOf(seed);
    let made = 0, refused = 0;
    for (let [name, text] of manifests) {
      for (let trial = 0; trial < 6; trial += 1) {
        const wanted = changed(text, (document) => changeSomewhere(document, random));
        let after;
        try {
          after = edited(text, name, valueOf(text), wanted);
        } catch (error) {
          assert.match(error.message, /alias|comment|merge key/, `${name}: ${JSON.stringify(wanted).slice(0, 300)}`);
          refused += 1;
          continue;
        }
        made += 1;
        assert.deepEqual(valueOf(after), wanted, name);
        // In the same order, those in what went left out.
        const were = commentsIn(text);
        for (const comment of commentsIn(after)) {
          const at = were.indexOf(comment);
          assert.ok(at >= 0, `${name}: ${comment}`);
          were.splice(0, at + 1);
        }
        text = after;
      }
    }
    assert.ok(made > 10 * refused, `${made} made, ${refused} refused`);
  });
}

test("lines that a change does not touch stay to the byte", () => {
  for (const [name, text] of manifests) {
    if (!valueOf(text).stimuli?.length) continue;
    const after = edited(text, name, valueOf(text), changed(text, (m) => { m.stimuli[0].id = "renamed"; }));
    const [lines, linesAfter] = [text.split("\n"), after.split("\n")];
    assert.equal(lines.filter((line, i) => line !== linesAfter[i]).length, 1, name);
    assert.equal(lines.length, linesAfter.length, name);
  }
});
