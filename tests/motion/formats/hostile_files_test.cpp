// What is wrong with files of any format, by their paths: each fault is tried on every format of
// the list in motion_file.cpp.

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/formats/gzip_text.h"
#include "motion/formats/motion_format.h"
#include "motion/formats/small_files.h"
#include "motion/refusal.h"
#include "motion/text/excerpt.h"
#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

using test::gzipped;
using test::small_files;
using test::SmallFile;

size_t frames_in(const FileContents& contents) {
  if (const auto* recording = std::get_if<Recording>(&contents)) return recording->poses.size();
  return static_cast<size_t>(std::get<PointRecording>(contents).frame_count());
}

void expect_sound(const FileContents& contents, const std::string& file) {
  EXPECT_GT(frames_in(contents), 0u) << file;
  if (const auto* recording = std::get_if<Recording>(&contents)) {
    EXPECT_TRUE(is_well_formed(recording->skeleton)) << file;
    for (const Pose& pose : recording->poses)
      EXPECT_EQ(pose.rotations.size(), recording->skeleton.joints.size()) << file;
    return;
  }
  const auto& points = std::get<PointRecording>(contents);
  EXPECT_EQ(points.positions.size(), points.seen.size()) << file;
  EXPECT_EQ(points.positions.size() % points.points.size(), 0u) << file;
}

class HostileFiles : public testing::TestWithParam<SmallFile> {
 protected:
  FileContents read(const std::string& bytes) const {
    return read_file(GetParam().write_to(folder.path(), bytes), GetParam().how);
  }

  /// The file is read, or refused in one line that begins with its name.
  void expect_read_or_refused(const std::string& bytes) const {
    try {
      expect_sound(read(bytes), GetParam().name);
    } catch (const Error& error) {
      expect_plain(error.what());
    }
  }

  std::string refusal(const std::string& bytes) const {
    std::string words = test::refusal_of([&] { read(bytes); });
    expect_plain(words);
    return words;
  }

  void expect_plain(const std::string& words) const {
    // Of companions, the name may be that of the companion.
    EXPECT_TRUE(words.starts_with(folder.path().string())) << words;
    EXPECT_EQ(words.find('\n'), std::string::npos) << words;
    EXPECT_LT(words.size(), folder.path().string().size() + 600) << words;
    EXPECT_EQ(printable(words), words);
  }

  test::TemporaryFolder folder;
};

TEST(SmallFiles, ExistForEveryFormat) {
  std::set<std::string> endings;
  for (const SmallFile& file : small_files()) endings.insert(lower_case_ending(file.name));
  for (const MotionFormat& format : motion_formats())
    EXPECT_TRUE(endings.contains(std::string(format.ending)))
        << "add a small file of " << format.ending << " to small_files.h";
}

TEST_P(HostileFiles, AreSoundBeforeTheyAreDamaged) {
  expect_sound(read(GetParam().bytes), GetParam().name);
}

TEST_P(HostileFiles, CutShortAnywhereAreReadOrRefused) {
  const std::string& bytes = GetParam().bytes;
  for (size_t length = 0; length < bytes.size(); ++length)
    expect_read_or_refused(bytes.substr(0, length));
}

TEST_P(HostileFiles, ChangedAnyhowAreReadOrRefused) {
  const std::string likely = std::string("0129.-+eE,;:\t\n {}[]\"<>/\x1b", 24) + '\0' + '\xff';
  std::mt19937_64 random(38);
  for (int trial = 0; trial < 200; ++trial) {
    std::string bytes = GetParam().bytes;
    const size_t changes = 1 + random() % 4;
    for (size_t change = 0; change < changes; ++change) {
      const size_t at = random() % bytes.size();
      switch (random() % 4) {
        case 0:
          bytes[at] = likely[random() % likely.size()];
          break;
        case 1:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
          break;
        case 2:
          bytes.erase(at, 1 + random() % 4);
          break;
        default:
          bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 30));
      }
      if (bytes.empty()) bytes = "x";
    }
    expect_read_or_refused(bytes);
  }
}

