#include "pipeline/regression/approval.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/regression/approved_study.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class Approving : public testing::Test {
 protected:
  Baseline approve_now(const std::vector<std::string>& only, const std::stop_token& stop = {},
                       const std::function<void(double)>& done = {}) {
    const test::TemporaryFolder store;
    const auto now = test::rendition_of(study_, store.path());
    const Approval approval{.who = "me", .when = "2026-02-02", .why = "better", .only = only};
    return approve(*now, folder_, approval, {}, hashes_of_inputs(now->manifest()),
                   {.key_frames = 2, .threads = 2}, stop, done);
  }

  std::size_t editions() const {
    const fs::directory_iterator all(folder_ / "editions");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

  test::TemporaryFolder scratch_;
  test::ChangedStudy study_ = test::approved_study().copied(scratch_.path() / "study");
  fs::path folder_ = study_.baseline.folder;
};

TEST_F(Approving, OfSomeKeepsTheOthersWithTheirEdition) {
  const StimulusFacts wish = *study_.baseline.find("wish");
  study_.stimulus("blend")["weights"] = {{"sad", 1.0}};
  study_.stimulus("wish")["adjectives"]["quickness"] = 0.9;
  approve_now({"blend"});
  const Baseline baseline = read_baseline(folder_);
  EXPECT_EQ(baseline.find("wish")->motion, wish.motion);
  EXPECT_EQ(baseline.find("wish")->edition, wish.edition);
  EXPECT_NE(baseline.find("blend")->edition, wish.edition);
  EXPECT_EQ(editions(), 2u);
  ASSERT_EQ(baseline.approvals.size(), 2u);
  EXPECT_EQ(baseline.approvals[1].only, std::vector<std::string>{"blend"});
  EXPECT_EQ(baseline.approvals[1].why, "better");
  study_.baseline = baseline;
  const Regression regression = test::regressed(study_);
  EXPECT_EQ(test::comparison_of(regression, "blend").verdict, Verdict::same);
  EXPECT_EQ(test::comparison_of(regression, "wish").verdict, Verdict::differs);
  EXPECT_EQ(test::comparison_of(regression, "file").verdict, Verdict::same);
}

TEST_F(Approving, OfAllLeavesNothingOfWhatIsGone) {
  auto& stimuli = study_.manifest["stimuli"];
  stimuli.erase(stimuli.begin());
  approve_now({});
  const Baseline baseline = read_baseline(folder_);
  EXPECT_EQ(baseline.find("blend"), nullptr);
  EXPECT_FALSE(fs::exists(folder_ / "stimuli" / "blend"));
  EXPECT_EQ(editions(), 1u);
  EXPECT_EQ(baseline.stimuli.size(), 5u);
}

TEST_F(Approving, ThatIsInterruptedLeavesTheBaselineAsItWas) {
  study_.manifest["look"]["camera"] = "side";
  std::stop_source stop;
  EXPECT_THROW(approve_now({}, stop.get_token(),
                           [&](double share) {
                             if (share > 0.3) stop.request_stop();
                           }),
               Interrupted);
  study_.baseline = read_baseline(folder_);
  EXPECT_EQ(study_.baseline.approvals.size(), 1u);
  EXPECT_EQ(editions(), 1u);
  EXPECT_FALSE(fs::exists(folder_ / "stimuli" / ".next"));
  EXPECT_FALSE(fs::exists(folder_ / "editions" / ".next"));
  Regression regression = test::regressed(study_);
  EXPECT_EQ(test::comparison_of(regression, "blend").verdict, Verdict::differs);
  EXPECT_EQ(test::comparison_of(regression, "someone").verdict, Verdict::differs);
  approve_now({});
  study_.baseline = read_baseline(folder_);
  study_.videos.clear();
  regression = test::regressed(study_);
  EXPECT_EQ(regression.count(Verdict::same), 6);
  for (const auto& entry : fs::recursive_directory_iterator(folder_))
    EXPECT_NE(entry.path().extension(), ".next") << entry.path();
}

TEST_F(Approving, TwiceLeavesTheSameBytes) {
  const auto texts = [&] {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      const std::string path = fs::relative(entry.path(), folder_).generic_string();
      if (entry.is_regular_file() && path != "baseline.json") all[path] = read_file(entry.path());
    }
    return all;
  };
  approve_now({});
  const auto first = texts();
  approve_now({});
  EXPECT_EQ(texts(), first);
}

TEST_F(Approving, IsRefusedInTheBaselineOfAnotherStudy) {
  study_.manifest["study"] = "another";
  EXPECT_THROW(approve_now({}), std::exception);
}

}  // namespace
}  // namespace mien::pipeline
