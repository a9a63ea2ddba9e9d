#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

constexpr char walks_text[] = R"(mien: 1
study: walks
seed: 7
examples: {set: builtin:walks-10, ratings: builtin}
stimuli:
  - {id: usual, weights: {normal: 1}, factors: {made: as-is}}
  - {id: sad, weights: {sad: 1}, factors: {made: as-is}}
  - {id: happy, weights: {happy: 1}, factors: {made: mixed}}
  - {id: proud, weights: {proud: 1}, factors: {made: mixed}}
questionnaire:
  participants: 6
  scales: [sad-happy, slow-fast]
)";

/// Two rounds of ratings by simulated people.
class NextRound : public testing::Test {
 protected:
  void SetUp() override {
    const Ended made = run_mien({"study", "simulate", first, "-o", answers});
    ASSERT_EQ(made.code, 0) << made.errors;
  }

  Ended next(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"study", "next"};
    words.insert(words.end(), more.begin(), more.end());
    return run_mien(words);
  }

  const Scratch folder;
  const std::string first = folder.write("walks.yaml", walks_text).string();
  const std::string answers = (folder.path() / "answers.csv").string();
  const std::string second = (folder.path() / "walks-2.yaml").string();
  const std::string third = (folder.path() / "walks-3.yaml").string();
};

TEST_F(NextRound, FollowsFromTheAnswersOfAllRoundsBefore) {
  const Ended chosen = next({answers, first, "-o", second, "--films", "3"});
  ASSERT_EQ(chosen.code, 0) << chosen.errors;
  EXPECT_EQ(chosen.output.find("simulated answers\n"), 0u) << chosen.output;
  const std::string more = (folder.path() / "answers-2.csv").string();
  ASSERT_EQ(run_mien({"study", "simulate", second, "-o", more}).code, 0);
  const fs::path tables = folder.path() / "tables";
  const std::string map = (folder.path() / "known.svg").string();
  const Ended again = next({second, answers, more, "-o", third, "--films", "2", "--highest",
                            "sad-happy", "--tables", tables.string(), "--show", map});
  ASSERT_EQ(again.code, 0) << again.errors;
  EXPECT_EQ(again.errors, "");
  const std::string text = text_of(third);
  EXPECT_NE(text.find("study: walks-3\n"), std::string::npos);
  EXPECT_NE(text.find("stimuli: [round3-01, round3-02]"), std::string::npos) << text;
  EXPECT_NE(text.find("{id: round2-03, weights: "), std::string::npos) << text;
  EXPECT_EQ(run_mien({"check", third}).code, 0);
  const std::string listed = text_of(tables / "next_films.csv");
  EXPECT_EQ(std::count(listed.begin(), listed.end(), '\n'), 1 + 2 * 2) << listed;
  const std::string codebook = text_of(tables / "codebook.csv");
  for (const char* table : {"next_films.csv,", "known_films.csv,", "rounds.csv,"})
    EXPECT_NE(codebook.find(table), std::string::npos) << codebook;
  const std::string rounds = text_of(tables / "rounds.csv");  // two rounds and scales
  EXPECT_EQ(std::count(rounds.begin(), rounds.end(), '\n'), 1 + 2 * 2) << rounds;
  EXPECT_NE(rounds.find("\n2,slow-fast,3,18,"), std::string::npos) << rounds;
  EXPECT_NE(again.output.find("after the next"), std::string::npos) << again.output;
  EXPECT_NE(text_of(map).find("<svg"), std::string::npos);
  EXPECT_NE(text_of(tables / "known_films.csv").find("normal 1,sad-happy,"), std::string::npos);
  // Again: the same bytes, over the same file.
  EXPECT_EQ(
      next({second, answers, more, "-o", third, "--films", "2", "--highest", "sad-happy"}).code, 0);
  EXPECT_EQ(text_of(third), text);
}

