#include "motion/formats/numpy/npz.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/formats/numpy/numpy_files.h"
#include "motion/refusal.h"

#include "real_data.h"

namespace mien::motion {
namespace {

using mien::test::npy_f8;
using mien::test::npy_file;
using mien::test::npz_file;
using mien::test::refusal_of;
using mien::test::ZipMember;

std::string refusal_of_npz(const std::string& file, const WantedArrays& wanted = std::nullopt,
                           std::uintmax_t most = max_recording_bytes) {
  return refusal_of([&] { parse_npz(file, "a.npz", wanted, most); });
}

bool contains(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

TEST(Npz, StoredAndDeflatedArraysAreRead) {
  const std::string file =
      npz_file({{"poses", npy_f8("(2,)", {1, 2})}, {"trans", npy_f8("(3,)", {3, 4, 5}), true}});
  const Npz npz = parse_npz(file, "a.npz");
  ASSERT_EQ(npz.arrays.size(), 2u);
  EXPECT_EQ(numbers_of(*find_array(npz, "poses"), {}), (std::vector<double>{1, 2}));
  EXPECT_EQ(numbers_of(*find_array(npz, "trans"), {}), (std::vector<double>{3, 4, 5}));
  EXPECT_EQ(find_array(npz, "betas"), nullptr);
}

TEST(Npz, WhatIsNotWantedIsOnlyOutlined) {
  const std::string file = npz_file(
      {{"a", npy_f8("(2,)", {1, 2})}, {"b", npy_f8("(1, 3)", {3, 4, 5}), true}, {"c", "no array"}});
  EXPECT_TRUE(contains(refusal_of_npz(file), "the array \"c\" is not a NumPy array"));
  const Npz npz =
      parse_npz(npz_file({{"a", npy_f8("(2,)", {1, 2})}, {"b", npy_f8("(1, 3)", {3, 4, 5}), true}}),
                "a.npz", WantedArrays({"a"}));
  EXPECT_TRUE(npz.arrays[0].is_present);
  EXPECT_FALSE(npz.arrays[1].is_present);
  EXPECT_EQ(npz.arrays[1].shape, (std::vector<std::size_t>{1, 3}));
  EXPECT_TRUE(npz.arrays[1].bytes.empty());
}

TEST(Npz, ObjectsAreNamedAndLeftAlone) {
  const Npz npz =
      parse_npz(npz_file({{"labels", npy_file("'|O'", "(2,)", "\x80pickle")}}), "a.npz");
  EXPECT_EQ(object_arrays(npz), std::vector<std::string>{"labels"});
  EXPECT_TRUE(
      contains(refusal_of([&] { numbers_of(npz.arrays[0], {"a.npz"}); }),
               "a.npz: the array \"labels\" holds Python objects, which are never unpickled"));
}

TEST(Npz, ObjectsOfARealFileAreNamed) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "no real data";
  const Npz npz = read_npz(*data / "recordings" / "npz" / "objects_romp.npz");
  EXPECT_EQ(object_arrays(npz), std::vector<std::string>{"results"});
}

TEST(Npz, WhatIsWrittenIsReadAgainAndAlwaysTheSame) {
  std::vector<double> numbers(3000);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<double>(i % 7);
  const std::vector<NamedArray> arrays = {{"poses", array_of(numbers, {1000, 3})},
                                          {"gender", array_of_text("neutral")}};
  for (const NpzCompression compression : {NpzCompression::stored, NpzCompression::deflated}) {
    const std::string file = to_npz(arrays, compression);
    EXPECT_EQ(file, to_npz(arrays, compression));
    const Npz npz = parse_npz(file, "a.npz");
    EXPECT_EQ(numbers_of(*find_array(npz, "poses"), {}), numbers);
    EXPECT_EQ(texts_of(*find_array(npz, "gender"), {}).front(), "neutral");
  }
  EXPECT_LT(to_npz(arrays, NpzCompression::deflated).size(), to_npz(arrays).size() / 10);
  // Two writers that do not know each other.
  EXPECT_EQ(
      to_npz(arrays).size(),
      npz_file({{"poses", to_npy(arrays[0].array)}, {"gender", to_npy(arrays[1].array)}}).size());
}

TEST(Npz, ArchivesThatUnpackToTooMuchAreRefused) {
  const std::string zeros = npy_f8("(100000,)", std::vector<double>(100'000));
  const std::string file = npz_file({{"a", zeros, true}, {"b", zeros, true}});
  EXPECT_LT(file.size(), 10'000u);
  parse_npz(file, "a.npz", std::nullopt, 1'700'000);
  EXPECT_TRUE(
      contains(refusal_of_npz(file, std::nullopt, 1'500'000), "unpack to more than the 1 MiB"));
  // Stated sizes are refused before anything is unpacked, and do not hide true ones.
  const std::string liar = npz_file({{"a", zeros, true, 0, 3'500'000'000}});
  EXPECT_TRUE(contains(refusal_of_npz(liar), "unpack to more than the 8 MiB"));
  const std::string modest = npz_file({{"a", zeros, true, 0, 10}});
  EXPECT_TRUE(contains(refusal_of_npz(modest, std::nullopt, 1000), "a.npz: "));
}

TEST(Npz, ManyMembersAreRefused) {
  std::vector<ZipMember> members(most_npz_members + 1, {"x", ""});
  EXPECT_TRUE(contains(refusal_of_npz(mien::test::zip_file(members)), "more than 4096 files"));
}

TEST(Npz, EncryptedRepeatedAndMissingArraysAreRefused) {
  const std::string array = npy_f8("(1,)", {1});
  EXPECT_TRUE(contains(refusal_of_npz(npz_file({{"poses", array, false, 1}})),
                       "the array \"poses\" is encrypted"));
  EXPECT_TRUE(contains(refusal_of_npz(npz_file({{"poses", array}, {"poses", array}})),
                       "two arrays are named \"poses\""));
  EXPECT_TRUE(
      contains(refusal_of_npz(mien::test::zip_file({{"a.txt", "x"}})), "without NumPy arrays"));
  EXPECT_TRUE(contains(refusal_of_npz(mien::test::zip_file({})), "a.npz: "));
  EXPECT_TRUE(contains(refusal_of_npz(array), "is a single NumPy array"));
}

TEST(Npz, ADamagedArrayIsFound) {
  std::string file = npz_file({{"poses", npy_f8("(2,)", {1, 2})}});
  file[file.find("poses.npy") + 9 + 140] ^= 1;  // in the elements; the checksum differs
  EXPECT_TRUE(contains(refusal_of_npz(file), "the array \"poses\" cannot be unpacked"));
}

// Of a long array only the beginning is read twice.
TEST(Npz, DamageAtTheEndOfALongArrayIsFound) {
  std::string file = npz_file({{"poses", npy_f8("(20000,)", std::vector<double>(20'000, 0.5))}});
  file[file.find("PK\x01\x02") - 100] ^= 1;
  EXPECT_TRUE(contains(refusal_of_npz(file), "the array \"poses\" cannot be unpacked"));
}

TEST(Npz, ADeflatedArrayMustHaveItsStatedSizeAndChecksum) {
  std::vector<double> numbers(3000);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<double>(i % 11);
  const std::string array = npy_f8("(3000,)", numbers);
  const auto size = static_cast<std::int64_t>(array.size());
  for (const std::int64_t stated : {size - 1, size + 1, size + 100'000}) {
    const std::string file = npz_file({{"poses", array, true, 0, stated}});
    EXPECT_TRUE(contains(refusal_of_npz(file), "not of the stated length")) << stated;
  }
  std::string file = npz_file({{"poses", array, true}});
  EXPECT_EQ(numbers_of(parse_npz(file, "a.npz").arrays.front(), {}), numbers);
  file[file.rfind("PK\x01\x02") + 16] ^= 1;  // the checksum in the directory
  EXPECT_TRUE(contains(refusal_of_npz(file), "checksum does not match"));
}

TEST(Npz, EveryTruncationAndManyMutationsAreReadOrRefused) {
  const std::string whole =
      npz_file({{"a", npy_f8("(2,)", {1, 2})}, {"b", npy_f8("(1, 3)", {3, 4, 5}), true}});
  const auto reads = [](const std::string& file) {
    try {
      for (const NpyArray& array : parse_npz(file, "a.npz").arrays) numbers_of(array, {});
      return true;
    } catch (const Error&) {
      return false;
    }
  };
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(reads(whole.substr(0, size))) << size;
  std::mt19937 random(2);
  for (int i = 0; i < 400; ++i) {
    std::string changed = whole;
    changed[random() % whole.size()] = static_cast<char>(random());
    reads(changed);
  }
}

}  // namespace
}  // namespace mien::motion
