#include "pipeline/regression/regression.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/regression/approved_study.h"

namespace mien::pipeline {
namespace {

StimulusComparison because_of(int number, Cause cause, const std::string& root, Verdict verdict) {
  StimulusComparison comparison{.id = "s" + std::to_string(number), .verdict = verdict};
  comparison.causes = {{cause, root, "", 1.0}};
  return comparison;
}

TEST(CauseGroups, HaveAllThatDifferForOneReason) {
  std::vector<StimulusComparison> stimuli;
  for (int k = 0; k < 500; ++k)
    stimuli.push_back(because_of(k, Cause::renderer, "mien 1 → 2", Verdict::differs));
  std::vector<CauseGroup> groups = groups_of(stimuli);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].ids.size(), 500u);
  EXPECT_TRUE(groups[0].differs);

  for (int k = 0; k < 600; ++k)
    stimuli.push_back(because_of(k, Cause::drawing, "seed 1 → 2", Verdict::alike));
  stimuli.push_back(because_of(0, Cause::renderer, "mien 1 → 3", Verdict::differs));
  groups = groups_of(stimuli);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].root, "mien 1 → 2");  // what differs first, and the largest of it
  EXPECT_EQ(groups[1].root, "mien 1 → 3");
  EXPECT_FALSE(groups[2].differs);
}

TEST(Regressions, TellWhatAppearedAndWhatIsGone) {
  const test::TemporaryFolder scratch;
  test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  study.stimulus("blend")["id"] = "renamed";
  const Regression regression = test::regressed(study);
  EXPECT_FALSE(regression.passes());
  EXPECT_EQ(test::comparison_of(regression, "renamed").verdict, Verdict::appeared);
  EXPECT_EQ(test::comparison_of(regression, "blend").verdict, Verdict::gone);
  EXPECT_EQ(regression.count(Verdict::same), 5);
}

TEST(Regressions, DrawNothingWhereNothingCanHaveChangedButAudits) {
  const test::TemporaryFolder scratch;
  test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  study.stimulus("blend")["weights"]["normal"] = 0.7;
  Regression regression = test::regressed(study);
  EXPECT_EQ(test::comparison_of(regression, "blend").frames.size(), 2u);
  EXPECT_TRUE(test::comparison_of(regression, "blend").causes.at(0).share)
      << "what was approved could not be made again";
  EXPECT_EQ(test::comparison_of(regression, "tinted").frames.size(), 0u);
  EXPECT_EQ(test::comparison_of(regression, "tinted").frames_reused, 2);
  study.audits = 1.0;
  regression = test::regressed(study);
  EXPECT_EQ(test::comparison_of(regression, "tinted").frames.size(), 2u);
  EXPECT_EQ(regression.audited, 6);
}

TEST(Regressions, TellNothingWhereALibraryAloneIsAnother) {
  const test::TemporaryFolder scratch;
  test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  for (StimulusFacts& facts : study.baseline.stimuli) {
    facts.origin.libraries["Embree"] = "0.0.1";
    facts.origin.processor = "another";
    facts.origin.film_code = "feedc0de";
  }
  const Regression regression = test::regressed(study);
  EXPECT_TRUE(regression.passes());
  EXPECT_EQ(regression.count(Verdict::same), 6);
  EXPECT_TRUE(regression.groups.empty());
}

TEST(Regressions, KnowAStimulusUnderAnotherName) {
  const test::TemporaryFolder scratch;
  test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  study.stimulus("blend")["id"] = "mixture";
  const Regression regression = test::regressed(study);
  const StimulusComparison& renamed = test::comparison_of(regression, "mixture");
  EXPECT_EQ(renamed.former_id, "blend");
  EXPECT_NE(renamed.reasons.at(0).find("was renamed from blend"), std::string::npos);
  EXPECT_NE(renamed.reasons.at(1).find("--only mixture"), std::string::npos);
  EXPECT_NE(test::comparison_of(regression, "blend").reasons.at(1).find("was renamed to mixture"),
            std::string::npos);
}

// At another rate frames of one number show other moments.
TEST(Regressions, ComparePicturesOfTheSameMoments) {
  const test::TemporaryFolder scratch;
  test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  study.stimulus("blend")["output"]["fps"] = 20;
  const Regression regression = test::regressed(study);
  const StimulusComparison& blend = test::comparison_of(regression, "blend");
  EXPECT_EQ(blend.verdict, Verdict::differs);
  ASSERT_EQ(blend.frames.size(), 2u);
  EXPECT_GT(blend.frames.back().frame, 5);
  for (const FrameComparison& frame : blend.frames)
    EXPECT_LT(frame.perceived.mean, 0.005) << frame.frame;
}

TEST(Regressions, BlameNoPartOfTheBodyForNoise) {
  const test::TemporaryFolder scratch;
  test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  study.stimulus("blend")["weights"]["proud"] = 0.4001;
  const Regression regression = test::regressed(study);
  for (const FrameComparison& frame : test::comparison_of(regression, "blend").frames) {
    if (!frame.noise.is_bias) {
      EXPECT_TRUE(frame.shares.empty());
    }
  }
}