// Frames that are stated but not there: refused, or only those read that are.
TEST_P(HostileFiles, OfABillionFramesAreReadAsFarAsTheyGo) {
  if (GetParam().endless.empty()) GTEST_SKIP() << "states no number of frames";
  try {
    EXPECT_LT(frames_in(read(GetParam().endless)), 100u);  // a C3D file is padded to 512 bytes
  } catch (const Error& error) {
    expect_plain(error.what());
  }
}

TEST_P(HostileFiles, OfOtherKindsAreNamedForWhatTheyAre) {
  const std::map<std::string, std::string> others = {
      {"", "is empty"},
      {" \r\n\t\n", "only white space"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
       "is a git LFS pointer"},
      {"<!DOCTYPE html>\n<html><head><title>404</title></head></html>\n", "is a web page (HTML)"},
      {"\n  <html lang=\"en\">\n", "is a web page (HTML)"},
      {"\x89PNG\r\n\x1a\n" + std::string(64, '\1'), "is a picture (PNG)"},
      {"\xff\xd8\xff\xe0" + std::string(64, '\1'), "is a picture (JPEG)"},
      {"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n1 0 obj\n", "is a document (PDF)"},
      {test::zip_file({{"readme.txt", "Hello"}}), "is a ZIP archive"},
      {gzipped(GetParam().bytes), "is compressed (gzip)"},
      {std::string("\xff\xfeH\0I\0E\0R\0", 10), "is text in UTF-16"},
  };
  for (const auto& [bytes, words] : others)
    EXPECT_NE(refusal(bytes).find(words), std::string::npos) << words << "\n" << refusal(bytes);
}

TEST_P(HostileFiles, OfOtherFormatsAreReadOrRefused) {
  for (const SmallFile& other : small_files()) expect_read_or_refused(other.bytes);
}

TEST_P(HostileFiles, CompressedOnesAreReadOrRefusedInOneLine) {
  SmallFile packed = GetParam();
  packed.name += ".gz";
  const auto read_packed = [&](const std::string& bytes) {
    return read_file(packed.write_to(folder.path(), bytes), packed.how);
  };
  const std::string whole = gzipped(packed.bytes);
  expect_sound(read_packed(whole), packed.name);
  for (const size_t length : {size_t{2}, size_t{10}, whole.size() / 2, whole.size() - 1})
    expect_plain(test::refusal_of([&] { read_packed(whole.substr(0, length)); }));
  expect_plain(test::refusal_of([&] { read_packed(whole + "more"); }));
  expect_plain(test::refusal_of([&] { read_packed(gzipped("")); }));
}

// What fuzzing starts from, and what it found wrong in the past, also by the path.
TEST(SeedsOfFuzzing, AreReadOrRefused) {
  const std::filesystem::path seeds = MIEN_SOURCE_DIR "/tests/fuzz/seeds";
  const test::TemporaryFolder folder;
  ReadOptions how;
  how.frames_per_second = 30.0;
  for (const auto& [target, ending] : std::map<std::string, std::string>{{"bvh", ".bvh"},
                                                                         {"c3d", ".c3d"},
                                                                         {"fbx", ".fbx"},
                                                                         {"gltf", ".glb"},
                                                                         {"gzip", ".bvh.gz"},
                                                                         {"keypoints", ".json"},
                                                                         {"mvnx", ".mvnx"},
                                                                         {"numpy", ".npz"},
                                                                         {"point_table", ".csv"},
                                                                         {"trc", ".trc"}}) {
    int read = 0;
    for (const auto& seed : std::filesystem::directory_iterator(seeds / target)) {
      const std::filesystem::path copy = folder.path() / ("seed" + ending);
      std::filesystem::copy_file(seed.path(), copy,
                                 std::filesystem::copy_options::overwrite_existing);
      try {
        expect_sound(read_file(copy, how), seed.path().string());
        ++read;
      } catch (const Error& error) {
        EXPECT_EQ(printable(error.what()), error.what());
      }
    }
    EXPECT_GT(read, 0) << target;
  }
}

std::string test_name(const testing::TestParamInfo<SmallFile>& file) {
  std::string name = file.param.name;
  std::erase_if(name, [](unsigned char c) { return std::isalnum(c) == 0; });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Of, HostileFiles, testing::ValuesIn(small_files()), test_name);

}  // namespace
}  // namespace mien::motion
