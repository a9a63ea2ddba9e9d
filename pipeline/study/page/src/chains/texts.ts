import { sectionOf } from "../live_study/texts";
import { chainTexts as documents, type ChainTexts } from "../texts/languages";
import type { OwnTexts, Phrase } from "../texts/phrase";
import { element } from "../questionnaire/elements";

export type { ChainTexts };

export const chainTexts = (language: string, own?: OwnTexts): ChainTexts =>
  sectionOf(documents, "chains", language, own) as unknown as ChainTexts;

/** A text with a word that stands out. */
export function withWord(text: Phrase<"word">, word: string): Node[] {
  const mark = "\uE000";  // of private use: no text has it
  const [before, after] = text({ word: mark }).split(mark) as [string, string];
  return [new Text(before), element("strong", { class: "word" }, word), new Text(after)];
}