TEST(Regressions, TellWhereNoVideosWereApproved) {
  const test::TemporaryFolder scratch;
  test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  EXPECT_TRUE(test::regressed(study).without_videos.empty());
  study.approved("blend").videos.clear();
  EXPECT_EQ(test::regressed(study).without_videos, std::vector<std::string>{"blend"});
}

TEST(Regressions, TellThatNoVideoIsMadeAnyMoreUnlessNoneWereToBeMade) {
  const test::TemporaryFolder scratch;
  test::ChangedStudy study = test::approved_study().copied(scratch.path() / "study");
  for (auto& [id, videos] : study.videos) videos.clear();
  const Regression none_made = test::regressed(study);
  EXPECT_FALSE(none_made.passes());
  EXPECT_EQ(test::comparison_of(none_made, "blend").verdict, Verdict::differs);
  EXPECT_EQ(test::comparison_of(none_made, "blend").reasons,
            std::vector<std::string>{"mp4: is no longer made"});
  study.videos.clear();  // --without-videos
  EXPECT_TRUE(test::regressed(study).passes());
}

/// A study with an overlay of two stimuli, which was approved.
class RegressedOverlay : public testing::Test {
 protected:
  RegressedOverlay() {
    study_.manifest["overlays"] =
        nlohmann::json::parse(R"([{"id": "both", "target": "blend", "created": "wish"}])");
    study_.videos["both"] = study_.videos.at("blend");
    show("1");
    const std::filesystem::path folder = study_.folder / "baselines" / "with-overlay";
    test::approved_study().approved(study_, folder);
    study_.baseline = read_baseline(folder);
  }

  /// Makes its video show other frames.
  void show(const std::string& frames) {
    study_.videos["both"].front().hash = "file of " + frames;
    study_.videos["both"].front().record.frames_hash = frames;
  }

  StimulusComparison compared() const {
    return test::comparison_of(test::regressed(study_), "both");
  }

  test::TemporaryFolder scratch_;
  test::ChangedStudy study_ = test::approved_study().copied(scratch_.path() / "study");
};

TEST_F(RegressedOverlay, IsComparedByItsVideo) {
  EXPECT_EQ(compared().verdict, Verdict::same);
  EXPECT_TRUE(test::regressed(study_).passes());
  show("2");
  const StimulusComparison other = compared();
  EXPECT_EQ(other.verdict, Verdict::differs);
  EXPECT_EQ(other.reasons, std::vector<std::string>{"mp4: shows other frames"});
  ASSERT_EQ(other.causes.size(), 1u);
  EXPECT_EQ(other.causes[0].cause, Cause::unknown);
  study_.videos["both"].front().record.frames_hash = "1";
  EXPECT_EQ(compared().verdict, Verdict::alike) << "another encoder";
  study_.videos["both"].clear();
  EXPECT_EQ(compared().reasons, std::vector<std::string>{"mp4: is no longer made"});
}

TEST_F(RegressedOverlay, IsAsDifferentAsItsOptionsAndStimuli) {
  show("2");
  study_.manifest["overlays"][0]["opacity"] = 0.5;
  StimulusComparison other = compared();
  EXPECT_EQ(other.verdict, Verdict::differs);
  ASSERT_EQ(other.causes.size(), 1u);
  EXPECT_EQ(other.causes[0].cause, Cause::scene);
  EXPECT_NE(other.causes[0].root.find("opacity"), std::string::npos) << other.causes[0].root;
  study_.manifest["overlays"][0].erase("opacity");
  study_.stimulus("blend")["weights"]["normal"] = 0.9;
  other = compared();
  EXPECT_EQ(other.verdict, Verdict::differs);
  EXPECT_EQ(other.causes.at(0).cause, Cause::motion);
  study_.stimulus("blend")["weights"] = {{"normal", 0.6}, {"proud", 0.4001}};
  EXPECT_EQ(compared().verdict, Verdict::alike) << "the motion is within its limits";
}

TEST_F(RegressedOverlay, IsAcceptedWithMotionsThatWereApprovedLater) {
  show("2");
  study_.baseline.overlays->front().motion = "another";
  const StimulusComparison later = compared();
  EXPECT_EQ(later.verdict, Verdict::alike);
  ASSERT_EQ(later.causes.size(), 1u);
  EXPECT_EQ(later.causes[0].cause, Cause::motion);
}

TEST_F(RegressedOverlay, IsToldToBeNewGoneOrUnknown) {
  study_.manifest["overlays"][0]["id"] = "pair";
  const Regression renamed = test::regressed(study_);
  EXPECT_FALSE(renamed.passes());
  EXPECT_EQ(test::comparison_of(renamed, "pair").verdict, Verdict::appeared);
  EXPECT_EQ(test::comparison_of(renamed, "both").verdict, Verdict::gone);
  study_.manifest["overlays"][0]["id"] = "both";
  study_.baseline.overlays.reset();  // as in baselines of former versions
  const Regression unknown = test::regressed(study_);
  EXPECT_TRUE(unknown.passes());
  EXPECT_EQ(unknown.without_videos, std::vector<std::string>{"both"});
}

}  // namespace
}  // namespace mien::pipeline
