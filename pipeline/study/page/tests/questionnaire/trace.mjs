// What is made of the places of a marker: node --test trace.mjs
import assert from "node:assert/strict";
import { test } from "node:test";
import { bundled } from "../bundled.mjs";

const { TraceNotes, meanOfTrace } = await bundled("questionnaire/trace.ts");

const traceOf = (notes, seconds) => {
  const trace = new TraceNotes();
  for (const [time, value] of notes) trace.note(time, value);
  return trace.text(seconds);
};

test("samples lie between the notes before and after them", () => {
  assert.equal(traceOf([[0, 50], [0.05, 50], [0.25, 70]], 0.3), "50 55 65 70");
  assert.equal(traceOf([[0, 50], [0.1, 60], [0.2, 40]], 0.2), "50 60 40");
  assert.equal(traceOf([[0, 0], [0.3, 100]], 0.3), "0 33.3 66.7 100");
});

test("a film has a sample at its end", () => {
  assert.equal(traceOf([[0, 50], [0.2, 50], [0.21, 51]], 0.21), "50 50 50 51");
  assert.equal(traceOf([[0, 50]], 3 + 1e-9).split(" ").length, 31);
});

test("while a film stands still, the last place counts", () => {
  assert.equal(traceOf([[0, 50], [0.1, 50], [0.1, 58], [0.1, 60], [0.2, 60]], 0.2), "50 60 60");
});

test("what comes late is left out, and another playing begins anew", () => {
  const trace = new TraceNotes();
  for (const [time, value] of [[0, 50], [0.2, 90], [0.1, 10]]) trace.note(time, value);
  assert.equal(trace.text(0.2), "50 70 90");
  trace.clear();
  trace.note(0, 20);
  assert.equal(trace.text(0.2), "20 20 20");
});

test("means leave out the lead", () => {
  assert.equal(meanOfTrace("0 10 20 30 40", 0), 20);
  assert.equal(meanOfTrace("0 10 20 30 40", 0.3), 35);
  assert.equal(meanOfTrace("0 10 20 30 40", 0.5), null);
});
