#include "pipeline/production/archive/zip_archive.h"

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
  const std::string two_gib("\xff\xff\xff\x7f", 4);
  const std::size_t entry = bytes.find("PK\x01\x02");
  ASSERT_NE(entry, std::string::npos);
  bytes.replace(22, 4, two_gib);  // the size that the file's head tells
  bytes.replace(entry + 24, 4, two_gib);
  EXPECT_EQ(refusal_of(bytes),
            "some.zip: unpacks to more than 256 MiB; give an archive written by mien");
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

/// An archive of a file that it says to have 10 bytes, and of which 290 MB come out.
std::string lying_zip() {
  const std::string content = deflated_zeros(1'125'000);
  const std::string sizes =
      little_endian(static_cast<std::uint32_t>(content.size()), 4) + little_endian(10, 4);
  const std::string how = little_endian(20, 2) + little_endian(8, 2) + little_endian(8, 2);
  const std::string file = "PK\x03\x04" + how + std::string(16, '\0') + little_endian(1, 2) +
                           little_endian(0, 2) + "a" + content;
  const std::string directory = "PK\x01\x02" + little_endian(20, 2) + how + std::string(8, '\0') +
                                sizes + little_endian(1, 2) + std::string(16, '\0') + "a";
  return file + directory + "PK\x05\x06" + std::string(4, '\0') + little_endian(1, 2) +
         little_endian(1, 2) + little_endian(static_cast<std::uint32_t>(directory.size()), 4) +
         little_endian(static_cast<std::uint32_t>(file.size()), 4) + little_endian(0, 2);
}

TEST(ZipArchive, IsRefusedWhenMoreComesOutThanItTells) {
  EXPECT_EQ(refusal_of(lying_zip()),
            "some.zip: unpacks to more than 256 MiB; give an archive written by mien");
}

TEST(ZipArchive, IsNotUnpackedToFindWhatIsInItWithoutADirectory) {
  const std::string whole = lying_zip();
  EXPECT_NE(refusal_of(whole.substr(0, whole.find("PK\x01\x02"))), "accepted");
}

}  // namespace
}  // namespace mien::pipeline
