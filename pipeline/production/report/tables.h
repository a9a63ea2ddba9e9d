#pragma once

#include <string>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

// The study's numbers as tidy CSV; table_forms.h and impression_table.h have their columns.

std::string distances_csv(const Manifest& manifest, Motions& motions);
std::string joint_distances_csv(const Manifest& manifest, Motions& motions);
std::string weights_csv(const Manifest& manifest, Motions& motions);
std::string clips_csv(const Manifest& manifest, Motions& motions);
std::string parameters_csv(const Manifest& manifest, Motions& motions);

/// Without rows where nothing is blended or nothing was rated.
std::string impressions_csv(const Manifest& manifest, Motions& motions);

/// Without rows where nothing is made with examples.
std::string examples_csv(const Manifest& manifest, Motions& motions);

/// The manipulation checks (expectation.h).
std::string expectations_csv(const Manifest& manifest, Motions& motions);

std::string findings_csv(const Manifest& manifest, Motions& motions);
std::string feature_changes_csv(const Manifest& manifest, Motions& motions);

}  // namespace mien::pipeline
