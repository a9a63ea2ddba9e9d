#include "pipeline/regression/report/regression_report.h"

#include <regex>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/html.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/regression/comparison/frame_comparison.h"
#include "pipeline/regression/report/report_pictures.h"
#include "pipeline/temporary_folder.h"
#include "render/image/image_io.h"
#include "render/image/resize.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

Manifest empty_study() {
  Manifest manifest;
  manifest.study = "walks";
  return manifest;
}

render::Image8 grey(int width, int height, int value) {
  render::Image8 picture(width, height);
  std::ranges::fill(picture.channels, static_cast<std::uint8_t>(value));
  return picture;
}

std::size_t count_of(const std::string& what, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// A report of stimuli whose motion is as it was.
class RegressionReport : public testing::Test {
 protected:
  RegressionReport() : now_(empty_study(), folder_.path(), 1, {}) { regression_.study = "walks"; }

  StimulusComparison& add(const std::string& id, Verdict verdict) {
    regression_.stimuli.push_back({.id = id, .verdict = verdict});
    return regression_.stimuli.back();
  }

  /// Adds a key frame that has become lighter by so much.
  void add_frame(StimulusComparison& stimulus, int frame, int lighter, int width = 8) {
    const render::Image8 before = grey(width, 4, 100), now = grey(width, 4, 100 + lighter);
    stimulus.frames.push_back(compare_pictures(frame, before, now));
    pictures_.put(stimulus.id, frame, before, now, stimulus.frames.back().perceived_map);
  }

  std::string page(const std::string& script = "show();") {
    const ComparedStudy study{
        .baseline = baseline_, .now = now_, .approved = {}, .pictures = &pictures_};
    return regression_report(regression_, study, script);
  }

  nlohmann::json data_of(std::size_t index, const std::string& page) const {
    const std::string start = "id=\"data-" + std::to_string(index) + "\">";
    const std::size_t at = page.find(start) + start.size();
    return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
  }

  TemporaryFolder folder_;
  Baseline baseline_;
  Rendition now_;
  ComparedPictures pictures_{folder_.path() / "frames"};
  Regression regression_;
};

TEST_F(RegressionReport, WithoutAScriptSaysThatPicturesAreMissing) {
  add_frame(add("walk", Verdict::differs), 7, 20);
  const std::string text = page("");
  EXPECT_NE(text.find("are not shown"), std::string::npos);
  EXPECT_NE(text.find("<b>walk</b>"), std::string::npos);
  EXPECT_EQ(text.find("data:image"), std::string::npos);
  EXPECT_EQ(page().find("are not shown"), std::string::npos);
}

TEST_F(RegressionReport, TellsFailuresBeforeWhatIsAlike) {
  add("calm", Verdict::alike);
  add("lost", Verdict::gone);
  add("fresh", Verdict::appeared);
  add("wrong", Verdict::differs);
  add("still", Verdict::same);
  const std::string text = page();
  const auto at = [&](const std::string& id) { return text.find("<b>" + id + "</b>"); };
  EXPECT_LT(at("wrong"), at("fresh"));
  EXPECT_LT(at("fresh"), at("lost"));
  EXPECT_LT(at("lost"), at("calm"));
  EXPECT_NE(at("calm"), std::string::npos);
  EXPECT_EQ(at("still"), std::string::npos);
  EXPECT_EQ(count_of(" open>", text), 1U);
  EXPECT_LT(text.find(" open>"), at("wrong"));
}

TEST_F(RegressionReport, KeepsNamesFromBecomingMarkup) {
  const std::string bold = "<b onclick=\"x\">'&";
  StimulusComparison& stimulus = add(bold, Verdict::differs);
  stimulus.reasons = {"<i>reason</i>"};
  stimulus.causes = {{Cause::motion, "<u>root</u>", "<s>evidence</s>", 1.0}};
  regression_.groups = {{Cause::motion, "<u>root</u>", {bold}, true}};
  add_frame(stimulus, 0, 10);
  stimulus.frames[0].shares = {{"</script><script>alert(1)</script><!--", 1.0, 2.0}};
  const std::string text = page();
  for (const char* markup : {"<b onclick", "<i>reason", "<u>root", "<s>evidence", "<script>alert"})
    EXPECT_EQ(text.find(markup), std::string::npos) << markup;
  EXPECT_EQ(count_of("<script", text), count_of("</script>", text));
  EXPECT_EQ(data_of(0, text)["frames"][0]["shares"][0]["part"], stimulus.frames[0].shares[0].part);
}

TEST_F(RegressionReport, LinksCausesToStimuliWhateverTheseAreCalled) {
  add("data-0", Verdict::differs);  // as an element of the page might be
  regression_.groups = {{Cause::motion, "seed", {"data-0"}, true}};
  const std::string text = page();
  EXPECT_NE(text.find("href=\"#stimulus-data-0\""), std::string::npos);
  EXPECT_EQ(count_of("id=\"stimulus-data-0\"", text), 1U);
  EXPECT_EQ(count_of("id=\"data-0\"", text), 1U);
}

TEST_F(RegressionReport, AsksForNothingFromANetwork) {
  add_frame(add("walk", Verdict::differs), 3, 10);
  const std::string text = page();
  EXPECT_EQ(text.find("://"), std::string::npos);
  EXPECT_FALSE(std::regex_search(text, std::regex("(src|href)=\"(?!#|data:)")));
  EXPECT_FALSE(std::regex_search(text, std::regex("@import|url\\(|fetch\\(|XMLHttpRequest")));
}

TEST_F(RegressionReport, ShowsEveryFrameOfFiftyAndTheWorstOfMore) {
  for (std::size_t i = 0; i < most_with_every_frame; ++i) {
    StimulusComparison& stimulus = add("walk-" + std::to_string(i), Verdict::differs);
    add_frame(stimulus, 0, 5);
    add_frame(stimulus, 7, 50);
    add_frame(stimulus, 9, 20);
  }
  add("other", Verdict::appeared);  // shows none
  EXPECT_EQ(data_of(0, page())["frames"].size(), 3U);
  add_frame(add("one-more", Verdict::differs), 0, 5);
  const std::string text = page();
  ASSERT_EQ(data_of(0, text)["frames"].size(), 1U);
  EXPECT_EQ(data_of(0, text)["frames"][0]["frame"], 7);
  EXPECT_NE(text.find("the worst frame is shown"), std::string::npos);
}

TEST_F(RegressionReport, LeavesOutFramesThatCannotBeLaidOverEachOther) {
  StimulusComparison& stimulus = add("walk", Verdict::differs);
  stimulus.frames.push_back({.frame = 0, .same = false, .same_size = false});
  EXPECT_TRUE(data_of(0, page())["frames"].empty());
}

TEST_F(RegressionReport, ShowsPicturesOfOtherSizesBesideEachOther) {
  StimulusComparison& stimulus = add("walk", Verdict::differs);
  const render::Image8 before = grey(8, 4, 100), now = grey(16, 8, 100);
  stimulus.frames = {compare_pictures(3, before, now)};
  pictures_.put("walk", 3, before, now, stimulus.frames[0].perceived_map);
  StimulusComparison& fresh = add("fresh", Verdict::appeared);
  fresh.frames = {{.frame = 2, .same = false, .same_size = false}};
  pictures_.put_now("fresh", 2, now);
  const std::string text = page();
  EXPECT_EQ(count_of("<figcaption>before</figcaption>", text), 1U);
  EXPECT_EQ(count_of("<figcaption>now</figcaption>", text), 2U);
}

TEST(PictureUri, IsTheFileOrASmallerPicture) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "wide.png", small = folder.path() / "small.png";
  render::write_png(file, grey(40, 20, 90));
  EXPECT_EQ(picture_uri(file, 0), data_uri("image/png", read_file(file)));
  EXPECT_EQ(picture_uri(file, 40), data_uri("image/png", read_file(file)));
  render::write_png(small, render::resized(grey(40, 20, 90), 10, 5));
  EXPECT_EQ(picture_uri(file, 10), data_uri("image/png", read_file(small)));
}

