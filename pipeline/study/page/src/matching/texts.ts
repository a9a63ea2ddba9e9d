import { textsOf, type Texts } from "../questionnaire/texts";
import { matchingTexts as documents, questionnaireTexts, type InMatching, type MatchingTexts } from "../texts/languages";
import { spoken, type Section } from "../texts/phrase";

export type { MatchingTexts };

const english = "en";

function sectionOf(language: string, name: "matching" | "in_matching"): Record<string, unknown> {
  const known = documents[language] ? language : english;
  const { direction } = questionnaireTexts[known]!;
  const measure: Section = documents[english]![name];
  return spoken(documents[known]![name], measure, { language, direction });
}

/** What the page itself says of matching. */
export const matchingTexts = (language: string): MatchingTexts =>
  sectionOf(language, "matching") as unknown as MatchingTexts;

/** The texts that matching shares with questionnaires, some of them in other words. */
export const sharedTexts = (language: string): Texts =>
  ({ ...textsOf(language), ...(sectionOf(language, "in_matching") as unknown as InMatching) });
