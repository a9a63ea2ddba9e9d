/** A text with placeholders: what it says with these numbers and names. */
export type Phrase<Name extends string> = (named: Record<Name, number | string>) => string;

/** A text for each plural category of a number, by the name of the number: {count: {one: …, other: …}}. */
type Plural = Record<string, Partial<Record<Intl.LDMLPluralRule, string>> & { other: string }>;

/** Texts of a language as its file has them, with keys in snake_case. */
export interface Section {
  [key: string]: string | string[] | Plural | Section;
}

/** A study's own texts of pages in a language, complete. */
export interface OwnTexts {
  direction: "ltr" | "rtl";
  questionnaire: Section;
  matching: Section;
  in_matching: Section;
  chains: Section;
}

/** How a language is written. */
export interface Writing {
  language: string;
  direction: "ltr" | "rtl";
}

const camel = (key: string): string => key.replace(/_([a-z])/g, (_, letter: string) => letter.toUpperCase());

const isPlural = (given: object): given is Plural => {
  const [forms, ...more] = Object.values(given);
  return !more.length && typeof forms === "object" && typeof forms.other === "string";
};

/** Numbers are written with the digits 0 … 9, which are also the keys that choose answers; with `decimals` after
    the mark, or as many as there are. */
export const numberText = (value: number, language: string, decimals?: number): string =>
  new Intl.NumberFormat(language, { numberingSystem: "latn", useGrouping: false,
    minimumFractionDigits: decimals ?? 0, maximumFractionDigits: decimals ?? 2 } as never).format(value);

/** A name in other letters does not disturb the order of words of a text written from right to left. */
const isolated = (name: string, { direction }: Writing): string =>
  (direction === "rtl" ? `\u2068${name}\u2069` : name);

function filled(text: string, named: Record<string, number | string>, writing: Writing): string {
  return text.replace(/\{([a-z_]+)\}/g, (_, name: string) => {
    const value = named[camel(name)]!;
    return typeof value === "number" ? numberText(value, writing.language) : isolated(value, writing);
  });
}

function phraseOf(given: string | Plural, writing: Writing): Phrase<string> {
  if (typeof given === "string") return (named) => filled(given, named, writing);
  const [number, forms] = Object.entries(given)[0]!;
  return (named) => {
    const category = new Intl.PluralRules(writing.language).select(Number(named[camel(number)]));
    return filled(forms[category] ?? forms.other, named, writing);
  };
}

/**
 * The texts of a section as the pages use them, with keys in camelCase: texts, lists of them, and functions where
 * English (`measure`) has placeholders.
 */
export function spoken(given: Section, measure: Section, writing: Writing): Record<string, unknown> {
  const said = (key: string): unknown => {
    const value = given[key]!, english = measure[key]!;
    if (Array.isArray(value)) return value;
    if (typeof english === "object" && !Array.isArray(english) && !isPlural(english))
      return spoken(value as Section, english, writing);
    const isPhrase = typeof english !== "string" || /\{[a-z_]+\}/.test(english);
    return isPhrase ? phraseOf(value as string | Plural, writing) : value;
  };
  return Object.fromEntries(Object.keys(measure).map((key) => [camel(key), said(key)]));
}
