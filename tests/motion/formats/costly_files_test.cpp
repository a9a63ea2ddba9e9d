// Small files that ask for much: each is read or refused within two seconds of processor time and
// 512 MB of memory, in a process of its own that can have no more.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "motion/error.h"
#include "motion/formats/gzip_text.h"
#include "motion/formats/motion_file.h"
#include "motion/formats/small_files.h"
#include "pipeline/temporary_folder.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MIEN_IS_SANITIZED 1
#endif

namespace mien::motion {
namespace {

using test::FbxSceneBuilder;
using test::SmallFile;

constexpr rlim_t most_bytes = rlim_t{512} << 20;
constexpr rlim_t most_seconds = 2;

/// How a process ended that reads a file.
enum class End { read, refused, failed };

End end_of(const std::filesystem::path& file, const ReadOptions& how) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit memory{most_bytes, most_bytes};
    const rlimit time{most_seconds, most_seconds};
    setrlimit(RLIMIT_DATA, &memory);
    setrlimit(RLIMIT_CPU, &time);
    int code = 2;
    try {
      read_file(file, how);
      code = 0;
    } catch (const Error&) {
      code = 1;
    } catch (...) {
      code = 3;
    }
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) > 1) return End::failed;
  return WEXITSTATUS(status) == 0 ? End::read : End::refused;
}

class CostlyFiles : public testing::Test {
 protected:
  void SetUp() override {
#ifdef MIEN_IS_SANITIZED
    GTEST_SKIP() << "sanitizers need more memory";
#endif
  }

  void expect_cheap(const SmallFile& file, const std::string& bytes, bool is_refused) {
    const std::filesystem::path path = file.write_to(folder.path(), bytes);
    const End end = end_of(path, file.how);
    EXPECT_NE(end, End::failed) << file.name;
    EXPECT_TRUE(end == End::refused || !is_refused) << file.name << " is read";
  }

  test::TemporaryFolder folder;
};

TEST_F(CostlyFiles, OfABillionFramesCostLittle) {
  for (const SmallFile& file : test::small_files())
    if (!file.endless.empty()) expect_cheap(file, file.endless, false);
}

TEST_F(CostlyFiles, ThatInflateToGigabytesAreRefused) {
  const std::string part = test::gzipped(std::string(std::size_t{4} << 20, ' '));
  std::string bomb;
  for (int i = 0; i < 512; ++i) bomb += part;
  for (SmallFile file : test::small_files()) {
    file.name += ".gz";
    expect_cheap(file, test::gzipped(file.bytes) + bomb, true);
  }
}

std::string repeated(std::string text, const std::string& part, std::size_t megabytes) {
  while (text.size() < megabytes << 20) text += part;
  return text;
}

// Long recordings of next to nothing, of which each byte takes many in memory.
TEST_F(CostlyFiles, ThatInflateToLongRecordingsAreRefused) {
  for (SmallFile file : test::small_files()) {
    std::string part;
    if (file.name == "walk.bvh") part = "0 0 0 0 0 0 0 0 0\n";
    if (file.name == "walk.trc") part = "3\t\t\n";
    if (file.name == "walk.csv") part = "2,,,,,,,\n";
    if (file.name == "walk.json") part = "[0,0,0],";
    if (part.empty()) continue;
    file.name += ".gz";
    expect_cheap(file, test::gzipped(repeated(file.bytes, part, 60)), true);
  }
}

TEST_F(CostlyFiles, OfMillionsOfPointsAreRefused) {
  const std::string head =
      "PathFileType\t4\t(X/Y/Z)\ta.trc\nDataRate\tNumMarkers\n100\t2\nFrame#\tTime\t";
  expect_cheap({"walk.trc", {}}, repeated(head, "a\t\t\t", 16), true);
  expect_cheap({"walk.csv", {}}, repeated("frame,", "a,", 16), true);
}

/// An array of zeros, which deflates to a thousandth.
std::string zeros(const std::string& shape, std::size_t megabytes) {
  return test::npy_file("'<f8'", shape, std::string(megabytes << 20, '\0'));
}

std::string zip_of_zeros(const std::string& name, const std::string& shape,
                         std::int64_t stated = -1) {
  return test::npz_file(
      {{name, zeros(shape, 72), true, 0, stated}, {"mocap_framerate", test::npy_f8("()", {120})}});
}

TEST_F(CostlyFiles, AreZipBombs) {
  expect_cheap({"bomb.npz", {}}, zip_of_zeros("poses", "(131072, 72)"), true);
  expect_cheap({"bomb.npz", {}}, zip_of_zeros("joints", "(131072, 24, 3)"), true);
  // What it states is not what is in it.
  for (const std::int64_t stated : {std::int64_t{800}, std::int64_t{4'000'000'000}})
    expect_cheap({"bomb.npz", {}}, zip_of_zeros("poses", "(1, 72)", stated), true);
}

std::string fbx_of_zeros() {
  FbxSceneBuilder arm;
  const std::int64_t upper = arm.model("upper", "LimbNode", 0, {0, 0, 0});
  arm.model("fore", "LimbNode", upper, {0, 200, 0});
  FbxSceneBuilder::Keys keys;
  keys.seconds.assign(std::size_t{6} << 20, 0.0);
  keys.values.assign(std::size_t{6} << 20, 0.0f);
  arm.curve(arm.take("t").second, upper, "Lcl Rotation", "d|Z", keys);
  return arm.binary(7400, true);
}

TEST_F(CostlyFiles, AreFbxOfArraysOfZeros) { expect_cheap({"bomb.fbx", {}}, fbx_of_zeros(), true); }

}  // namespace
}  // namespace mien::motion
