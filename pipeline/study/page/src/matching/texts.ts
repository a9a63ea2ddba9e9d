import { textsOf, type Texts } from "../questionnaire/texts";
import { matchingTexts as documents, questionnaireTexts, type InMatching, type MatchingTexts } from "../texts/languages";
import { spoken, type OwnTexts, type Section } from "../texts/phrase";

export type { MatchingTexts };

const english = "en";

function sectionOf(
  language: string, name: "matching" | "in_matching", own?: OwnTexts): Record<string, unknown> {
  const known = documents[language] ? language : english;
  const { direction } = own ?? questionnaireTexts[known]!;
  const measure: Section = documents[english]![name];
  return spoken((own ?? documents[known]!)[name], measure, { language, direction });
}

/** What the page itself says of matching. */
export const matchingTexts = (language: string, own?: OwnTexts): MatchingTexts =>
  sectionOf(language, "matching", own) as unknown as MatchingTexts;

/** The texts that matching shares with questionnaires, some of them in other words. */
export const sharedTexts = (language: string, own?: OwnTexts): Texts =>
  ({ ...textsOf(language, own), ...(sectionOf(language, "in_matching", own) as unknown as InMatching) });
