// Fixed texts of the pages (page/texts); those of the study (consent, instructions, questions) are in experiment.json.

import { questionnaireTexts, type Texts } from "../texts/languages";
import { spoken, type OwnTexts } from "../texts/phrase";

export type { Texts };

const english = "en";

/** The texts in a language: those of the study, if it has its own, or the built-in ones, or English ones. */
export function textsOf(language: string, own?: OwnTexts): Texts {
  const { direction, questionnaire } = own ?? (questionnaireTexts[language] ?? questionnaireTexts[english])!;
  return spoken(questionnaire, questionnaireTexts[english]!.questionnaire, { language, direction }) as unknown as Texts;
}

export const directionOf = (language: string, own?: OwnTexts): "ltr" | "rtl" =>
  (own ?? questionnaireTexts[language])?.direction ?? "ltr";

/** The degree that a point of a scale stands for: "very"; for the middle, "neither". */
export function degreeOf(texts: Texts, place: number, points: number): string {
  const middle = (points + 1) / 2;
  const distance = Math.abs(place - middle);
  if (distance < 0.25) return texts.neither;
  const words = points <= 3 ? [""] : points <= 5 ? [texts.rather, texts.very]
    : [texts.slightly, texts.rather, texts.very];
  const share = distance / ((points - 1) / 2);
  return words[Math.max(0, Math.ceil(share * words.length - 1e-9) - 1)]!;
}

/** What a point means in full: "very sad". */
export function meaningOf(texts: Texts, place: number, points: number, left: string, right: string): string {
  const middle = (points + 1) / 2;
  const degree = degreeOf(texts, place, points);
  if (place === middle) return degree;
  const word = place < middle ? left : right;
  return degree ? texts.degreeOf({ degree, word }) : word;
}
