#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "motion/body_mapping.h"
#include "motion/motion_file.h"

#include "injected_faults.h"
#include "real_data.h"

// What the lint says of motion capture as it is.

namespace mien::motion {
namespace {

using namespace mien::test;
namespace fs = std::filesystem;

class RealLint : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = real_data();
    if (!folder) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
    mocap = *folder / "mocap";
  }

  std::vector<fs::path> files(const std::string& folder, const std::string& part) const {
    std::vector<fs::path> result;
    for (const auto& entry : fs::directory_iterator(mocap / folder)) {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() == ".bvh" && name.find(part) != std::string::npos) {
        result.push_back(entry.path());
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  fs::path mocap;
};

TEST_F(RealLint, CapturedWalksHaveNoErrors) {
  const std::vector<fs::path> walks = files("bandai-namco-1", "_walk_");
  EXPECT_EQ(walks.size(), 30U);
  for (const fs::path& file : walks) {
    const Recording recording = read_motion(file);
    EXPECT_FALSE(has_errors(lint(recording))) << file << "\n" << all_of(lint(recording));
    const Clip clip = to_body(recording);
    EXPECT_FALSE(has_errors(lint(clip))) << file << "\n" << all_of(lint(clip));
    EXPECT_FALSE(has_errors(lint(clip, {}, &clip))) << file << "\n"
                                                    << all_of(lint(clip, {}, &clip));
  }
}

}  // namespace
}  // namespace mien::motion
