#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace mien::test {

inline constexpr char no_browser_core[] =
    "no motion core for browsers here: ./mien test makes it where em++ is installed";

/// An experiment with live motions that is served or was exported, and people who take it in
/// Chromium.
class LivePage : public testing::Test {
 protected:
  /// `kind`: the folder of its scenarios, "matching" or "chains"; `manifest`: of the study.
  LivePage(std::string kind, std::string manifest)
      : kind_(std::move(kind)), manifest_(std::move(manifest)) {}

  void SetUp() override;

  std::filesystem::path study() const { return scratch.path() / "study.yaml"; }
  std::filesystem::path folder() const { return scratch.path() / "experiment"; }
  std::filesystem::path store() const { return scratch.path() / "kept.db"; }

  /// Exports the study, unless what exports need is missing.
  bool is_exported() const;

  /// Serves the study, and keeps what comes in store().
  Running serve() const;
  /// The same at this port, which a server that was killed had; 0: a free one.
  std::unique_ptr<Running> serving(const std::string& port) const;
  /// The link of a participant, from 0, of a server that is starting.
  std::string link_of(int participant) const;

  /// What a scenario tells, in which the browser complained of nothing.
  nlohmann::json played(const std::string& scenario, const std::string& where) const;
  /// The words that run a script of the kind with these arguments; without any, as tests of
  /// Node.js.
  std::vector<std::string> script_words(const std::string& script,
                                        const std::vector<std::string>& arguments) const;
  nlohmann::json played(const std::string& scenario) const {
    return played(scenario, folder().string());
  }
  /// Runs script_words().
  Ended run_script(const std::string& script, const std::vector<std::string>& arguments) const;

  Scratch scratch;

 private:
  std::vector<std::string> serve_words(const std::string& port) const;

  std::string kind_, manifest_;
};

}  // namespace mien::test
