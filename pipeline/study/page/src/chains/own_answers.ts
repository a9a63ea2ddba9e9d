import type { PageRecord } from "../questionnaire/experiment";
import { Drawer, type Store } from "../questionnaire/store";
import type { ChainSession } from "./experiment";

type Answers = Record<string, Pick<PageRecord, "chain">>;

/** The answers from which a participant's own chains follow. A server does not send records back: what was sent to one
    is also kept in this browser, where it outlives a reload. */
export class OwnAnswers {
  private drawer: Drawer;

  constructor({ design }: { design: string }, private store: Store<ChainSession>, private isServed: boolean) {
    this.drawer = new Drawer(`mien/${design}/${store.name}/chains`);
  }

  /** Those that are kept, by the names of their records. */
  all(): Answers {
    if (!this.isServed) return this.store.records;
    const written = this.drawer.read<Answers>() ?? {};
    return Object.fromEntries(Object.entries(written).filter(([name]) => this.store.kept.has(name)));
  }

  /** Before it is sent: the window may be closed before the server says that it has it. */
  write({ record, chain }: PageRecord): void {
    if (this.isServed) this.drawer.write({ ...(this.drawer.read<Answers>() ?? {}), [record]: { chain } });
  }
}
