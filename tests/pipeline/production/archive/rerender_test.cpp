#include "pipeline/production/archive/rerender.h"

#include <set>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/archive/made_study.h"
#include "pipeline/production/run/run.h"
#include "pipeline/tasks/task_graph.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

const std::vector<ComparableFilm> two_films = {{"a", 30, "frames/a"}, {"b", 70, "videos/b.mp4"}};

std::set<std::pair<std::string, int>> frames_of(const std::vector<FramesToRerender>& sample) {
  std::set<std::pair<std::string, int>> frames;
  for (const FramesToRerender& drawn : sample) {
    for (const int frame : drawn.frames) frames.emplace(drawn.film.id, frame);
  }
  return frames;
}

TEST(DrawnByLot, AreDifferentFramesOfAllFilmsTheSameForASeed) {
  EXPECT_EQ(frames_of(sampled_frames(two_films, 20, 3)).size(), 20u);
  EXPECT_EQ(frames_of(sampled_frames(two_films, 20, 3)),
            frames_of(sampled_frames(two_films, 20, 3)));
  EXPECT_NE(frames_of(sampled_frames(two_films, 20, 3)),
            frames_of(sampled_frames(two_films, 20, 4)));
  EXPECT_EQ(frames_of(sampled_frames(two_films, 1000, 3)).size(), 100u);
  EXPECT_TRUE(sampled_frames({}, 5, 3).empty());
}

TEST(DrawnByLot, AreEachFrameAsOften) {
  int of_a = 0;
  constexpr int lots = 3000;
  for (int seed = 0; seed < lots; ++seed) {
    const auto sample = sampled_frames(two_films, 1, static_cast<std::uint64_t>(seed));
    of_a += sample[0].film.id == "a" ? 1 : 0;
  }
  // 900 expected; four standard deviations of sqrt(3000 × 0.3 × 0.7) = 25.
  EXPECT_NEAR(of_a, 900, 100);
}

class RerenderTest : public testing::Test {
 protected:
  Manifest manifest() const {
    return load_manifest(study / "provenance.json",
                         [](const std::string&) { return std::nullopt; });
  }

  std::vector<RerenderedFrame> all_drawn() const {
    const Manifest made_by = manifest();
    const StudyContents contents = contents_of(study.folder());
    return rerender(made_by, contents, sampled_frames(comparable_films(made_by, contents), 1000, 0),
                    2, {}, {});
  }

  /// Of a film: how many frames agree, and how many there are.
  static std::pair<int, int> agreeing(const std::vector<RerenderedFrame>& frames,
                                      const std::string& film) {
    std::pair<int, int> count = {0, 0};
    for (const RerenderedFrame& frame : frames) {
      if (frame.film != film) continue;
      count.first += frame.agrees ? 1 : 0;
      ++count.second;
    }
    return count;
  }

  test::MadeStudy study;
};

TEST_F(RerenderTest, AgreesWithFramesAndVideosOfEveryKind) {
  const std::vector<RerenderedFrame> frames = all_drawn();
  std::set<std::string> films, against;
  for (const RerenderedFrame& frame : frames) {
    EXPECT_TRUE(frame.agrees) << frame.film << " " << frame.frame << ": " << frame.how;
    films.insert(frame.film);
    against.insert(frame.against);
  }
  EXPECT_EQ(films, (std::set<std::string>{"a", "a_with_b", "b", "c", "d"}));
  EXPECT_TRUE(against.contains("frames/a/00003.png"));
  EXPECT_TRUE(against.contains("frames/d/00003.exr"));
  EXPECT_TRUE(against.contains("videos/c.lossless.mp4"));
  EXPECT_TRUE(against.contains("videos/b.mp4"));
  fs::remove(study / "videos/c.lossless.mp4");
  const std::pair<int, int> webp = agreeing(all_drawn(), "c");
  EXPECT_EQ(webp.first, webp.second);
  EXPECT_GT(webp.second, 0);
}

