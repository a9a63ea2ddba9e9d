#pragma once

#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// One of a study's tables of numbers, tidy CSV.
struct StudyTable {
  TableForm form;
  std::string (*csv)(const Manifest& manifest, Motions& motions);
};

/// `rows_of(manifest, motions)` are the table's rows.
template <const auto& table, auto rows_of>
inline constexpr StudyTable study_table = {table.form(),
                                           [](const Manifest& manifest, Motions& motions) {
                                             return table.of(rows_of(manifest, motions)).csv;
                                           }};

extern const StudyTable distances_table;
extern const StudyTable joint_distances_table;
extern const StudyTable feature_changes_table;
extern const StudyTable weights_table;
extern const StudyTable clips_table;
extern const StudyTable parameters_table;
extern const StudyTable findings_table;
extern const StudyTable foils_table;  ///< the certificate of every foil

/// Without rows where nothing is made with examples.
extern const StudyTable examples_table;

/// Without rows where nothing is blended or nothing was rated.
extern const StudyTable impressions_table;

/// The manipulation checks (expectation.h).
extern const StudyTable expectations_table;

/// "whose ratings the motion rests on", of an `r.ratings`.
inline constexpr SharedColumn ratings_column = {
    "ratings", "",
    "ratings on which the motion is based: given (by people), simulated or none (features, "
    "weights, files)",
    [](auto& r) { return r.ratings; }};

}  // namespace mien::pipeline
