// The columns of the tables that pages write. Made from the tables that C++ declares: a test
// (declared_tables_test.cpp) prints this file as it must be where it is not.

export const answerColumns = [
  "participant", "session", "trial", "block", "kind", "stimulus",
  "stimulus_sha256", "against", "level", "track", "item", "value_raw",
  "value", "pole_left", "rt_ms", "is_practice", "is_warmup", "is_check",
  "expected", "passed", "replays", "attempt", "plays_before", "watched_before_ms",
  "play_fault", "trial_ms", "play_start_ms", "ended_ms", "stalls", "stall_ms",
  "dropped_frames", "volume_events", "blurs", "blur_ms", "viewport_width", "viewport_height",
  "refresh_hz", "shown_width", "shown_height", "pixel_ratio", "shown_cm", "shown_degrees",
  "viewing_cm", "comment", "seed", "design", "simulated",
] as const;

export const participantColumns = [
  "participant", "session", "design", "consented_at", "finished", "ended",
  "screening_fault", "language", "consent_version", "consent_sha256", "closing_comment",
] as const;

export const trialColumns = [
  "participant", "target", "interface", "first_guess_d", "time_s", "success",
  "simulated", "trial", "d", "guess_s", "attempt", "session",
  "design", "limit_s", "threshold_m",
] as const;

export const changeColumns = [
  "participant", "trial", "target", "interface", "is_practice", "attempt",
  "time_s", "step", "action", "slider", "value", "d",
  "simulated",
] as const;

export const stepColumns = [
  "participant", "session", "design", "simulated", "trial", "is_practice",
  "is_check", "passed", "attempt", "word", "chain", "step",
  "person", "point", "dimension", "value", "slider_start", "is_reversed",
  "proposal", "is_proposal_first", "chose_proposal", "moves", "trial_ms", "started_at",
] as const;
