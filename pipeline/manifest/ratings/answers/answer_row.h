#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/error.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

/// One answer of a questionnaire: the row shared by the page, the server, the simulation and the
/// report. Numbers that were not measured are empty.
struct AnswerRow {
  std::string participant;
  std::string session;          ///< id of the browser session
  int trial = 0;                ///< counted from 1
  std::string block;            ///< "practice", "main", or a level of the blocking factor
  std::string kind = "rating";  ///< kind of trial (answer_kinds in trial_form.h)
  std::string stimulus;         ///< empty for an attention check without one
  std::string stimulus_sha256;  ///< SHA-256 of the file that was shown
  std::string against;          ///< the reference, or the other stimulus of a pair
  std::string level;         ///< of the factor of adaptive trials that was shown; empty in others
  std::optional<int> track;  ///< of adaptive trials, from 1; empty without the signal
  std::string item;          ///< id of the scale, or the form's own item (TrialForm)
  std::string value_raw;  ///< position from the left, chosen or written words, or a side ("left")
  /// Value in the scale's range, where the maximum is the high pole; or the choice.
  std::string value;
  std::string pole_left;  ///< "low" or "high"; empty for items without poles
  /// Response time in milliseconds, from the moment at which an answer was possible.
  std::optional<double> rt_ms;
  bool is_practice = false;
  bool is_warmup = false;
  bool is_check = false;  ///< attention checks and repeated stimuli
  std::string expected;   ///< raw answer that passes an attention check
  std::optional<bool> passed;
  std::optional<int> replays;
  std::optional<int> attempt;  ///< how often the trial's page was opened: 1 unless it was reloaded
  std::optional<int> plays_before;          ///< playings that began before the last reload
  std::optional<double> watched_before_ms;  ///< length of the longest of these
  std::string play_fault;  ///< why the stimulus could not be played: the trial has no answers
  std::optional<double> trial_ms;
  std::optional<double> play_start_ms;
  std::optional<double> ended_ms;
  std::optional<int> stalls;
  std::optional<double> stall_ms;
  std::optional<int> dropped_frames;
  /// Changes of the volume of what is heard: "1530:0.5 2210:0", times in milliseconds.
  std::string volume_events;
  std::optional<int> blurs;
  std::optional<double> blur_ms;
  std::optional<int> viewport_width;
  std::optional<int> viewport_height;
  std::optional<double> refresh_hz;
  std::optional<double> shown_width;    ///< of each stimulus on the screen, CSS pixels
  std::optional<double> shown_height;   ///< CSS pixels
  std::optional<double> pixel_ratio;    ///< device pixels per CSS pixel
  std::optional<double> shown_cm;       ///< width on a calibrated screen, centimetres
  std::optional<double> shown_degrees;  ///< width as visual angle at the viewing distance
  std::optional<double> viewing_cm;     ///< viewing distance measured with the blind spot
  std::string comment;                  ///< only in the first row of a trial
  std::uint64_t seed = 0;
  std::string design;  ///< hash of the questionnaire
  bool simulated = false;
  /// Values of the kept URL parameters of the participant's link; written, but not read.
  std::vector<std::string> url_parameters;
  Place place;  ///< position of the value in the source file; not written

  /// Whether the row is analysed: its value is neither empty nor "NA", and it is not part of
  /// practice, warm-up, an attention check or a repeated stimulus.
  bool counts() const;
};

/// The columns in order, as described in codebooks.
extern const TableForm answer_form;

/// Whether a table has the columns that distinguish this form from all other tables of answers.
bool holds_answer_rows(const CsvTable& table);

/// The column of a URL parameter of the participant's link, in tables of answers and participants:
/// "url_PROLIFIC_PID". No question has such a name.
std::string parameter_column(const std::string& parameter);
/// Whether a column is one of those, or has an id of JATOS ("jatos_worker"): it may identify a
/// participant, and is no answer.
bool is_parameter_column(std::string_view column);

/// Returns the rows as CSV, in the given order, with a column for each of the URL parameters, of
/// which each row has a value.
std::string to_csv(const std::vector<AnswerRow>& rows,
                   const std::vector<std::string>& url_parameters = {});

/// Returns the fields of one row in the order of the CSV columns.
std::vector<std::string> fields_of_row(const AnswerRow& row);

enum class DuplicateAnswers { refused, allowed };

/// Reads the output of to_csv, also of earlier versions, in which `is_check` was called `is_catch`
/// and there were no `blur_ms`, `volume_events`, attempts, levels and sizes of stimuli. In the
/// first case, a warning is added to `warnings` unless it is null. Columns may be in any order;
/// unknown columns are ignored.
///
/// Throws Faults, at file:line:column: first for missing columns or no rows, then with all faults
/// of the rows at once: an empty participant or trial, an empty stimulus or item (except in
/// attention checks), an invalid kind, pole or boolean, numbers that are malformed, negative or
/// fractional where this is not allowed, and duplicate answers (same participant, session, trial,
/// stimulus and item).
std::vector<AnswerRow> answer_rows(CsvTable table,
                                   DuplicateAnswers duplicates = DuplicateAnswers::refused,
                                   std::vector<Fault>* warnings = nullptr);

/// Returns a fault for each duplicate answer.
std::vector<Fault> duplicate_answer_faults(const std::vector<AnswerRow>& rows);

/// Separates participants who share an id: without a server, two browsers may have received the
/// same plan. If several sessions of one participant id answer the same trial, `participant`
/// becomes "p003/<session>" in all rows with that id; sessions that only continue each other remain
/// one participant. Returns a sentence for each id that was split.
std::vector<std::string> separate_participants(std::vector<AnswerRow>& rows);

}  // namespace mien::pipeline
