#include "pipeline/archive/zip_archive.h"

#include <cstdint>

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

std::string refusal_of(const std::string& bytes) {
  try {
    unzipped(bytes, "some.zip");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ZipArchive, IsRefusedByItsOwnWordsBeforeAnythingIsUnpacked) {
  std::string bytes = zip_of({{"a", "b"}});
  const std::size_t entry = bytes.find("PK\x01\x02");
  ASSERT_NE(entry, std::string::npos);
  bytes.replace(entry + 24, 4, std::string("\xff\xff\xff\x7f", 4));  // its size: 2 GiB
  EXPECT_EQ(refusal_of(bytes),
            "some.zip: unpacks to more than 256 MiB; give the archive that mien wrote");
}

/// Zeros as deflate has them (RFC 1951): one, then copies of 258 of them in 13 bits each.
std::string deflated_zeros(int copies) {
  std::string bytes;
  int bit = 0;
  const auto put = [&](unsigned value, int count) {
    for (int i = count - 1; i >= 0; --i, ++bit) {
      if (bit % 8 == 0) bytes += '\0';
      bytes.back() = static_cast<char>(bytes.back() | ((value >> i & 1u) << (bit % 8)));
    }
  };
  put(0b1'10, 3);  // the last block, in fixed codes
  put(0b00110000, 8);
  for (int i = 0; i < copies; ++i) put(0b11000101'00000, 13);
  put(0b0000000, 7);
  return bytes;
}

std::string little_endian(std::uint32_t value, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 255u);
  return bytes;
}

TEST(ZipArchive, IsRefusedWhenMoreComesOutThanMay) {
  // A stream that does not tell its sizes beforehand, of 290 MB.
  const std::string bytes = "PK\x03\x04" + little_endian(20, 2) + little_endian(8, 2) +
                            little_endian(8, 2) + std::string(16, '\0') + little_endian(1, 2) +
                            little_endian(0, 2) + "a" + deflated_zeros(1'125'000);
  EXPECT_EQ(refusal_of(bytes),
            "some.zip: unpacks to more than 256 MiB; give the archive that mien wrote");
}

}  // namespace
}  // namespace mien::pipeline
