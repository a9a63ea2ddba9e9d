#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/reading/levelled_document.h"
#include "pipeline/production/run/random_manifest.h"
#include "pipeline/production/run/rehearsal.h"
#include "pipeline/production/run/run.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::vector<Fault> faults_of(const json& document, const fs::path& file) {
  std::ofstream(file) << document.dump(1);
  const ManifestReading reading = check_manifest(file, process_environment(), "out");
  if (!reading.faults.empty()) return reading.faults;
  return with_written_paths(rehearse(reading.manifest), reading.manifest.origins);
}

/// The manifest of a seed, written to `file` without the options that its check refuses; false when
/// the check refuses what cannot be left out.
bool write_valid(std::uint64_t seed, const fs::path& file) {
  constexpr int most_rounds = 40;
  json document = test::random_manifest(seed);
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<Fault> faults = faults_of(document, file);
    if (faults.empty()) return true;
    std::vector<std::string> paths;
    for (const Fault& fault : faults) {
      EXPECT_NE(fault.wrong, "") << document.dump(1);
      paths.push_back(fault.path);
    }
    const std::optional<json> fewer = test::without_options(std::move(document), paths);
    if (!fewer) return false;
    document = *fewer;
  }
  return false;
}

std::string failures_of(const fs::path& manifest, const fs::path& folder) {
  Production production(load_manifest(manifest, process_environment()), {});
  const RunResult result = run(production, folder, 1, {}, {});
  std::string failures;
  for (const TaskOutcome& outcome : result.outcomes) {
    if (!outcome.error.empty()) failures += outcome.error + "\n";
  }
  for (const Nondeterminism& met : result.nondeterminism) failures += met.path + " differs\n";
  return failures;
}

/// Seeds whose manifests once passed the check and failed in the run.
const std::vector<std::uint64_t> kept_seeds = {138};  // a GIF's last frame was too long

/// With MIEN_RANDOM_MANIFESTS=300 so many, else a few: making studies takes its time.
std::vector<std::uint64_t> seeds() {
  const char* count = std::getenv("MIEN_RANDOM_MANIFESTS");
  std::vector<std::uint64_t> seeds = kept_seeds;
  for (int seed = 0; seed < (count != nullptr ? std::atoi(count) : 14); ++seed)
    seeds.push_back(static_cast<std::uint64_t>(seed));
  return seeds;
}

TEST(RandomManifests, ThatPassTheCheckAreMade) {
  const test::TemporaryFolder files;
  test::write_random_files(files.path());
  const fs::path manifest = files.path() / "m.yaml";
  std::size_t made = 0;
  for (const std::uint64_t seed : seeds()) {
    if (!write_valid(seed, manifest)) continue;
    const test::TemporaryFolder store;
    EXPECT_EQ(failures_of(manifest, store.path()), "") << "seed " << seed << ":\n"
                                                       << std::ifstream(manifest).rdbuf();
    ++made;
  }
  EXPECT_GT(3 * made, seeds().size());
}

}  // namespace
}  // namespace mien::pipeline
