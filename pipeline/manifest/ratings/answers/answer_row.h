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

/// One answer of a questionnaire as it was given: what the page, the server, the simulation and the
/// report all write and read. Numbers that nobody measured are empty.
struct AnswerRow {
  std::string participant;
  std::string session;          ///< of the browser
  int trial = 0;                ///< from 1
  std::string block;            ///< "practice", "main", or a level of the blocking factor
  std::string kind = "rating";  ///< of the trial: answer_kinds (trial_form.h)
  std::string stimulus;         ///< empty for an attention check without one
  std::string stimulus_sha256;  ///< of the media that was shown
  std::string against;          ///< the reference beside, or the other one of a pair
  std::string item;             ///< id of the scale, or the own item of the form (TrialForm)
  std::string value_raw;        ///< place from the left, chosen word, "left" or "right"
  std::string value;            ///< in the scale's own range, high pole = most; or what was chosen
  std::string pole_left;        ///< "low" or "high"; empty for what has no poles
  std::optional<double> rt_ms;  ///< from when an answer could be given
  bool is_practice = false;
  bool is_warmup = false;
  bool is_catch = false;  ///< attention checks and repeated stimuli
  std::string expected;   ///< the raw answer that passes a check
  std::optional<bool> passed;
  std::optional<int> replays;
  std::optional<double> trial_ms;
  std::optional<double> play_start_ms;
  std::optional<double> ended_ms;
  std::optional<int> stalls;
  std::optional<double> stall_ms;
  std::optional<int> dropped_frames;
  std::optional<int> blurs;
  std::optional<int> viewport_width;
  std::optional<int> viewport_height;
  std::optional<double> refresh_hz;
  std::string comment;  ///< on the first row of a trial alone
  std::uint64_t seed = 0;
  std::string design;  ///< hash of the questionnaire
  bool simulated = false;
  Place place;  ///< of the row's value where it was read; not written

  /// Whether it counts as an answer: no practice, no warm-up, no check, and not left empty.
  bool counts() const;
};

/// The columns in their order, as described in codebooks.
extern const TableForm answer_form;

/// Whether a table holds rows of this form: it has columns that no other table of answers has.
bool holds_answer_rows(const CsvTable& table);

/// The rows as CSV, in the order given.
std::string to_csv(const std::vector<AnswerRow>& rows);

/// The fields of one row as the CSV has them.
std::vector<std::string> fields_of_row(const AnswerRow& row);

enum class DuplicateAnswers { refused, allowed };

/// Reads what to_csv writes; columns in any order, further ones are ignored.
///
/// Throws Faults with every fault at once, at file:line:column: columns that are missing, no rows,
/// an empty participant or item, a kind, pole or truth value that is none, numbers that are none,
/// negative or not whole where they must be, and an answer that is there twice (participant,
/// session, trial, stimulus and item).
std::vector<AnswerRow> answer_rows(const CsvTable& table,
                                   DuplicateAnswers duplicates = DuplicateAnswers::refused);

/// A fault for every answer that occurs twice.
std::vector<Fault> duplicate_answer_faults(const std::vector<AnswerRow>& rows);

/// Separates people who share a participant id: without a server, two browsers may have been given
/// the same plan. Where several sessions of a participant answer the same trial, `participant`
/// becomes "p003/<session>"; sessions that continue each other are one person. Returns a sentence
/// for each id that was split.
std::vector<std::string> separate_participants(std::vector<AnswerRow>& rows);

}  // namespace mien::pipeline
