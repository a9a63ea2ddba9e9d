import { textsOf, type Texts } from "../questionnaire/texts";
import { matchingTexts as documents, questionnaireTexts, type InMatching, type MatchingTexts } from "../texts/languages";
import { spoken, type OwnTexts, type Section } from "../texts/phrase";

export type { MatchingTexts };

const english = "en";

/** A section of texts in a language: the study's own, or those of the page. */
export function sectionOf<Name extends "matching" | "in_matching" | "chains">(
  documents: Record<string, Record<Name, Section>>, name: Name, language: string, own?: OwnTexts,
): Record<string, unknown> {
  const known = documents[language] ? language : english;
  const { direction } = own ?? questionnaireTexts[known]!;
  return spoken(own?.[name] ?? documents[known]![name], documents[english]![name], { language, direction });
}

/** What pages say of motions that are made while participants watch. */
export const matchingTexts = (language: string, own?: OwnTexts): MatchingTexts =>
  sectionOf(documents, "matching", language, own) as unknown as MatchingTexts;

/** The texts that experiments with live motions share with questionnaires, some of them in other words. */
export const sharedTexts = (language: string, own?: OwnTexts): Texts =>
  ({ ...textsOf(language, own), ...(sectionOf(documents, "in_matching", language, own) as unknown as InMatching) });
