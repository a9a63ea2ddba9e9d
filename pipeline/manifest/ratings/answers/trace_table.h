#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"

namespace mien::pipeline {

/// The table of traces: a row for each sample of each answered continuous trial.
extern const TableForm traces_form;

/// The trace of an answer to a continuous trial, 0 to 100 from the low to the high end of the
/// scale. Nullopt for other answers, and for raw answers that are no traces.
std::optional<std::vector<double>> trace_of(const AnswerRow& row);

/// Whether any of the answers is to a continuous trial, answered or not.
bool has_traces(const std::vector<AnswerRow>& rows);

/// CSV of the traces of these answers, in their order, practice included; their other columns are
/// those of the answers of the same participant, session and trial. The last sample of a film has
/// the time of its end, if `film_seconds` has the duration of that stimulus.
std::string traces_csv(const std::vector<AnswerRow>& rows,
                       const std::map<std::string, double>& film_seconds);

}  // namespace mien::pipeline
