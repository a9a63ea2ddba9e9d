import type { LiveCore } from "../live/core";
import { attemptAt } from "../live_study/begun";
import { placeOf } from "../live_study/experiment";
import { LiveSession } from "../live_study/live_session";
import { runLiveStudy } from "../live_study/live_study";
import { showEarlyEnd } from "../questionnaire/session_page";
import { Declined, post } from "../questionnaire/store";
import { base, root } from "../questionnaire/surroundings";
import { checkedChains, type ChainExperiment, type ChainSession, type ChainTrial } from "./experiment";
import { OwnAnswers } from "./own_answers";
import { stepsCsv } from "./rows";
import { plannedStep, recordOf, type Step } from "./steps";
import { chainTexts, type ChainTexts } from "./texts";
import { TrialPage } from "./trial_page";

/** The pages of a session, one after the other. */
class Session extends LiveSession<ChainSession, ChainExperiment> {
  private chainWords: ChainTexts = chainTexts(
    this.experiment.language, this.experiment.page_texts?.[this.experiment.language]);
  private answers = new OwnAnswers(this.experiment, this.store, this.parts.mode === "served");

  protected howTo(): string[] {
    const { chainWords, texts } = this;
    return this.experiment.chains.method === "gibbs" ? [...chainWords.how, texts.turnKeys] : chainWords.howChoices;
  }

  protected override keys(): string[] {
    return [...super.keys(), ...(this.experiment.chains.method === "mcmc" ? [this.chainWords.choiceKeys] : [])];
  }

  protected async trials(core: LiveCore): Promise<string[]> {
    const { experiment, store, texts, words, chainWords } = this;
    const page = new TrialPage({ chains: experiment.chains, core, texts, words, chainWords });
    const left = store.session.trials.filter(({ number }) => !this.has(`trial-${number}`));
    try {
      for (const [index, trial] of left.entries()) {
        await this.between(trial, left[index - 1]);
        await this.trial(page, trial);
        if (store.ended?.() === "failed_attention") return await this.endInattentive();
      }
      return [];
    } catch (error) {
      if (!(error instanceof Declined) || error.why !== "finished") throw error;
      await this.leaveOut(page.element);
      return [chainWords.finishedEarly];
    } finally {
      page.release();
    }
  }

  /** Shows a trial until an answer to it is kept: where somebody else was faster, another step. */
  private async trial(page: TrialPage, trial: ChainTrial): Promise<void> {
    const { experiment, store, words, chainWords } = this;
    let said: string | undefined;
    for (;;) {
      const attempt = attemptAt(experiment, store.name, trial.number);
      const step = await this.stepOf(trial);
      const { answer, measures } = await page.run(step, this.progressAt(trial),
        said ?? (attempt > 1 ? words.begunAnew : ""));
      const record = { record: `trial-${trial.number}`, session: store.name, responses: [], comment: "", ...measures,
        chain: recordOf(step, answer, attempt) };
      this.answers.write(record);
      try {
        return await this.keep(record, page.element);
      } catch (error) {
        if (!(error instanceof Declined) || error.why !== "taken") throw error;
        said = chainWords.taken;
      }
    }
  }

  /** From the plan or, where chains run across participants, from the server. */
  private async stepOf(trial: ChainTrial): Promise<Step> {
    const { experiment, store } = this;
    if (trial.practice || trial.expected || !experiment.chains.across_participants)
      return plannedStep(experiment.chains, store.session, trial, this.answers.all());
    if (this.parts.mode !== "served")
      throw new Error("The chains of this experiment run across participants, which needs a server: mien study serve.");
    const shown = root().querySelector("article") ?? root();
    return this.sent(shown, (wait) => post<Step>(`${base()}step/trial-${trial.number}`, { session: store.name }, wait),
      this.chainWords.othersAnswer);
  }

  /** The server takes nothing more from whoever failed too many attention checks. */
  private endInattentive(): Promise<never> {
    showEarlyEnd(this.texts, [this.texts.failedAttention], { parameters: {}, destination: undefined });
    return new Promise<never>(() => {});
  }

  /** All chains are complete: trials that are left have no step. */
  private async leaveOut(page: HTMLElement): Promise<void> {
    for (const { number } of this.store.session.trials) {
      const record = `trial-${number}`;
      if (!this.has(record))
        await this.keep({ record, session: this.store.name, responses: [], comment: "",
          started_at: new Date().toISOString() }, page);
    }
  }

  private progressAt(trial: ChainTrial): string {
    const place = placeOf(this.store.session, trial);
    return trial.practice ? this.words.practiceOf(place) : this.texts.trialOf(place);
  }

  /** That practice begins or is over, and a rest between blocks. */
  private async between(trial: ChainTrial, before: ChainTrial | undefined): Promise<void> {
    const { texts, words, store } = this;
    const buttons = [texts.next];
    if (trial.practice && !before?.practice)
      await this.page({ title: texts.practice, texts: [texts.practiceBegins], buttons });
    if (!trial.practice && before?.practice)
      await this.page({ title: this.experiment.title, texts: [texts.mainBegins], buttons });
    if (!trial.practice && before && !before.practice && before.block !== trial.block) {
      const { number, all } = placeOf(store.session, trial);
      await this.page({ title: words.rest, texts: [words.restText({ done: number - 1, all })], buttons });
    }
  }
}

runLiveStudy<ChainSession, ChainExperiment>({
  format: "mien-chains-session-1",
  checked: checkedChains,
  tables: (experiment, session, records) => ({ steps: stepsCsv(experiment, session, records) }),
  session: (parts) => new Session(parts),
});
