#include <fstream>
#include <memory>

#include <gtest/gtest.h>

#include "faults/damage.h"
#include "faults/damage_trials.h"
#include "faults/disk_trials.h"
#include "faults/farm_disk_trials.h"
#include "faults/kills.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

/// The undisturbed study is made once.
class Faults : public testing::Test {
 protected:
  static void SetUpTestSuite() { trial_ = std::make_unique<Trial>(17); }
  static void TearDownTestSuite() { trial_.reset(); }

  static Trial& trial() { return *trial_; }

  static void expect_sound(const Figures& figures) {
    if (!figures.skipped.empty()) GTEST_SKIP() << figures.skipped;
    EXPECT_GT(figures.studies, 0);
    for (const std::string& complaint : figures.complaints) ADD_FAILURE() << complaint;
  }

 private:
  static std::unique_ptr<Trial> trial_;
};

std::unique_ptr<Trial> Faults::trial_;

TEST_F(Faults, OfTenKillsNothingIsLost) { expect_sound(random_kills(trial(), 10)); }

TEST_F(Faults, TwoWorkersMayMakeTheSame) { expect_sound(duplicated_workers(trial(), 1)); }

TEST_F(Faults, APausedWorkerHarmsNothingWhenItWakes) {
  expect_sound(paused_workers(trial(), 2, false));
}

TEST_F(Faults, WhatIsDamagedSwappedOrForgedIsMadeAgain) { expect_sound(damaged_files(trial(), 8)); }

TEST_F(Faults, DamagedWorkingsAreNotTrusted) { expect_sound(damaged_work(trial(), 4)); }

TEST_F(Faults, TimesOfFilesDoNotMatter) { expect_sound(set_clocks(trial(), 2)); }

TEST_F(Faults, AFullDiskIsToldOnceAndTheSameCommandGoesOn) { expect_sound(full_disks(trial(), 3)); }

TEST_F(Faults, ADiskThatWasFullForAWhileHarmsNothing) {
  expect_sound(disks_full_for_a_while(trial(), 1));
}

TEST_F(Faults, AReadOnlyStoreIsToldOnce) { expect_sound(read_only_stores(trial(), 2)); }

TEST_F(Faults, ResumingOnAFullDiskTakesNoJobBack) { expect_sound(resumed_on_full_disks()); }

TEST_F(Faults, JobsWaitForAFolderThatIsFullOrReadOnly) { expect_sound(jobs_on_failing_disks()); }

/// What the comparison must see: a finished study in which something is wrong.
class FaultChecks : public Faults {
 protected:
  fs::path out = trial().finished_out();
  fs::path study = Trial::study_in(out);

  std::vector<std::string> found() const {
    return differences(trial().undisturbed(), bytes_in(study));
  }
  static void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }
};

TEST_F(FaultChecks, FindNothingWhereNothingIsWrong) {
  EXPECT_TRUE(found().empty());
  EXPECT_TRUE(leftovers(study).empty());
}

TEST_F(FaultChecks, SeeEveryKindOfDamageInAnyKindOfFile) {
  for (const char* path : {"videos/one.mp4", "frames/one/00003.png", "frames/two/00003.exr",
                           "clips/two.glb", "report.html", ".mien/receipts/videos/one.mp4.json"}) {
    const std::string bytes = text_of(study / path);
    for (const Damage& damage : damages()) {
      damage.to(study / path, trial().random);
      EXPECT_EQ(found().size(), 1u) << path << ": " << damage.name;
      fs::remove_all(study / path);
      write(study / path, bytes);
    }
  }
  EXPECT_TRUE(found().empty());
}

TEST_F(FaultChecks, SeeWhatWasSwappedOrForged) {
  swap_files(study / "frames/one/00003.png", study / "frames/one/00004.png");
  EXPECT_EQ(found().size(), 2u);
  swap_files(study / "frames/one/00003.png", study / "frames/one/00004.png");
  forge_receipt(study, "videos/one.mp4", "videos/two.mp4");
  EXPECT_EQ(found(), std::vector<std::string>{".mien/receipts/videos/one.mp4.json differs"});
}

TEST_F(FaultChecks, SeeWhatIsTooMuch) {
  write(study / "videos/four.mp4", "x");
  EXPECT_EQ(found(), std::vector<std::string>{"videos/four.mp4 was left behind"});
  for (const char* left :
       {".mien/attempts/host-1-2/3/one.mp4", ".mien/claims/0123",
        ".mien/partial/frames/one/key/frames/00001.png", ".mien/workers/host-1-2.json.new"}) {
    EXPECT_TRUE(leftovers(study).empty());
    write(study / left, "");
    EXPECT_FALSE(leftovers(study).empty()) << left;
    fs::remove_all(study / ".mien/attempts/host-1-2");
    fs::remove(study / left);
  }
}

}  // namespace
}  // namespace mien::test
