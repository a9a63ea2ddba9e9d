// What pages say in each language: node --test texts.mjs
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { parse } from "yaml";
import { bundled } from "./bundled.mjs";

const folder = join(dirname(dirname(fileURLToPath(import.meta.url))), "texts");
const documents = Object.fromEntries(readdirSync(folder).map((file) =>
  [file.replace(".yaml", ""), parse(readFileSync(join(folder, file), "utf8"))]));

/** All {category: text} in a document. */
const pluralForms = (value) => typeof value !== "object" ? []
  : "other" in value ? [value] : Object.values(value).flatMap(pluralForms);

test("plural forms are those of the browser's rules", () => {
  for (const [language, document] of Object.entries(documents)) {
    const { pluralCategories } = new Intl.PluralRules(language).resolvedOptions();
    assert.deepEqual(new Intl.PluralRules(language).resolvedOptions().locale, language);
    const forms = pluralForms(document);
    assert.equal(forms.length > 0, pluralCategories.length > 1, language);
    for (const form of forms)
      assert.deepEqual(Object.keys(form).sort(), [...pluralCategories].sort(), language);
  }
});

test("numbers and names are put into texts", async () => {
  const { textsOf } = await bundled("questionnaire/texts.ts");
  assert.equal(textsOf("en").missing({ count: 1 }), "One answer is missing.");
  assert.equal(textsOf("en").missing({ count: 12 }), "12 answers are missing.");
  assert.equal(textsOf("de").replaysLeft({ left: 1 }), "noch 1 Wiederholung");
  assert.equal(textsOf("de").replaysLeft({ left: 2 }), "noch 2 Wiederholungen");
  assert.equal(textsOf("fr").replaysLeft({ left: 0 }), "encore 0 relecture");
  assert.equal(textsOf("ja").preparingOf({ done: 3, all: 40 }), "40本中3本の動画を読み込みました。");
  assert.equal(textsOf("ar").missing({ count: 2 }), "هناك إجابتان ناقصتان.");
  assert.equal(textsOf("ar").missing({ count: 5 }), "هناك 5 إجابات ناقصة.");
  assert.equal(textsOf("ar").missing({ count: 11 }), "هناك 11 إجابة ناقصة.");
  assert.equal(textsOf("ar").saveFile({ name: "a.csv" }), "حفظ \u2068a.csv\u2069");
  assert.equal(textsOf("de").sitAt({ cm: 57.5 }).match(/[\d,.]+ cm/)[0], "57,5 cm");
  assert.equal(textsOf("en").windowSize({ width: 1200, height: 1, needsWidth: 2, needsHeight: 3 }),
    "The window has 1200 × 1 pixels; at least 2 × 3 are needed.");
  assert.equal(textsOf("xx").next, "Continue");
});

/** Words that stand for a number in Arabic, whose dual needs none. */
const countWords = /لم تبقَ|واحدة|إعادتان/;

test("what is left of something says how much, for every number", async () => {
  const { textsOf } = await bundled("questionnaire/texts.ts");
  for (const language of Object.keys(documents))
    for (const left of [0, 1, 2, 3, 11]) {
      const said = textsOf(language).replaysLeft({ left });
      assert.ok(said.includes(String(left)) || (language === "ar" && countWords.test(said)), `${language}: ${said}`);
    }
});

test("degrees are where the language has them", async () => {
  const { meaningOf, textsOf } = await bundled("questionnaire/texts.ts");
  const said = (language, place) => meaningOf(textsOf(language), place, 5, "LEFT", "RIGHT");
  assert.equal(said("en", 1), "very LEFT");
  assert.equal(said("ja", 5), "とてもRIGHT");
  assert.equal(said("ar", 4).replace(/[\u2068\u2069]/g, ""), "RIGHT إلى حدٍّ ما");
  assert.equal(said("de", 3), "weder noch");
});

test("a study's own texts are used", async () => {
  const { directionOf, textsOf } = await bundled("questionnaire/texts.ts");
  const own = { direction: "rtl", questionnaire: { ...documents.en.questionnaire, next: "Vidare",
    missing: { count: { other: "{count} saknas" } } } };
  assert.equal(textsOf("sv", own).next, "Vidare");
  assert.equal(textsOf("sv", own).missing({ count: 1 }), "1 saknas");
  assert.equal(textsOf("fa", own).missing({ count: 12 }), "12 saknas");
  assert.equal(directionOf("sv", own), "rtl");
  assert.equal(directionOf("ar"), "rtl");
  assert.equal(directionOf("sv"), "ltr");
});

test("the browser's preference decides between languages", async () => {
  const { inLanguage } = await bundled("questionnaire/language.ts");
  const chosen = (offered, ...preferred) => inLanguage({ language: offered[0],
    languages: Object.fromEntries(offered.map((tag) => [tag, { title: tag }])) }, preferred).language;
  assert.equal(chosen(["en", "de", "ja"], "ja", "de"), "ja");
  assert.equal(chosen(["en", "de", "ja"], "de-AT"), "de");
  assert.equal(chosen(["en", "de"], "fr", "de"), "de");
  assert.equal(chosen(["en", "de"], "fr"), "en");
  assert.equal(chosen(["en", "de"]), "en");
  assert.equal(chosen(["en", "pt-BR"], "pt-PT"), "pt-BR");
  assert.equal(chosen(["zh", "en"], "zh-Hant-TW"), "zh");
  assert.equal(chosen(["zh-Hans", "zh-Hant"], "zh-Hant-TW"), "zh-Hant");
  assert.equal(chosen(["en", "pt", "pt-BR"], "PT-br"), "pt-BR");
  assert.deepEqual(inLanguage({ language: "de" }, ["en"]), { language: "de" });
  assert.deepEqual(inLanguage({ language: "en", title: "T", languages: { en: {}, de: { title: "D" } } }, ["de"]),
    { language: "de", title: "D", languages: { en: {}, de: { title: "D" } } });
});
