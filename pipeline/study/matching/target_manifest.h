#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/study/matching/target_sampling.h"

namespace mien::pipeline {

/// Targets, the parameters that they are places of, and whether those are motion features.
struct TargetSet {
  std::vector<std::string> parameters;
  bool are_features = false;
  std::vector<SampledTarget> targets;
  std::uint64_t seed = 0;  ///< that they were sampled with
};

/// A manifest that makes the targets' motions from the examples of `source`, and a matching
/// experiment of them.
Manifest target_manifest(const Manifest& source, const TargetSet& set);

/// The same as text: complete, so that it runs, and fit to be pasted from. Paths are relative to
/// `folder`, where it is to be written.
std::string target_manifest_yaml(const Manifest& targets, const TargetSet& set,
                                 const std::filesystem::path& folder);

/// A row for each target and parameter.
WrittenTable targets_table(const TargetSet& set, const std::vector<std::string>& examples,
                           const std::string& ratings);

}  // namespace mien::pipeline
