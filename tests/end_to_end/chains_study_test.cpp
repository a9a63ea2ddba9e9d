#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

constexpr char words_text[] = R"(mien: 1
study: steering
seed: 7
examples: {set: builtin:walks-10, ratings: builtin}
output: {size: [64, 48], fps: 8, quality: draft, video: [mp4], frames: none}
adaptive:
  participants: 6
  method: gibbs
  words: [sad, happy]
  space: {groups: [quickness, largeness]}
  iterations: 4
)";

/// An adaptive experiment with answers of simulated people.
class SteeredWords : public testing::Test {
 protected:
  void SetUp() override {
    const Ended made = run_mien({"study", "simulate", manifest, "-o", steps});
    ASSERT_EQ(made.code, 0) << made.errors;
  }

  Ended chains(const std::string& where, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"study", "chains", manifest, steps, "-o", where};
    words.insert(words.end(), more.begin(), more.end());
    return run_mien(words);
  }

  const Scratch folder;
  const std::string manifest = folder.write("steering.yaml", words_text).string();
  const std::string steps = (folder.path() / "steps.csv").string();
  const std::string results = (folder.path() / "chains").string();
};

TEST_F(SteeredWords, BecomeFilmsAndAQuestionnaire) {
  const Ended analysed = chains(results);
  ASSERT_EQ(analysed.code, 0) << analysed.errors;
  EXPECT_EQ(analysed.output.find("simulated answers\n"), 0u) << analysed.output;
  for (const char* file :
       {"samples.csv", "prototypes.csv", "distances.csv", "codebook.csv", "chains.pdf",
        "prototypes.png", "words.ratings.csv", "words.scales.yaml", "prototypes.yaml"})
    EXPECT_TRUE(fs::exists(fs::path(results) / file)) << file;
  const std::string prototypes = results + "/prototypes.yaml";
  const std::string out = (folder.path() / "out").string();
  const Ended made = run_mien({"run", prototypes, "--out", out});
  ASSERT_EQ(made.code, 0) << made.errors;
  EXPECT_TRUE(fs::exists(fs::path(out) / "steering-simulated-prototypes/videos/sad.mp4"));
  const Ended asked =
      run_mien({"study", "design", prototypes, "-o", (folder.path() / "plans.csv").string()});
  EXPECT_EQ(asked.code, 0) << asked.errors;
  EXPECT_NE(asked.output.find("6 participants"), std::string::npos) << asked.output;
}

TEST_F(SteeredWords, AreAdjectivesOfManifests) {
  ASSERT_EQ(chains(results).code, 0);
  const std::string film = folder
                               .write("film.yaml",
                                      "mien: 1\nstudy: film\nexamples: {set: builtin:walks-10, "
                                      "ratings: chains/words.ratings.csv, scales: "
                                      "chains/words.scales.yaml}\nstimuli:\n  - {id: rather-sad, "
                                      "adjectives: {sad: 0.8}}\n")
                               .string();
  const Ended checked = run_mien({"check", film});
  EXPECT_EQ(checked.code, 0) << checked.errors;
}

TEST_F(SteeredWords, HaveTheSameResultsAgainAndTellWhatIsWrong) {
  ASSERT_EQ(chains(results).code, 0);
  const std::string again = (folder.path() / "again").string();
  ASSERT_EQ(chains(again).code, 0);
  for (const auto& entry : fs::recursive_directory_iterator(results))
    if (entry.is_regular_file()) {
      EXPECT_EQ(text_of(entry.path()),
                text_of(fs::path(again) / fs::relative(entry.path(), results)))
          << entry.path();
    }
  // Results are replaced by later ones, and nothing else is.
  EXPECT_EQ(chains(again, {"--discard", "1"}).code, 0);
  const fs::path notes = folder.path() / "notes";
  fs::create_directory(notes);
  folder.write("notes/mine.txt", "keep");
  const Ended refused = chains(notes.string());
  EXPECT_NE(refused.code, 0);
  EXPECT_NE(refused.errors.find("has no results of chains"), std::string::npos) << refused.errors;
  EXPECT_EQ(run_mien({"study", "chains", steps, manifest, "-o", again}).code, 0) << "in any order";
  EXPECT_NE(run_mien({"study", "chains", manifest, steps, "-o", steps}).code, 0);
  const Ended none = chains(again, {"--discard", "4"});
  EXPECT_NE(none.code, 0);
  EXPECT_NE(none.errors.find("discard fewer sweeps"), std::string::npos) << none.errors;
  EXPECT_NE(run_mien({"study", "report", steps, "--study", manifest}).code, 0);
  EXPECT_NE(run_mien({"study", "chains", "quickstart", steps, "-o", again}).code, 0);
}

TEST_F(SteeredWords, ArePreregisteredWithMethodSpaceChainsAndEnd) {
  const std::string archive = (folder.path() / "registration.zip").string();
  const std::string plans = (folder.path() / "plans.csv").string();
  const Ended made = run_mien({"study", "design", manifest, "-o", plans, "--freeze", archive});
  ASSERT_EQ(made.code, 0) << made.errors;
  EXPECT_NE(made.output.find("quickness"), std::string::npos);
  const std::string bytes = text_of(archive);
  fs::remove(archive);
  ASSERT_EQ(run_mien({"study", "design", manifest, "-o", plans, "--freeze", archive}).code, 0);
  EXPECT_EQ(text_of(archive), bytes);
  const fs::path unpacked = folder.path() / "unpacked";
  fs::create_directory(unpacked);
  ASSERT_EQ(
      run_program({"sh", "-c",
                   "cd '" + unpacked.string() + "' && " MIEN_CMAKE " -E tar xf '" + archive + "'"})
          .code,
      0);
  const std::string procedure = text_of(unpacked / "procedure.md");
  for (const char* told : {"Gibbs sampling with people [@harrison2020]", "quickness and largeness",
                           "4 sweeps", "one chain for every word", "\"sad\" and \"happy\""})
    EXPECT_NE(procedure.find(told), std::string::npos) << told << procedure;
  EXPECT_NE(text_of(unpacked / "references.bib").find("harrison2020"), std::string::npos);
  const std::string analysis = text_of(unpacked / "analysis.txt");
  EXPECT_NE(analysis.find("ends when 6 participants have completed their chains, 2 each of 8"),
            std::string::npos)
      << analysis;
}

}  // namespace
}  // namespace mien::test
