#include "motion/text/result_file.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

namespace fs = std::filesystem;

std::string bytes_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::string failure_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const WriteFailure& failure) {
    return failure.what();
  }
  return "";
}

/// No file of this process may grow beyond so many bytes, as on a disk that is full.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallFiles() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

class ResultFiles : public testing::Test {
 protected:
  test::TemporaryFolder temporary;
  fs::path folder = temporary.path();
  fs::path file = folder / "walk.bvh";
};

TEST_F(ResultFiles, ThatCannotBeWrittenLeaveTheOlderOneAndNothingElse) {
  write_result(file, "older");
  std::string told;
  {
    const SmallFiles limit(1000);
    told = failure_of([&] { write_result(file, std::string(5000, 'x')); });
  }
  EXPECT_EQ(told, file.string() + ": cannot be written (File too large)");
  EXPECT_EQ(bytes_in(file), "older");
  EXPECT_EQ(names_in(folder), std::vector<std::string>{"walk.bvh"});
}

TEST_F(ResultFiles, AreThereOnlyWhenTheyArePublished) {
  write_result(file, "older");
  {
    const ResultFile abandoned(file);
    EXPECT_EQ(abandoned.draft().parent_path(), folder);
    EXPECT_TRUE(abandoned.draft().string().ends_with("walk.bvh"));
    std::ofstream(abandoned.draft()) << "half";
    EXPECT_EQ(abandoned.with_target_name(abandoned.draft().string() + ": no"),
              file.string() + ": no");
    EXPECT_EQ(bytes_in(file), "older");
  }
  EXPECT_EQ(names_in(folder), std::vector<std::string>{"walk.bvh"});
  ResultFile whole(file);
  std::ofstream(whole.draft()) << "newer";
  whole.publish();
  EXPECT_EQ(bytes_in(file), "newer");
  EXPECT_EQ(names_in(folder), std::vector<std::string>{"walk.bvh"});
}

TEST_F(ResultFiles, OfAProgramThatEndsAtOnceAreRemoved) {
  const ResultFile one(file), other(folder / "other.png");
  EXPECT_EQ(names_in(folder).size(), 2u);
  remove_unfinished_results();
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(ResultFiles, KeepPermissionsAndLinks) {
  write_result(file, "older");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("walk.bvh", folder / "link.bvh");
  write_result(folder / "link.bvh", "newer");
  EXPECT_TRUE(fs::is_symlink(folder / "link.bvh"));
  EXPECT_EQ(bytes_in(file), "newer");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(ResultFiles, OfTheLongestNamesCanBeWritten) {
  const fs::path longest = folder / (std::string(250, 'n') + ".bvh");
  write_result(longest, "bytes");
  EXPECT_EQ(bytes_in(longest), "bytes");
}

TEST_F(ResultFiles, TellTheSystemsOwnReason) {
  EXPECT_EQ(
      failure_of([] { write_result("/dev/full", "bytes"); }),
      "/dev/full: cannot be written (No space left on device); free some space, and try again");
  const fs::path nowhere = folder / "missing/walk.bvh";
  EXPECT_EQ(failure_of([&] { write_result(nowhere, "bytes"); }),
            nowhere.string() +
                ": cannot be written (No such file or directory); create its folder first");
  EXPECT_EQ(failure_of([&] { write_result(folder, "bytes"); }),
            folder.string() + ": cannot be written (Is a directory); name a file");
}

TEST_F(ResultFiles, DoNotTakeThePlaceOfADevice) {
  const fs::path null = folder / "null";
  fs::create_symlink("/dev/null", null);
  write_result(null, "bytes");
  struct stat status {};
  ASSERT_EQ(::stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
  EXPECT_EQ(names_in(folder), std::vector<std::string>{"null"});
}

}  // namespace
}  // namespace mien::motion
