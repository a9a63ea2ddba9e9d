import { chooseByKeys, focusChoice } from "./choice_keys";
import { button, element, heading, paragraphs } from "./elements";
import type { Demographic, PageRecord, Response } from "./experiment";
import type { Wait } from "./store";
import type { Texts } from "./texts";

export interface GivenOnPage {
  pressed: number;
  responses: Response[];
  comment: string;
  started_at: string;
}

export type KeepPage = (given: GivenOnPage, page: HTMLElement) => Promise<void>;

interface Question {
  id: string;
  root: HTMLElement;
  focus(): void;
  /** The answer; null where it was left out, a text where it is wrong. */
  read(): { value: number | string | null; wrong?: string; at: number };
}

/** Digits of Japanese keyboards are wide, and Arabic and Persian have digits and a decimal mark of their own. */
export const plainDigits = (text: string): string => text.normalize("NFKC")
  .replace(/[\u0660-\u0669]/g, (digit) => String(digit.charCodeAt(0) - 0x660))
  .replace(/[\u06f0-\u06f9]/g, (digit) => String(digit.charCodeAt(0) - 0x6f0))
  .replace("\u066b", ".");

function questionOf(asked: Demographic, texts: Texts): Question {
  const name = `about-${asked.id}`;
  const error = element("p", { class: "wrong", id: `${name}-wrong`, role: "alert" });
  let at = performance.now();
  const optional = asked.required ? "" : ` (${texts.optional})`;
  if (Array.isArray(asked.answer)) {
    const root = element("fieldset", { class: "question" }, element("legend", {}, asked.ask + optional));
    const inputs = asked.answer.map((text, index) => {
      const value = asked.values?.[index] ?? text;
      const input = element("input", { type: "radio", name, value, id: `${name}-${index}` });
      input.addEventListener("change", () => { at = performance.now(); });
      root.append(element("div", { class: "line" }, input, element("label", { for: input.id }, text)));
      return input;
    });
    // Number keys choose here as they do in trials.
    chooseByKeys(root, inputs, (input) => input.click());
    root.append(error);
    return {
      id: asked.id, root, focus: () => focusChoice(root, inputs),
      read() {
        const value = inputs.find((input) => input.checked)?.value ?? null;
        error.textContent = value === null && asked.required ? texts.answerWanted : "";
        return { value, wrong: error.textContent, at };
      },
    };
  }
  const isNumber = asked.answer === "number";
  const input = element("input", { type: "text", id: name, maxlength: "200", "aria-describedby": error.id,
    autocomplete: "off", ...(isNumber ? { inputmode: "decimal" } : {}) });
  input.addEventListener("input", () => { at = performance.now(); });
  return {
    id: asked.id,
    root: element("div", { class: "question" },
      element("label", { for: name }, asked.ask + optional), input, error),
    focus: () => input.focus(),
    read() {
      const text = input.value.trim();
      const narrow = plainDigits(text);
      const isWrong = isNumber && text !== "" && !(/^[-+]?\d+([.,]\d+)?$/.test(narrow));
      error.textContent = isWrong ? texts.numberWanted
        : text === "" && asked.required ? texts.answerWanted : "";
      input.setAttribute("aria-invalid", String(error.textContent !== ""));
      const value = text === "" ? null : isNumber ? Number(narrow.replace(",", ".")) : text;
      return { value, wrong: error.textContent, at };
    },
  };
}

/** A page of texts and questions. */
export interface AskedPage {
  title: string;
  texts?: string[];
  /** Labels of the buttons; the first goes on. */
  buttons: string[];
  questions?: Demographic[];
  /** Label of a place for free words. */
  comment?: string;
  words: Texts;
  keep?: KeepPage | null;
}

/** Shows a page; resolves with the button that was pressed once what was given is kept. */
export function showTextPage(display: HTMLElement, asked: AskedPage): Promise<number> {
  let done: (pressed: number) => void = () => {};
  const pressedLast = new Promise<number>((resolve) => { done = resolve; });
  const texts = asked.words;
  const began = performance.now();
  const startedAt = new Date().toISOString();
  const title = heading(asked.title);
  const questions = (asked.questions ?? []).map((one) => questionOf(one, texts));
  const comment = element("textarea", { rows: "4", maxlength: "4000", id: "last-words" });
  const page = element("article", { class: "page" }, title, ...paragraphs(asked.texts ?? []),
    ...questions.map(({ root }) => root));
  if (asked.comment)
    page.append(element("div", { class: "question" },
      element("label", { for: comment.id }, asked.comment), comment));

  const press = async (pressed: number) => {
    const read = questions.map((question) => ({ question, ...question.read() }));
    const wrong = read.find((one) => one.wrong);
    if (wrong && pressed === 0) return wrong.question.focus();
    for (const one of buttons) one.disabled = true;
    const responses = read.flatMap(({ question, value, at }): Response[] => value === null ? []
      : [{ item: question.id, value_raw: value, rt_ms: Math.round(at - began) }]);
    await asked.keep?.({ pressed, responses, comment: comment.value.trim(), started_at: startedAt }, page);
    done(pressed);
  };
  const buttons = asked.buttons.map((text, index) =>
    button(text, () => void press(index), index === 0 ? "main" : ""));
  page.append(element("div", { class: "buttons" }, ...buttons));
  // Enter goes on from a field as it does in any form; elsewhere it shows first what it would press.
  const enter = (event: KeyboardEvent) => {
    if (!page.isConnected) return document.removeEventListener("keydown", enter);
    const at = event.target;
    if (event.key !== "Enter" || event.isComposing || at instanceof HTMLTextAreaElement) return;
    if (event.repeat) event.preventDefault();
    if (event.repeat || at instanceof HTMLButtonElement) return;
    event.preventDefault();
    if (at instanceof HTMLInputElement) void press(0);
    else buttons[0]?.focus();
  };
  document.addEventListener("keydown", enter);
  display.replaceChildren(page);
  scrollTo(0, 0);
  if (questions[0]) questions[0].focus();
  else if (buttons.length > 1) title.focus();  // no choice is made by a key too many
  else buttons[0]?.focus({ preventScroll: true });
  return pressedLast;
}

/** The note that saving takes long, at the foot of a page. */
export function waitNote(page: HTMLElement, texts: Pick<Texts, "saving" | "saveFailed">, busy = texts.saving): Wait {
  const note = element("p", { class: "waiting", role: "status" });
  const said = { saving: texts.saving, failed: texts.saveFailed, busy };
  return (why) => {
    if (!note.isConnected) page.append(note);
    note.textContent = said[why];
  };
}

export const pageRecord = (record: string, session: string, given: GivenOnPage): PageRecord => ({
  record, session, responses: given.responses, comment: given.comment, started_at: given.started_at,
});
