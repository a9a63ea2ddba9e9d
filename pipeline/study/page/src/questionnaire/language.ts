// The language of a page: that of the study or, where a study has several, the one that the browser prefers.

import type { OwnTexts } from "../texts/phrase";

/** What an experiment has in each language. */
export interface InLanguages {
  language: string;
  /** What is shown instead in each of the languages offered, by tag; the first is that of the experiment itself. */
  languages?: Record<string, object>;
  /** The study's own texts of pages, by language. */
  page_texts?: Record<string, OwnTexts>;
}

const main = (tag: string): string => tag.toLowerCase().split("-")[0]!;

/** The language offered that fits the most preferred one; the first where none fits (RFC 4647, lookup). */
function preferredLanguage(offered: string[], preferred: readonly string[]): string {
  for (const wanted of preferred) {
    const parts = wanted.toLowerCase().split("-");
    for (let count = parts.length; count > 0; count -= 1) {
      const tag = parts.slice(0, count).join("-");
      const found = offered.find((one) => one.toLowerCase() === tag);
      if (found) return found;
    }
    const related = offered.find((one) => main(one) === main(wanted));
    if (related) return related;
  }
  return offered[0]!;
}

/** The experiment in the language that the browser prefers. */
export function inLanguage<Own extends InLanguages>(experiment: Own, preferred: readonly string[]): Own {
  if (!experiment.languages) return experiment;
  const language = preferredLanguage(Object.keys(experiment.languages), preferred);
  return { ...experiment, ...experiment.languages[language], language };
}
