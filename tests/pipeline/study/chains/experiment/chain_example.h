#pragma once

#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/chains/experiment/chain_study.h"

namespace mien::pipeline {

inline ManifestReading chain_reading(const std::string& adaptive) {
  return parse_manifest(
      "mien: 1\nstudy: words\nseed: 3\nexamples: {set: builtin:walks-10, ratings: builtin}\n"
      "output: {fps: 30}\nadaptive: " +
          adaptive + "\n",
      "/nowhere/words.yaml", [](const std::string&) { return std::nullopt; });
}

inline std::string chain_fault(const std::string& adaptive) {
  const ManifestReading read = chain_reading(adaptive);
  return read.faults.empty() ? std::string() : std::string(Faults(read.faults).what());
}

inline Manifest chain_manifest(const std::string& adaptive) {
  ManifestReading read = chain_reading(adaptive);
  EXPECT_TRUE(read.faults.empty()) << Faults(read.faults).what();
  return std::move(read.manifest);
}

/// An experiment with its motions.
struct ChainExample {
  explicit ChainExample(const std::string& adaptive)
      : manifest(chain_manifest(adaptive)),
        motions(manifest),
        study(chain_study(manifest, motions)) {}

  Manifest manifest;
  Motions motions;
  ChainStudy study;
};

inline constexpr char own_chains[] =
    "{participants: 4, method: gibbs, words: [sad, happy], space: {groups: all}, iterations: 4}";
inline constexpr char own_choices[] =
    "{participants: 3, method: mcmc, words: [sad], space: {groups: [quickness, largeness]}, "
    "iterations: 30}";
inline constexpr char shared_chains[] =
    "{participants: 6, method: gibbs, words: [sad, happy], space: {groups: [quickness, "
    "largeness]}, chains: 2, iterations: 3, across_participants: true, people_per_step: 3, "
    "trials_per_participant: 40, practice: 1}";

inline constexpr char chains_until[] =
    "{participants: 30, method: gibbs, words: [sad, happy], space: {groups: [quickness, "
    "largeness]}, chains: 4, until: {r_hat: 1.1, at_least: 6, at_most: 40}, across_participants: "
    "true, trials_per_participant: 40, practice: 0}";
inline constexpr char checked_chains[] =
    "{participants: 4, method: gibbs, words: [sad, happy], space: {groups: all}, iterations: 4, "
    "attention: {every: 6}, practice: 1}";

}  // namespace mien::pipeline
