#include "motion/text/compressed_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "motion/error.h"
#include "motion/formats/bvh/bvh.h"
#include "motion/refusal.h"
#include "motion/text/result_file.h"
#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

/// The output of deflate for a text; `whole`: of a gzip member from header to trailer, else of a
/// part of one that can be repeated.
std::string deflated(std::string_view text, bool whole) {
  z_stream stream{};
  constexpr int window = 15;
  EXPECT_EQ(
      deflateInit2(&stream, 6, Z_DEFLATED, whole ? window + 16 : -window, 8, Z_DEFAULT_STRATEGY),
      Z_OK);
  std::string bytes(deflateBound(&stream, text.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_GE(deflate(&stream, whole ? Z_FINISH : Z_FULL_FLUSH), Z_OK);
  EXPECT_GT(stream.avail_out, 0u);
  bytes.erase(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

std::string gzip(std::string_view text) { return deflated(text, true); }

std::string repeated(const std::string& part, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += part;
  return all;
}

/// Hardly compressible, longer than is inflated at a time.
std::string long_text() {
  std::string text;
  unsigned state = 1;
  while (text.size() < 1'000'000)
    text += std::to_string((state = state * 1664525u + 1013904223u) >> 8) + " ";
  return text;
}

const std::string bvh =
    "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 1 Xrotation\n}\nMOTION\nFrames: 1\n"
    "Frame Time: 0.01\n30\n";

TEST(CompressedFile, HoldsTheBytesThatWereCompressed) {
  for (const std::string& text : {std::string(), std::string("a"), long_text()})
    EXPECT_EQ(inflated(gzip(text), "a.gz"), text);
}

TEST(CompressedFile, MayHaveSeveralMembersAndZerosAfterThem) {
  EXPECT_EQ(inflated(gzip("one ") + gzip("") + gzip("two"), "a.gz"), "one two");
  EXPECT_EQ(inflated(gzip("one") + std::string(512, '\0'), "a.gz"), "one");
}

TEST(CompressedFile, IsNotReadWhenTruncatedOrDamaged) {
  const std::string whole = gzip("Frames: 1\nFrame Time: 0.01\n");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string said =
        test::refusal_of([&] { inflated(std::string_view(whole).substr(0, length), "a.gz"); });
    EXPECT_NE(said.find("a.gz: is truncated"), std::string::npos) << said;
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string other = whole;
    other[i] = static_cast<char>(other[i] ^ 0x10);
    try {
      // The header's time and system may be anything.
      EXPECT_EQ(inflated(other, "a.gz"), "Frames: 1\nFrame Time: 0.01\n") << i;
    } catch (const Error&) {
    }
  }
  std::string wrong_sum = whole;
  wrong_sum[whole.size() - 6] ^= 1;
  EXPECT_NE(test::refusal_of([&] { inflated(wrong_sum, "a.gz"); }).find("is damaged"),
            std::string::npos);
  EXPECT_NE(test::refusal_of([&] { inflated(whole + "rest", "a.gz"); }).find("has other bytes"),
            std::string::npos);
}

TEST(CompressedFile, MadeToExhaustTheMemoryIsRefused) {
  const std::string zeros(std::size_t{16} << 20, '\0');
  const std::string bomb = gzip("").substr(0, 10) + repeated(deflated(zeros, false), 64);  // 1 GiB
  ASSERT_LT(bomb.size(), std::size_t{2} << 20);
  const std::string said = test::refusal_of([&] { inflated(bomb, "a.bvh.gz"); });
  EXPECT_NE(said.find("is compressed and has more than"), std::string::npos) << said;
  // Several members add up.
  const std::string members = repeated(gzip(zeros), 64);
  EXPECT_EQ(test::refusal_of([&] { inflated(members, "a.bvh.gz"); }).substr(0, 50),
            said.substr(0, 50));
  EXPECT_EQ(largest_inflated(1000, max_recording_bytes), std::uintmax_t{8} << 20);
  EXPECT_EQ(largest_inflated(1'000'000, max_recording_bytes), 50'000'000u);
  EXPECT_EQ(largest_inflated(any_size / 2, max_recording_bytes), max_recording_bytes);
}

TEST(CompressedFile, OfEmptyMembersIsReadQuickly) {
  EXPECT_EQ(inflated(repeated(gzip(""), 50'000), "a.gz"), "");
}

TEST(CompressedFile, IsCalledByTheNameOfWhatItHolds) {
  EXPECT_EQ(without_compression("motions/walk.bvh.gz"), "motions/walk.bvh");
  EXPECT_EQ(without_compression("walk.BVH.GZ"), "walk.BVH");
  EXPECT_EQ(without_compression("walk.bvh"), "walk.bvh");
  EXPECT_EQ(without_compression("walk.gz"), "walk");
  EXPECT_EQ(without_compression(".gz"), ".gz");
  EXPECT_EQ(recording_name("motions/walk.2.bvh.gz"), "walk.2");
}

TEST(CompressedFile, OfAMotionIsReadAsTheMotion) {
  const test::TemporaryFolder folder;
  write_result(folder.path() / "turn.bvh.gz", gzip(bvh));
  write_result(folder.path() / "plain.bvh.gz", bvh);  // as browsers save what they have unpacked
  write_result(folder.path() / "turn.bvh", gzip(bvh));
  const Recording recording = read_bvh(folder.path() / "turn.bvh.gz");
  EXPECT_EQ(recording.name, "turn");
  EXPECT_EQ(recording.frame_count(), 1);
  EXPECT_EQ(read_bvh(folder.path() / "plain.bvh.gz").name, "plain");
  EXPECT_NE(test::refusal_of([&] {
              read_bvh(folder.path() / "turn.bvh");
            }).find("is compressed (gzip); rename it to turn.bvh.gz"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