TEST_F(NextRound, IsTheFirstWithoutAnswers) {
  const std::string begun = (folder.path() / "walks-1.yaml").string();
  const Ended chosen = next({first, "-o", begun, "--films", "5"});
  ASSERT_EQ(chosen.code, 0) << chosen.errors;
  EXPECT_EQ(chosen.errors, "");
  EXPECT_NE(chosen.output.find("by their features alone"), std::string::npos) << chosen.output;
  EXPECT_EQ(chosen.output.find("simulated"), std::string::npos) << chosen.output;
  const std::string text = text_of(begun);
  EXPECT_NE(text.find("# The first round of films"), std::string::npos) << text;
  EXPECT_NE(text.find("study: walks-1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("stimuli: [round1-01, round1-02, round1-03, round1-04, round1-05]"),
            std::string::npos)
      << text;
  // Once more, before they are rated: others.
  const Ended more = next({begun, "-o", third, "--films", "3"});
  ASSERT_EQ(more.code, 0) << more.errors;
  EXPECT_NE(text_of(third).find("stimuli: [round2-01, round2-02, round2-03]"), std::string::npos);
  const auto blend = [](const std::string& of, const std::string& id) {
    const std::size_t from = of.find("{id: " + id + ", weights: ") + id.size() + 7;
    return of.substr(from, of.find('}', from) - from);
  };
  for (const char* film : {"round2-01", "round2-02", "round2-03"})
    EXPECT_EQ(text.find(blend(text_of(third), film)), std::string::npos)
        << blend(text_of(third), film);
  const std::string rated = (folder.path() / "answers-1.csv").string();
  ASSERT_EQ(run_mien({"study", "simulate", begun, "-o", rated}).code, 0);
  const std::string methods = (folder.path() / "round-2.md").string();
  const Ended after = next({rated, begun, "-o", second, "--films", "2", "--methods", methods});
  ASSERT_EQ(after.code, 0) << after.errors;
  EXPECT_EQ(text_of(methods).find("2 films were chosen among 600 films"), 0u) << text_of(methods);
  EXPECT_NE(text_of(methods).find("from the simulated ratings so far on sad-happy and slow-fast"),
            std::string::npos)
      << text_of(methods);
  const std::string references = text_of(folder.path() / "round-2.bib");
  for (const char* key : {"cohn1996", "rasmussen2006", "ginsbourger2010"}) {
    EXPECT_NE(references.find(std::string("{") + key + ","), std::string::npos) << references;
    EXPECT_NE(text_of(methods).find(std::string("@") + key), std::string::npos);
  }
  EXPECT_EQ(after.errors, "");
  EXPECT_NE(text_of(second).find("study: walks-2\n"), std::string::npos);
  EXPECT_NE(text_of(second).find("stimuli: [round2-01, round2-02]"), std::string::npos);
}

TEST_F(NextRound, CountsAnswersOnceAndTheScaleOfTheAimAlways) {
  const Ended once = next({answers, first, "-o", second});
  ASSERT_EQ(once.code, 0) << once.errors;
  const std::string copy = folder.write("copy.csv", text_of(answers)).string();
  const Ended twice = next({answers, copy, first, "-o", second});
  EXPECT_EQ(twice.code, 0) << twice.errors;  // the same manifest, over the file
  EXPECT_NE(twice.errors.find("copy.csv has the same content as "), std::string::npos)
      << twice.errors;
  const Ended aimed =
      next({answers, first, "-o", third, "--scales", "slow-fast", "--lowest", "sad-happy"});
  ASSERT_EQ(aimed.code, 0) << aimed.errors;
  EXPECT_NE(aimed.output.find("that may be rated lowest on sad-happy"), std::string::npos);
}

TEST_F(NextRound, IsRefusedBeforeAnythingIsWritten) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& with) {
    const Ended ended = next(words);
    EXPECT_EQ(ended.code, 2) << ended.output;
    EXPECT_NE(ended.errors.find(with), std::string::npos) << ended.errors;
    EXPECT_FALSE(fs::exists(second));
  };
  refused({answers, first, "-o", second, "--lowest", "sad"}, "no scale \"sad\"");
  refused({first, "-o", second, "--highest", "sad-happy"}, "--highest needs ratings");
  refused({first, "-o", second, "--show", "known.png"}, "--show needs ratings");
  refused({first, "-o", second, "--pairs", "4"}, "no answers were given");
  refused({first, "-o", second, "--methods", "text.txt"}, "let it end in .md");
  const std::string nowhere = (folder.path() / "nowhere").string();
  refused({first, "-o", second, "--methods", nowhere + "/text.md"}, "its folder does not exist");
  refused({answers, first, "-o", second, "--show", nowhere + "/known.png"}, "its folder does not");
  refused({first, "-o", nowhere + "/next.yaml"}, "its folder does not exist");
  folder.write("paper.bib", "@book{mine}\n");
  refused({answers, first, "-o", second, "--methods", (folder.path() / "paper.md").string()},
          "holds something else");
  EXPECT_EQ(text_of(folder.path() / "paper.bib"), "@book{mine}\n");
  EXPECT_FALSE(fs::exists(folder.path() / "paper.md"));
  refused({answers, first, "-o", second, "--features", "niceness"}, "niceness");
  refused({answers, first, "-o", second, "--show", "known.gif"}, ".png, .svg or .pdf");
  refused({answers, first, "-o", answers}, "exists already, but holds something else");
  const std::string planned =
      folder
          .write("planned.yaml", std::string(walks_text) +
                                     "  analysis: {contrasts: [{name: made, weights: {made: "
                                     "{mixed: 1, as-is: -1}}}]}\n")
          .string();
  refused({answers, planned, "-o", second}, "made");
}

/// Lines about new films.
std::string new_films(const std::string& text) {
  std::string lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    const std::string line = text.substr(from, to - from);
    if (line.find("id: round2-") != std::string::npos) lines += line + "\n";
    from = to + 1;
  }
  return lines;
}

TEST(ShippedNextRound, IsWhatIsChosenFromTheAnswers) {
  const Scratch folder;
  const fs::path manifests = fs::path(MIEN_SOURCE_DIR) / "manifests";
  const std::string written = (folder.path() / "next-round.yaml").string();
  const Ended chosen =
      run_mien({"study", "next", (manifests / "closed-loop-2.answers.csv").string(),
                (manifests / "closed-loop-2.yaml").string(), "-o", written, "--films", "4",
                "--study", "next-round"});
  ASSERT_EQ(chosen.code, 0) << chosen.errors;
  const std::string films = new_films(text_of(written));
  EXPECT_NE(films, "");
  EXPECT_EQ(films, new_films(text_of(manifests / "next-round.yaml")));
}

}  // namespace
}  // namespace mien::test
