#include "motion/text/file_contents.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "motion/error.h"
#include "motion/text/result_file.h"
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
    write_result(folder.path() / "a", bytes);
    EXPECT_EQ(bytes_of_file(folder.path() / "a", any_size).bytes, bytes);
    EXPECT_EQ(read_contents(folder.path() / "a"), bytes);
  }
}

TEST(FileContents, AreThoseOfFilesAloneAndNothingWaits) {
  const test::TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto problem = [](const std::filesystem::path& path) {
    const FileReading reading = bytes_of_file(path, any_size);
    EXPECT_FALSE(reading.bytes);
    EXPECT_EQ(reading.error, read_error(path, any_size));
    EXPECT_THROW(read_contents(path), Error);
    return reading.error;
  };
  EXPECT_EQ(problem(pipe), "is a pipe, not a file");
  EXPECT_EQ(problem("/dev/zero"), "is a device, not a file");
  EXPECT_EQ(problem(folder.path()), "is a folder, not a file");
  EXPECT_EQ(problem(folder.path() / "missing"), "there is no such file");
  EXPECT_EQ(problem(folder.path() / "missing/too"), "there is no such file");
}

TEST(FileContents, HaveALimitThatIsTold) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a";
  write_result(file, "abcd");
  EXPECT_EQ(bytes_of_file(file, 4).bytes, "abcd");
  EXPECT_EQ(bytes_of_file(file, 3).error, "has 4 bytes, more than the 3 bytes that can be read");
  std::filesystem::resize_file(file, std::uintmax_t{17} << 29);
  EXPECT_EQ(bytes_of_file(file, max_document_bytes).error,
            "has 8.5 GiB, more than the 64 MiB that can be read");
  EXPECT_THROW(read_contents(file), Error);
}

}  // namespace
}  // namespace mien::motion
