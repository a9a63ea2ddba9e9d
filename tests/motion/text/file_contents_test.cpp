#include "motion/text/file_contents.h"

#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "motion/error.h"
#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

/// Every byte, over and over, more than is read at a time.
std::string many_bytes() {
  std::string bytes;
  for (int i = 0; i < 200000; ++i) bytes += static_cast<char>(i * 7 + i / 256);
  return bytes;
}

TEST(FileContents, AreTheBytesThatWereWritten) {
  const test::TemporaryFolder folder;
  for (const std::string& bytes : {std::string(), std::string("a"), many_bytes()}) {
    write_contents(folder.path() / "a", bytes);
    EXPECT_EQ(bytes_of_file(folder.path() / "a"), bytes);
    EXPECT_EQ(read_contents(folder.path() / "a"), bytes);
  }
}

TEST(FileContents, AreReadFromAPipeToItsEnd) {
  const test::TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << many_bytes(); });
  EXPECT_EQ(bytes_of_file(pipe), many_bytes());
  writer.join();
}

TEST(FileContents, AreNothingOfFoldersAndMissingFiles) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(bytes_of_file(folder.path()));
  EXPECT_FALSE(bytes_of_file(folder.path() / "missing"));
  EXPECT_THROW(read_contents(folder.path()), Error);
  EXPECT_THROW(read_contents(folder.path() / "missing"), Error);
}

}  // namespace
}  // namespace mien::motion
