/** A study that is being served, as the server tells it (pipeline/study/questionnaire/service/lab_page.cpp). */
export interface LabStatus {
  study: string;
  title: string;
  design: string;
  is_matching: boolean;
  is_adaptive: boolean;
  /** Complete steps of chains across participants, and all of them; zeros without such chains. */
  steps: [number, number];
  has_traces: boolean;
  /** Why answers cannot be kept; empty where they can. */
  trouble: string;
  /** Whether deleted answers could not be overwritten yet, because the disk is full. */
  has_erased_log: boolean;
  planned: number;
  /** Link for whoever comes. */
  join: string;
  /** How many visitors of that link refused. */
  refused_at_join: number;
  participants: Participant[];
  checks: { passed: number; failed: number };
  histograms: Histogram[];
}

export interface Participant {
  participant: string;
  link: string;
  state: "waiting" | "opened" | "here" | "away" | "done" | "refused" | "screened_out" | "withdrawn" | "failed_attention";
  /** "join": by the open link; "link": by their own; empty before either. */
  came_by: "join" | "link" | "";
  kept: number;
  records: number;
  /** The record that comes next. */
  next: string;
  seen_seconds_ago: number | null;
}

export interface Histogram {
  item: string;
  is_pair: boolean;
  answers: number;
  mean: number | null;
  bins: { label: string; count: number }[];
  low?: string;
  high?: string;
}
