// What never ends, never begins or is far too large in the place of a file that a user names: each
// is refused at once.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

/// Something bad in the place of a file, and what is said of it.
struct BadFile {
  std::string name;
  std::string told;
};

class EndlessInputs : public testing::Test {
 protected:
  /// A pipe that nobody writes to, a device and a sparse file, each with that ending.
  std::vector<BadFile> bad_files(const std::string& ending) const {
    const fs::path pipe = scratch.path() / ("pipe" + ending);
    const fs::path device = scratch.path() / ("device" + ending);
    const fs::path sparse = scratch.path() / ("sparse" + ending);
    if (!fs::exists(sparse)) {
      EXPECT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
      fs::create_symlink("/dev/zero", device);
      scratch.write("sparse" + ending, "");
      fs::resize_file(sparse, std::uintmax_t{1} << 40);
    }
    return {{pipe, "is a pipe, not a file"},
            {device, "is a device, not a file"},
            {sparse, "has 1 TiB, more than the "}};
  }

  /// Refused within seconds, with those words and that place.
  static void expect_refused(const std::vector<std::string>& arguments, const std::string& told,
                             const std::string& place = "") {
    const Ended ended = run_mien(arguments, 20.0);
    EXPECT_EQ(ended.code, 2) << arguments.front() << ": " << ended.errors;
    EXPECT_NE(ended.errors.find(told), std::string::npos) << told << "\n" << ended.errors;
    EXPECT_NE(ended.errors.find(place), std::string::npos) << place << "\n" << ended.errors;
    EXPECT_LT(ended.errors.size(), 1000u);
  }

  /// As the part of a manifest; both when it is checked and when it is run.
  void expect_refused_in(const std::string& text, const std::string& ending,
                         const std::string& place = ":") {
    for (const BadFile& bad : bad_files(ending)) {
      std::string manifest = "mien: 1\nstudy: s\n" + text;
      manifest.replace(manifest.find("BAD"), 3, bad.name);
      const std::string file = scratch.write("m.yaml", manifest);
      expect_refused({"check", file}, bad.told, place);
      expect_refused({"run", file, "--out", (scratch.path() / "out").string()}, bad.told, place);
    }
    EXPECT_FALSE(fs::exists(scratch.path() / "out"));
  }

  Scratch scratch;
};

constexpr char stimulus[] = "stimuli: [{id: a, weights: {normal: 1}}]\n";

TEST_F(EndlessInputs, AreNoManifests) {
  for (const char* ending : {".yaml", ".json", ""}) {
    for (const BadFile& bad : bad_files(ending)) {
      for (const char* command : {"check", "run", "plan"})
        expect_refused({command, bad.name}, bad.told);
    }
  }
}

TEST_F(EndlessInputs, AreNoScalesRecipesAnswersOrSets) {
  const std::string examples = "examples: {set: builtin:walks-10";
  expect_refused_in(examples + ", ratings: simulated, scales: BAD}\n" + stimulus, ".yaml",
                    "m.yaml:3:");
  expect_refused_in(examples + ", ratings: BAD}\n" + stimulus, ".csv", "m.yaml:3:");
  expect_refused_in(examples + "}\nrecipes: BAD\n" + stimulus, ".yaml");
  expect_refused_in(examples + "}\nlook: {scene: BAD}\n" + stimulus, ".yaml");
}

TEST_F(EndlessInputs, AreNoMotionsAndNoCharacters) {
  for (const char* ending : {".bvh", ".amc", ".glb", ".gltf"})
    expect_refused_in("stimuli: [{id: a, clip: BAD}]\n", ending, "m.yaml:3:");
  expect_refused_in(std::string("examples: {set: builtin:walks-10}\n"
                                "look: {figure: {character: BAD}}\n") +
                        stimulus,
                    ".glb", "m.yaml:4:");
  for (const BadFile& bad : bad_files(".bvh")) {
    expect_refused({"motion", "info", bad.name}, bad.told);
    expect_refused({"render", bad.name, "-o", (scratch.path() / "a.mp4").string()}, bad.told);
  }
}

TEST_F(EndlessInputs, AreNoAnswersOfAStudy) {
  for (const BadFile& bad : bad_files(".csv"))
    expect_refused({"study", "analyze", bad.name, "--examples", "builtin:walks-10"}, bad.told);
}

}  // namespace
}  // namespace mien::test
