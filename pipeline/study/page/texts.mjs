// The texts that participants read: texts/<language>.yaml become src/texts/languages.ts, which the pages bundle.
// texts/en.yaml says which keys and placeholders there are.
import { readFile, readdir, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { parse } from "yaml";

/** Keys of documents are snake_case, those of the pages' code camelCase. */
const camel = (key) => key.replace(/_([a-z])/g, (_, letter) => letter.toUpperCase());

const categories = new Set(["zero", "one", "two", "few", "many", "other"]);

/** {count: {one: …, other: …}}: a text for each plural category of a number. */
const isPlural = (value) => {
  const [forms, ...more] = Object.values(value);
  return !more.length && typeof forms === "object" && Object.keys(forms).every((key) => categories.has(key));
};

/** The type of a text of English: what must be given to have it in words. */
function typeOf(value) {
  if (Array.isArray(value)) return "string[]";
  if (typeof value === "object" && !isPlural(value))
    return `{ ${Object.entries(value).map(([key, one]) => `${camel(key)}: ${typeOf(one)}`).join("; ")} }`;
  const names = new Set([...JSON.stringify(value).matchAll(/\{([a-z_]+)\}/g)].map(([, name]) => camel(name)));
  return names.size ? `Phrase<${[...names].map((name) => `"${name}"`).join(" | ")}>` : "string";
}

const interfaceOf = (name, section) => `export interface ${name} {
${Object.entries(section).map(([key, value]) => `  ${camel(key)}: ${typeOf(value)};`).join("\n")}
}
`;

/** The documents by language. */
export async function readTexts(folder) {
  const texts = {};
  for (const file of (await readdir(folder)).filter((name) => name.endsWith(".yaml")).sort())
    texts[file.slice(0, -".yaml".length)] = parse(await readFile(join(folder, file), "utf8"));
  return texts;
}

/** Writes the module of a page folder. */
export async function writeTexts(page) {
  const texts = await readTexts(join(page, "texts"));
  const { questionnaire, matching, chains } = texts.en;
  const sections = (...names) => JSON.stringify(Object.fromEntries(Object.entries(texts)
    .map(([language, given]) => [language, Object.fromEntries(names.map((name) => [name, given[name]]))])), null, 1);
  await writeFile(join(page, "src/texts/languages.ts"),
    `// Written by texts.mjs from texts/*.yaml.
import type { Phrase, Section } from "./phrase";

${interfaceOf("Texts", questionnaire)}
${interfaceOf("MatchingTexts", matching)}
${interfaceOf("ChainTexts", chains)}
/** What experiments with live motions say in place of texts of questionnaires, where these speak of questionnaires. */
export type InMatching = Pick<Texts, ${Object.keys(texts.en.in_matching).map((key) => `"${camel(key)}"`).join(" | ")}>;

/** By language: the texts that all pages of participants share, and the direction of writing. */
export const questionnaireTexts: Record<string, { direction: "ltr" | "rtl"; questionnaire: Section }> =
${sections("direction", "questionnaire")} as never;

/** By language: the texts of matching experiments, and what all experiments with live motions say. */
export const matchingTexts: Record<string, { matching: Section; in_matching: Section }> =
${sections("matching", "in_matching")} as never;

/** By language: the texts of Gibbs sampling and MCMC with people alone. */
export const chainTexts: Record<string, { chains: Section }> =
${sections("chains")} as never;
`);
}

/** For pages without scripts, in every language. */
export async function noScriptText(page) {
  const texts = await readTexts(join(page, "texts"));
  return Object.entries(texts).map(([language, { direction, questionnaire }]) =>
    `<p lang="${language}" dir="${direction}">${questionnaire.needs_script}</p>`).join("\n");
}
