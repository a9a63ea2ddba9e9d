#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace mien::test {

inline constexpr const char* tiny_study = R"(mien: 1
study: tiny
seed: 3
examples: {set: "builtin:walks-10", ratings: builtin}
output: {size: [64, 36], fps: 10, cycles: 1, quality: draft, frames: png, video: [mp4]}
stimuli:
  - {id: one, weights: {normal: 1}}
  - {id: two, weights: {sad: 1}}
sheets:
  - compare: {target: one, created: two}
)";

/// The commands of a farm over a study of two short films.
class Farm : public testing::Test {
 protected:
  Scratch scratch;
  std::filesystem::path manifest = scratch.write("tiny.yaml", tiny_study);
  /// A name with special characters, which scripts must quote.
  std::filesystem::path out = scratch.path() / "it's 100% of $HOME";

  Ended farm(std::vector<std::string> words, const std::vector<std::string>& more = {}) const {
    words.insert(words.begin(), "farm");
    words.insert(words.begin() + 2, {manifest.string(), "--out", out.string()});
    words.insert(words.end(), more.begin(), more.end());
    return run_mien(words);
  }

  nlohmann::json status() const {
    const Ended ended = farm({"status"}, {"--json"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    return nlohmann::json::parse(ended.output);
  }
};

}  // namespace mien::test
