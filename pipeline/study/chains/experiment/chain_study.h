#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "motion/live/live_bundle.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/archive/zip_archive.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/study/chains/chain_plan.h"
#include "pipeline/study/questionnaire/service/served_study.h"

namespace mien::pipeline {

/// Where the dimensions of an adaptive experiment come from.
struct ChainDimensions {
  motion::InterfaceKind kind = motion::InterfaceKind::adjectives;  ///< sliders of the live core
  std::vector<std::string> names;
  /// Values at the examples, one row per dimension; empty for weights and modifications.
  Eigen::MatrixXd at_examples;
};

/// An adaptive experiment, ready to be served, exported or simulated.
struct ChainStudy {
  nlohmann::ordered_json experiment;  ///< experiment.json (page/src/chains/experiment.ts)
  ChainDimensions dimensions;
  ChainDesign design;
  std::vector<ChainSession> sessions;
  motion::LiveBundle bundle;

  std::vector<SessionPlan> plans() const;
};

/// Plans the sessions of `participants` participants (0: the number in the manifest). Throws Error
/// if a dimension has no ratings or the same value for all examples, if the examples cannot be
/// blended, or if motions cannot be made from so many dimensions.
ChainStudy chain_study(const Manifest& manifest, Motions& motions, int participants = 0);

/// The scores of the first `count` principal components of the examples' standardised motion
/// features, one row per component, each scaled linearly to 0…1 over the examples. The sign of each
/// is such that its largest loading (in absolute value) is positive. Throws Error if the features
/// vary in fewer directions.
Eigen::MatrixXd component_scores(const Eigen::MatrixXd& features, int count);

/// The study as a server serves it, with the pages in the folder `pages` (page_bundle("chains")).
ServedStudy served_chains(ChainStudy study, const std::filesystem::path& pages);

/// An experiment that runs without a server, with the files of exported_live
/// (questionnaire/experiment/live_export.h). `pages` is the folder of the built page, `module` the
/// live core (live_module()). Throws Error if chains go across participants. The same study results
/// in the same bytes.
ZipFiles exported_chains(const Manifest& manifest, const ChainStudy& study,
                         const std::filesystem::path& pages, const std::filesystem::path& module);

}  // namespace mien::pipeline