/// A stimulus with a video in its baseline and one in its study, of ten bytes each.
class ReportedVideos : public testing::Test {
 protected:
  ReportedVideos() {
    write(study() / "videos/walk.mp4", "0123456789");
    FilmRecord film;
    film.first_film_frame = 2;
    film.videos = {{.file = "videos/walk.mp4", .format = "mp4", .frames = 12, .fps = 30.0}};
    write(study() / film_record_path("walk"), film_record_text(film));
    baseline_.folder = folder_.path() / "baseline";
    StimulusFacts facts{.id = "walk"};
    facts.videos = {{film.videos[0], hash_of("abcdefghij"), 1}};
    baseline_.stimuli = {facts};
    write(kept(), "abcdefghij");
  }

  static void write(const fs::path& file, const std::string& text) {
    make_folder(file.parent_path());
    write_file(file, text);
  }
  fs::path study() const { return folder_.path() / "study"; }
  fs::path report() const { return folder_.path() / "report"; }
  fs::path kept() const { return baseline_.video_file("walk", baseline_.stimuli[0].videos[0]); }

  TemporaryFolder folder_;
  Baseline baseline_;
};

TEST_F(ReportedVideos, AreInThePageAsLongAsTheyFit) {
  ReportVideos videos(study(), report(), 30);
  const auto first = videos.of("walk", baseline_);
  EXPECT_EQ(first["before"]["src"], data_uri("video/mp4", "abcdefghij"));
  EXPECT_EQ(first["now"]["src"], data_uri("video/mp4", "0123456789"));
  EXPECT_EQ(first["before"]["first"], 1);
  EXPECT_EQ(first["now"]["first"], 2);
  EXPECT_FALSE(fs::exists(report()));
  const auto second = videos.of("walk", baseline_);
  EXPECT_EQ(second["before"]["src"], "videos/walk-before.mp4");
  EXPECT_EQ(read_file(report() / "videos/walk-before.mp4"), "abcdefghij");
  EXPECT_EQ(read_file(report() / "videos/walk-now.mp4"), "0123456789");
}

TEST_F(ReportedVideos, AreNoneWhereOneIsMissing) {
  EXPECT_TRUE(ReportVideos().of("walk", baseline_).is_null());
  EXPECT_TRUE(ReportVideos(study(), report()).of("run", baseline_).is_null());
  fs::remove(kept());
  EXPECT_TRUE(ReportVideos(study(), report()).of("walk", baseline_).is_null());
}

TEST_F(ReportedVideos, AreRefusedWhenTheyAreNotWhatWasApproved) {
  write(kept(), "version of a large file");
  EXPECT_THROW(ReportVideos(study(), report()).of("walk", baseline_), Error);
}

}  // namespace
}  // namespace mien::pipeline
