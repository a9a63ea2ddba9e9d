#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/matching/target_sampling.h"

namespace mien::pipeline {

/// Sampled targets and the parameters that they are defined by.
struct TargetSet {
  std::vector<std::string> parameters;
  bool are_features = false;  ///< the parameters are motion features, not rated scales
  std::vector<SampledTarget> targets;
  std::uint64_t seed = 0;  ///< seed of the sampling
};

/// A manifest with a matching experiment whose targets are synthesized from the examples of
/// `source`.
Manifest target_manifest(const Manifest& source, const TargetSet& set);

/// The manifest as YAML text, complete and ready to run. Paths are relative to `folder`, to which
/// it will be written.
std::string target_manifest_yaml(const Manifest& targets, const TargetSet& set,
                                 const std::filesystem::path& folder);

/// A row for each target and parameter.
WrittenTable targets_table(const TargetSet& set, const std::vector<std::string>& examples,
                           const std::string& ratings);

}  // namespace mien::pipeline