TEST_F(RerenderTest, FindsAFrameThatIsAnother) {
  fs::copy_file(study / "frames/a/00001.png", study / "frames/a/00002.png",
                fs::copy_options::overwrite_existing);
  const std::pair<int, int> a = agreeing(all_drawn(), "a");
  EXPECT_EQ(a.first, a.second - 1);
}

TEST_F(RerenderTest, FindsAVideoOfAnotherFilm) {
  fs::copy_file(study / "videos/a_with_b.webm", study / "videos/b.mp4",
                fs::copy_options::overwrite_existing);
  EXPECT_EQ(agreeing(all_drawn(), "b").first, 0);
}

TEST_F(RerenderTest, FindsThatTheManifestIsAnother) {
  std::string text = read_file(study / "inputs/as-run.yaml");
  const std::size_t at = text.find("{sad: 1.0}");
  ASSERT_NE(at, std::string::npos) << text;
  write_file(study / "inputs/as-run.yaml", text.replace(at, 10, "{proud: 1}"));
  const std::vector<RerenderedFrame> frames = all_drawn();
  EXPECT_EQ(agreeing(frames, "b").first, 0);
  EXPECT_EQ(agreeing(frames, "a").first, agreeing(frames, "a").second);
}

TEST_F(RerenderTest, NeedsWhatMakesFilmsAlike) {
  const fs::path table = study / "metrics/exposure.csv";
  const auto wrong = [&]() -> std::string {
    try {
      all_drawn();
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  std::string text = read_file(table);
  text[text.find("\nb,") + 1] = 'z';
  write_file(table, text);
  EXPECT_NE(wrong().find("no row of \"b\""), std::string::npos) << wrong();
  fs::remove(table);
  EXPECT_NE(wrong().find("films are equalized with it"), std::string::npos) << wrong();
}

/// A study that makes its films alike in what the map says; its store is then as an archive has it,
/// without receipts and records of tasks.
std::vector<RerenderedFrame> drawn_again_of_films_alike_in(const std::string& equalize) {
  const test::TemporaryFolder folder;
  write_file(
      folder.path() / "m.yaml",
      "mien: 1\nstudy: tiny\nseed: 7\nexamples: {set: builtin:walks-10}\nequalize: " + equalize +
          "\noutput: {size: [48, 32], fps: 8, cycles: 1, quality: draft, video: []}\n"
          "stimuli:\n"
          "  - {id: a, weights: {brisk: 1}}\n"
          "  - {id: b, weights: {tired: 1}, look: {camera: side}}\n");
  const auto none = [](const std::string&) { return std::nullopt; };
  Production production(load_manifest(folder.path() / "m.yaml", none), {});
  for (const TaskOutcome& outcome : run(production, folder.path() / "out", 1, {}, {}).outcomes)
    EXPECT_EQ(outcome.error, "");
  fs::remove_all(folder.path() / "out/.mien");
  const Manifest made_by = load_manifest(folder.path() / "out/provenance.json", none);
  const StudyContents contents = contents_of(folder.path() / "out");
  return rerender(made_by, contents, sampled_frames(comparable_films(made_by, contents), 4, 0), 1,
                  {}, {});
}

TEST(Rerender, AgreesWhateverFilmsAreAlikeIn) {
  const nlohmann::json& asked = manifest_schema()["properties"]["equalize"]["oneOf"];
  const nlohmann::json& words = asked[0]["items"]["enum"];
  EXPECT_EQ(words.size(), asked[1]["properties"].size());
  ASSERT_GE(words.size(), 4u);
  for (const std::string word : words) {
    const std::vector<RerenderedFrame> frames = drawn_again_of_films_alike_in("[" + word + "]");
    EXPECT_EQ(frames.size(), 4u) << word;
    for (const RerenderedFrame& frame : frames)
      EXPECT_TRUE(frame.agrees) << word << ": " << frame.how;
  }
}

TEST_F(RerenderTest, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const Manifest made_by = manifest();
  const StudyContents contents = contents_of(study.folder());
  const auto sample = sampled_frames(comparable_films(made_by, contents), 2, 0);
  EXPECT_THROW(rerender(made_by, contents, sample, 1, stop.get_token(), {}), Interrupted);
}

}  // namespace
}  // namespace mien::pipeline
