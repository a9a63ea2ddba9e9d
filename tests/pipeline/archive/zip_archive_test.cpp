#include "pipeline/archive/zip_archive.h"

#include <gtest/gtest.h>

#include "motion/error.h"

namespace mien::pipeline {
namespace {

const ZipFiles some_files = {
    {"a.txt", "one"}, {"empty", ""}, {"images/瞳.bin", std::string(70000, '\0')}};

TEST(ZipArchive, GivesBackWhatWasPutIn) {
  EXPECT_EQ(unzipped(zip_of(some_files), "some.zip"), some_files);
}

TEST(ZipArchive, IsTheSameBytesWithoutDates) {
  EXPECT_EQ(zip_of(some_files), zip_of(some_files));
  const std::string bytes = zip_of({{"a", "b"}});
  EXPECT_EQ(bytes.substr(0, 4), "PK\x03\x04");
  // Of 1 January 1980, 00:00, the earliest that the format knows.
  EXPECT_EQ(bytes.substr(10, 4), std::string("\0\0\x21\0", 4));
}

TEST(ZipArchive, IsRefusedWhenDamaged) {
  const std::string bytes = zip_of(some_files);
  std::string flipped = bytes;
  flipped[bytes.find("one")] = 'x';
  EXPECT_THROW(unzipped(flipped, "some.zip"), Error);
  EXPECT_THROW(unzipped(bytes.substr(0, bytes.size() / 2), "some.zip"), Error);
  EXPECT_THROW(unzipped("PK", "some.zip"), Error);
  EXPECT_THROW(unzipped(zip_of({{"../out", "x"}}), "some.zip"), Error);
}

}  // namespace
}  // namespace mien::pipeline
