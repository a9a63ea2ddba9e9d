#pragma once

#include <map>
#include <string>
#include <utility>

#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/hash.h"

namespace mien::test {

/// The key and the hash of each artifact of a study, by its path.
using KeyedArtifacts = std::map<std::string, std::pair<pipeline::Hash, pipeline::Hash>>;

/// Makes a study in a temporary folder.
KeyedArtifacts made_artifacts(const pipeline::Manifest& manifest);

/// Fails for each artifact that both studies make for the same key, but with other bytes: the
/// second study, made in the folder of the first, would keep it. `change` says how the studies
/// differ.
void expect_none_stale(const KeyedArtifacts& first, const KeyedArtifacts& second,
                       const std::string& change);

/// Which of many studies are made: those whose number, from 0, is `first` modulo `step`.
struct TriedPart {
  int first = 0;
  int step = 1;

  bool has(int number) const { return number % step == first; }
};

/// All with MIEN_ALL_OPTIONS=1, the second of four parts with MIEN_ALL_OPTIONS=2/4; without it, one
/// of `usual_step`.
TriedPart tried_part(int usual_step);

}  // namespace mien::test
