import type { LiveCore } from "../live/core";
import type { EarlyEnds } from "../questionnaire/early_ends";
import { button, element, heading } from "../questionnaire/elements";
import type { PageRecord } from "../questionnaire/experiment";
import { isTouched } from "../questionnaire/measures";
import { mayWithdraw } from "../questionnaire/session_page";
import { Declined, type Store, type Wait } from "../questionnaire/store";
import { root, show, showClosed, type Mode } from "../questionnaire/surroundings";
import { pageRecord, showTextPage, waitNote, type AskedPage, type GivenOnPage } from "../questionnaire/text_view";
import type { Texts } from "../questionnaire/texts";
import { coreOf } from "./core_of";
import type { LiveExperiment, LivePlan } from "./experiment";
import { matchingTexts, type MatchingTexts } from "./texts";

type Page = Omit<AskedPage, "words">;

/** What a session is made of. */
export interface SessionParts<Plan extends LivePlan, Own extends LiveExperiment<Plan>> {
  mode: Mode;
  experiment: Own;
  store: Store<Plan>;
  texts: Texts;
  ends: EarlyEnds | undefined;
}

const forever = () => new Promise<never>(() => {});

/** The pages of a session with live motions, one after the other; the trials are those of an experiment. */
export abstract class LiveSession<Plan extends LivePlan, Own extends LiveExperiment<Plan>> {
  protected readonly experiment: Own;
  protected readonly store: Store<Plan>;
  protected readonly texts: Texts;
  protected readonly words: MatchingTexts;

  constructor(protected readonly parts: SessionParts<Plan, Own>) {
    const { experiment, store, texts } = parts;
    this.experiment = experiment;
    this.store = store;
    this.texts = texts;
    this.words = matchingTexts(experiment.language, experiment.page_texts?.[experiment.language]);
  }

  /** What participants have to do. */
  protected abstract howTo(): string[];

  /** The use of the keyboard. */
  protected keys(): string[] {
    return [this.words.keys];
  }

  /** Takes the participant through all trials that are left; what is said on the last page. */
  protected abstract trials(core: LiveCore): Promise<string[]>;

  async run(): Promise<void> {
    const { experiment, texts } = this;
    if (!this.has("consent")) await this.consent();
    if (experiment.joining) return;
    await this.explain();
    if (experiment.demographics.length && !this.has("demographics"))
      await this.keeping("demographics",
        { title: texts.aboutYou, questions: experiment.demographics, buttons: [texts.next] });
    const said = await this.trials(await this.prepared());
    if (!this.has("ending"))
      await this.keeping("ending",
        { title: texts.almost, texts: said, comment: texts.lastWords, buttons: [texts.finish] });
    await this.store.finish(waitNote(root(), texts));
  }

  protected has(name: string): boolean {
    return this.store.kept.has(name);
  }

  protected page(asked: Page): Promise<number> {
    return showTextPage(root(), { ...asked, words: this.texts });
  }

  /** Returns once the record is kept. Throws Declined where the session goes on without it. */
  protected keep(record: PageRecord, page: HTMLElement): Promise<void> {
    return this.sent(page, (wait) => this.store.keep(record, wait));
  }

  /** What comes of sending something; where nothing more is accepted, it says why and does not return. `busy` is said
      while a server waits for others. */
  protected async sent<Answer>(
    page: HTMLElement, send: (wait: Wait) => Promise<Answer>, busy?: string): Promise<Answer> {
    try {
      return await send(waitNote(page, this.texts, busy));
    } catch (error) {
      if (error instanceof Declined) throw error;
      showClosed(error, this.texts);
      return forever();
    } finally {
      page.querySelector(":scope > .waiting")?.remove();
    }
  }

  private keeping(name: string, asked: Omit<Page, "keep">): Promise<number> {
    return this.page({ ...asked,
      keep: (given, page) => this.keep(pageRecord(name, this.store.name, given), page) });
  }

  private async consent(): Promise<void> {
    const { experiment, texts } = this;
    const { consent } = experiment.texts;
    await this.page({ title: experiment.title || texts.welcome, texts: consent,
      buttons: consent.length ? [texts.agree, texts.refuse] : [texts.next],
      keep: (given, page) => this.keepConsent(given, page) });
  }

  private async keepConsent(given: GivenOnPage, page: HTMLElement): Promise<void> {
    const { experiment, store, texts } = this;
    const { mode, ends } = this.parts;
    const agreed = given.pressed === 0;
    const responses = [{ item: "consent", value_raw: agreed ? "agreed" : "refused", rt_ms: 0 }];
    if (agreed || mode === "served")
      await this.keep({ ...pageRecord("consent", store.name, { ...given, responses }),
        language: experiment.language }, page);
    if (agreed) return mayWithdraw(experiment, store, texts, {}, ends);
    if (mode === "served") store.clear?.();
    show(texts.thanks, [texts.refused]);
    await forever();
  }

  private async explain(): Promise<void> {
    const { experiment, texts } = this;
    const isResumed = this.store.session.trials.some(({ number }) => this.has(`trial-${number}`));
    await this.page({ title: texts.instructions, buttons: [texts.next],
      texts: [...(isResumed ? [texts.resumed] : []), ...experiment.texts.instructions, ...this.howTo(),
        ...(isTouched() ? [] : this.keys())] });
  }

  private async prepared(): Promise<LiveCore> {
    const { texts, words } = this;
    const note = element("p", { role: "status" });
    const bar = element("progress", { "aria-label": words.preparing });
    root().replaceChildren(element("article", { class: "page" }, heading(words.preparing), bar, note));
    for (;;) {
      try {
        return await coreOf(this.parts.mode);
      } catch (error) {
        console.error(error);
        note.textContent = `${words.notPrepared} ${error instanceof Error ? error.message : ""}`;
        await new Promise<void>((again) => {
          const more = button(texts.again, () => { more.remove(); again(); }, "main");
          note.after(more);
          more.focus();
        });
      }
    }
  }
}
