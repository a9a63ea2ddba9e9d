#include "pipeline/regression/baseline.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/regression/approved_frames.h"
#include "pipeline/regression/approved_study.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class BaselineFiles : public testing::Test {
 protected:
  test::TemporaryFolder scratch_;
  test::ChangedStudy study_ = test::approved_study().copied(scratch_.path() / "study");
  fs::path folder_ = study_.baseline.folder;

  /// What reading it throws; "" nothing.
  template <class Read>
  std::string refusal(const Read& read) const {
    try {
      read();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(BaselineFiles, AreReadAsTheyWereWritten) {
  const StimulusFacts& facts = *study_.baseline.find("blend");
  const std::string text = read_file(folder_ / "stimuli" / "blend" / "stimulus.json");
  write_facts(facts, folder_ / "stimuli" / "blend");
  EXPECT_EQ(read_file(folder_ / "stimuli" / "blend" / "stimulus.json"), text);
  EXPECT_EQ(facts.origin, this_origin());
  EXPECT_EQ(facts.key_frames.size(), 2u);
  EXPECT_EQ(facts.weights.size(), 2u);
  ASSERT_EQ(facts.videos.size(), 1u);
  EXPECT_DOUBLE_EQ(facts.videos[0].record.worst_psnr_db, 41.0);
  ASSERT_EQ(study_.baseline.approvals.size(), 1u);
  EXPECT_EQ(study_.baseline.approvals[0].who, "a tester");
}

TEST_F(BaselineFiles, ThatAreMissingOrDamagedAreNamedWithARemedy) {
  const fs::path facts = folder_ / "stimuli" / "wish" / "stimulus.json";
  const auto read = [&] { read_baseline(folder_); };
  EXPECT_EQ(refusal(read), "");
  for (const char* text : {"", "{", "[]", "{\"id\": 3}"}) {
    write_file(facts, text);
    const std::string said = refusal(read);
    EXPECT_NE(said.find("wish/stimulus.json"), std::string::npos) << text << ": " << said;
    EXPECT_NE(said.find("git checkout"), std::string::npos) << said;
  }
  fs::remove(facts);
  EXPECT_NE(refusal(read).find("wish/stimulus.json"), std::string::npos);
}

TEST_F(BaselineFiles, OfALaterVersionAreRefused) {
  study_.change_text("baselines/small/baseline.json", "\"baseline\": 1", "\"baseline\": 9");
  const std::string said = refusal([&] { read_baseline(folder_); });
  EXPECT_NE(said.find("newer version of mien"), std::string::npos) << said;
  EXPECT_NE(said.find("update mien"), std::string::npos) << said;
  EXPECT_EQ(said.find("approve the study again"), std::string::npos) << said;
}

TEST_F(BaselineFiles, OfAMergeThatWasNotEndedAreToldAsSuch) {
  study_.change_text("baselines/small/baseline.json", "  \"study\"", "<<<<<<< HEAD\n  \"study\"");
  const std::string said = refusal([&] { read_baseline(folder_); });
  EXPECT_NE(said.find("baseline.json:3"), std::string::npos) << said;
  EXPECT_NE(said.find("merge conflict"), std::string::npos) << said;
  write_file(folder_ / "baseline.json", "{\"baseline\": 1,\n");
  const std::string cut = refusal([&] { read_baseline(folder_); });
  EXPECT_NE(cut.find("baseline.json:"), std::string::npos) << cut;
  EXPECT_EQ(cut.find("json.exception"), std::string::npos) << cut;
}

TEST_F(BaselineFiles, OfPicturesAreChecked) {
  const Baseline& baseline = study_.baseline;
  const int frame = baseline.find("blend")->key_frames.front().frame;
  const int other = baseline.find("blend")->key_frames.back().frame;
  const auto picture = [&] { approved_picture(baseline, "blend", frame); };
  const auto blocks = [&] { approved_blocks(baseline, "blend", frame); };
  const fs::path file = baseline.picture_file("blend", frame);
  fs::copy_file(baseline.picture_file("blend", other), file, fs::copy_options::overwrite_existing);
  EXPECT_NE(refusal(picture).find("differs from the approved image"), std::string::npos);
  // What git leaves where its large files were not fetched:
  write_file(file, "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n");
  EXPECT_NE(refusal(picture).find("git lfs pull"), std::string::npos) << refusal(picture);
  fs::remove(baseline.blocks_file("blend", frame));
  EXPECT_NE(refusal(blocks).find(".exr"), std::string::npos) << refusal(blocks);
  write_file(baseline.motion_file("blend"), "HIERARCHY");
  const auto clip = [&] { approved_clip(baseline, "blend", {}); };
  EXPECT_NE(refusal(clip).find("motion.bvh"), std::string::npos) << refusal(clip);
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

TEST_F(BaselineFiles, OfWhichAByteIsAnotherAreAllRefused) {
  const auto read = [&] { check_files(read_baseline(folder_)); };
  ASSERT_EQ(refusal(read), "");
  std::mt19937 random(34);
  const auto below = [&](std::size_t count) { return random() % count; };
  const std::vector<fs::path> files = files_in(folder_);
  for (std::size_t i = 0; i < 300; ++i) {
    const fs::path& file = files[i % files.size()];
    const std::string text = read_file(file);
    if (text.empty()) continue;
    std::string damaged = text;
    switch (below(4)) {
      case 0:
        damaged.resize(below(text.size()));
        break;
      case 1:
        damaged.insert(below(text.size()), " ");
        break;
      default:
        damaged[below(text.size())] ^= static_cast<char>(1 << below(7));
    }
    if (damaged == text) continue;
    write_file(file, damaged);
    EXPECT_NE(refusal(read), "") << file << " after mutation " << i;
    write_file(file, text);
  }
  EXPECT_EQ(refusal(read), "");
}

TEST_F(BaselineFiles, ThatAreMissingOrWereAddedAreAllTold) {
  const auto read = [&] { check_files(read_baseline(folder_)); };
  for (const fs::path& file : files_in(folder_)) {
    const std::string text = read_file(file);
    fs::remove(file);
    EXPECT_NE(refusal(read), "") << file;
    write_file(file, text);
  }
  const fs::path added =
      folder_ / "editions" / study_.baseline.stimuli.front().edition / "inputs" / "more.bvh";
  write_file(added, "HIERARCHY");
  EXPECT_NE(refusal(read).find("more.bvh: did not exist when the study was approved"),
            std::string::npos)
      << refusal(read);
}

TEST_F(BaselineFiles, OfTheVersionWithoutChecksumsAreRead) {
  const fs::path file = folder_ / "baseline.json";
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(read_file(file));
  json.erase("checksum");
  json.erase("sums");
  write_file(file, json.dump(2) + "\n");
  const Baseline old = read_baseline(folder_);
  EXPECT_TRUE(old.sums.empty());
  EXPECT_EQ(old.stimuli.size(), study_.baseline.stimuli.size());
  EXPECT_NO_THROW(check_files(old));
}

TEST(KeyFrames, AreSpreadFromTheFirstToTheLast) {
  EXPECT_EQ(key_frames_of(1, 4), std::vector<int>{0});
  EXPECT_EQ(key_frames_of(10, 2), (std::vector<int>{0, 9}));
  EXPECT_EQ(key_frames_of(3, 8), (std::vector<int>{0, 1, 2}));
}

}  // namespace
}  // namespace mien::pipeline
