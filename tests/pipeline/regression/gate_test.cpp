#include <set>

#include <gtest/gtest.h>

#include "pipeline/regression/approved_study.h"
#include "pipeline/regression/comparison/noise_test.h"
#include "pipeline/regression/regression.h"

namespace mien::pipeline {
namespace {

class Gates : public testing::Test {
 protected:
  Gate planted() {
    return plant_defects({.baseline = study_.baseline,
                          .now = *now_,
                          .approved = [](const std::string&) -> Rendition& { throw 0; }});
  }

  test::TemporaryFolder scratch_;
  test::ChangedStudy study_ = test::approved_study().copied(scratch_.path() / "study");
  std::unique_ptr<Rendition> now_ = test::rendition_of(study_, scratch_.path() / "store");
};

TEST_F(Gates, HoldWhereverTheDefectIsPlanted) {
  std::set<std::string> defects, ids;
  for (int day = 1; day < 40; ++day) {
    study_.baseline.approvals.back().when = "2026-01-" + std::to_string(day);
    const Gate gate = planted();
    EXPECT_TRUE(gate.motion_caught) << gate.id << ": " << gate.motion_defect;
    EXPECT_TRUE(gate.picture_caught) << gate.id << ": " << gate.picture_defect;
    defects.insert(gate.motion_defect);
    ids.insert(gate.id);
  }
  EXPECT_GT(defects.size(), 10u);
  EXPECT_EQ(ids.size(), 6u);
}

TEST_F(Gates, FailWhereNothingCouldBeSeen) {
  for (const StimulusFacts& facts : study_.baseline.stimuli) {
    const auto file = study_.baseline.blocks_file(facts.id, facts.key_frames.front().frame);
    BlockStatistics blocks = read_blocks(file);
    for (float& variance : blocks.variance) variance = 100.0f;
    write_blocks(file, blocks);
  }
  EXPECT_FALSE(planted().picture_caught);
  const Regression regression = test::regressed(study_);
  EXPECT_FALSE(regression.gate.holds());
  EXPECT_FALSE(regression.passes());
}

TEST_F(Gates, HoldWithNothingToPlantIn) {
  study_.baseline.stimuli.clear();
  EXPECT_TRUE(planted().holds());
  EXPECT_EQ(planted().id, "");
}

}  // namespace
}  // namespace mien::pipeline
