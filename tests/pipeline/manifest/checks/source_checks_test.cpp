#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// Faults of a manifest in `folder` whose run writes to <folder>/out/s.
std::vector<Fault> faults_of(const fs::path& folder, const std::string& rest) {
  const ManifestReading reading =
      parse_manifest("mien: 1\nstudy: s\n" + rest, folder / "m.yaml", process_environment());
  EXPECT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
  return check_sources(reading.manifest, folder / "out" / "s");
}

TEST(Sources, MayNotLieWhereTheRunWrites) {
  const test::TemporaryFolder scratch;
  const fs::path& folder = scratch.path();
  for (const char* place : {"out/s/clips", "out/other/clips", "out/s2"})
    fs::create_directories(folder / place);
  for (const char* file : {"out/s/clips/a.bvh", "out/other/clips/a.bvh", "out/s2/a.bvh"})
    write_file(folder / file, "");
  fs::create_directory_symlink(folder / "out" / "s", folder / "elsewhere");
  const auto of_clip = [&](const std::string& clip) {
    return faults_of(folder, "stimuli: [{id: a, clip: " + clip + "}]\n");
  };
  ASSERT_EQ(of_clip("out/s/clips/a.bvh").size(), 1u);
  const Fault fault = of_clip("elsewhere/clips/a.bvh").at(0);
  EXPECT_EQ(fault.path, "stimuli[0].clip");
  EXPECT_EQ(fault.place.line, 3);
  EXPECT_EQ(fault.wrong, (folder / "elsewhere/clips/a.bvh").string() +
                             " is in the folder of this study's results");
  EXPECT_EQ(of_clip("{file: out/s/../s/clips/a.bvh}").at(0).path, "stimuli[0].clip.file");
  EXPECT_TRUE(of_clip("out/other/clips/a.bvh").empty());
  EXPECT_TRUE(of_clip("out/s2/a.bvh").empty());
  EXPECT_EQ(faults_of(folder,
                      "examples: {set: {folder: out/s/clips}}\nstimuli: [{id: a, weights: "
                      "{a: 1}}]\n")
                .at(0)
                .path,
            "examples.set.folder");
}

}  // namespace
}  // namespace mien::pipeline
