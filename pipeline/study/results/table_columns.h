#pragma once

#include "pipeline/base/documents/table.h"

namespace mien::pipeline {

// The forms of the tables of results, which their codebook is made of. Paths are relative to the
// folder of the report.

extern const TableForm means_form;
extern const TableForm histograms_form;
extern const TableForm comparisons_form;
extern const TableForm overall_form;
extern const TableForm groups_form;
extern const TableForm confusion_form;
extern const TableForm recall_form;
extern const TableForm correlations_form;
extern const TableForm agreement_form;
extern const TableForm preferences_form;
extern const TableForm people_form;
extern const TableForm catch_form;
extern const TableForm catch_summary_form;
extern const TableForm demographics_form;
extern const TableForm comments_form;
extern const TableForm words_form;
extern const TableForm word_counts_form;

}  // namespace mien::pipeline
