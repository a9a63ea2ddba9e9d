#pragma once

#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// A table of numbers about a study, as tidy CSV.
struct StudyTable {
  TableForm form;
  std::string (*csv)(const Manifest& manifest, Motions& motions);
};

/// A table whose rows are returned by `rows_of(manifest, motions)`.
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
extern const StudyTable foils_table;  ///< measured differences of all foils from their originals

/// People of stimuli with several; made only if there are any.
extern const StudyTable people_table;

/// Points of the recordings to which the body was fitted (fitted_recordings.h).
extern const StudyTable fits_table;

/// Without rows if the study does not use its examples.
extern const StudyTable examples_table;

/// Without rows unless examples are blended and were rated.
extern const StudyTable impressions_table;

/// The manipulation checks (expectation.h).
extern const StudyTable expectations_table;

/// The column of the ratings on which a motion is based, for rows with a member `ratings`.
inline constexpr SharedColumn ratings_column{
    "ratings", "",
    "ratings on which the motion is based: given (by people), simulated or none (features, "
    "weights, files, paths)",
    [](auto& r) { return r.ratings; }};

}  // namespace mien::pipeline
