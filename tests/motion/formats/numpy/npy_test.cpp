#include "motion/formats/numpy/npy.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "motion/formats/numpy/numpy_files.h"
#include "motion/refusal.h"

namespace mien::motion {
namespace {

using mien::test::bytes_of;
using mien::test::npy_file;
using mien::test::refusal_of;

std::vector<double> numbers_in(const std::string& file) {
  return numbers_of(parse_npy(file, "a.npy"), {"a.npy"});
}

std::string refusal_of_file(const std::string& file) {
  return refusal_of([&] { numbers_in(file); });
}

template <typename Number>
void expect_read(const std::string& type) {
  const std::vector<Number> numbers = {Number(0), Number(1),   Number(2),
                                       Number(3), Number(100), Number(1) / Number(3)};
  const std::vector<double> expected(numbers.begin(), numbers.end());
  for (const bool big : {false, true}) {
    const std::string descr = std::string("'") + (big ? '>' : '<') + type + "'";
    for (const int version : {1, 2, 3}) {
      const std::string file = npy_file(descr, "(2, 3)", bytes_of(numbers, big), false, version);
      const NpyArray array = parse_npy(file, "a.npy");
      EXPECT_EQ(array.shape, (std::vector<std::size_t>{2, 3}));
      EXPECT_EQ(numbers_of(array, {}), expected) << descr << " version " << version;
    }
  }
}

TEST(Npy, NumbersOfAllTypesAreReadInBothByteOrders) {
  expect_read<double>("f8");
  expect_read<float>("f4");
  expect_read<std::int64_t>("i8");
  expect_read<std::int32_t>("i4");
  expect_read<std::int16_t>("i2");
  expect_read<std::uint64_t>("u8");
  expect_read<std::uint32_t>("u4");
  expect_read<std::uint16_t>("u2");
  EXPECT_EQ(numbers_in(npy_file("'|i1'", "(2,)", "\x01\xff")), (std::vector<double>{1, -1}));
  EXPECT_EQ(numbers_in(npy_file("'|u1'", "(2,)", "\x01\xff")), (std::vector<double>{1, 255}));
  EXPECT_EQ(numbers_in(npy_file("'|b1'", "(2,)", std::string("\x01\x00", 2))),
            (std::vector<double>{1, 0}));
}

// IEEE 754-2008, binary16: 1, −2, the largest, the least, infinity, not a number.
TEST(Npy, HalfNumbersAreThoseOfTheStandard) {
  const std::vector<std::uint16_t> bits = {0x3C00, 0xC000, 0x7BFF, 0x0001, 0x7C00, 0x7E00, 0x3555};
  const std::vector<double> numbers = numbers_in(npy_file("'<f2'", "(7,)", bytes_of(bits)));
  EXPECT_EQ(numbers[0], 1.0);
  EXPECT_EQ(numbers[1], -2.0);
  EXPECT_EQ(numbers[2], 65504.0);
  EXPECT_EQ(numbers[3], std::ldexp(1.0, -24));
  EXPECT_TRUE(std::isinf(numbers[4]));
  EXPECT_TRUE(std::isnan(numbers[5]));
  EXPECT_NEAR(numbers[6], 1.0 / 3.0, 1e-4);
}

TEST(Npy, FortranOrderIsTurnedIntoTheUsualOne) {
  // The element [i, j, k] is 100 i + 10 j + k; the first index varies fastest in the file.
  std::vector<double> file_order;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 2; ++i) file_order.push_back(100 * i + 10 * j + k);
  const std::vector<double> numbers =
      numbers_in(npy_file("'<f8'", "(2, 3, 4)", bytes_of(file_order), true));
  std::size_t at = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 4; ++k) EXPECT_EQ(numbers[at++], 100 * i + 10 * j + k);
}

TEST(Npy, HeadersMayBeWrittenInOtherWays) {
  const std::string elements = bytes_of(std::vector<float>{7});
  for (const char* dictionary : {R"({"shape":(1L,),"fortran_order":False,"descr":"<f4"})",
                                 "{ 'fortran_order' : True ,\n'shape' : ( ) , 'descr' : '<f4' }",
                                 "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 1)}"}) {
    const std::string text = dictionary;
    std::string file("\x93NUMPY\x01\x00", 8);
    file += static_cast<char>(text.size());
    file += '\0';
    EXPECT_EQ(numbers_in(file + text + elements), std::vector<double>{7}) << text;
  }
}

TEST(Npy, TextIsReadAsUtf8) {
  const std::vector<char32_t> letters = {U'歩', U'く', 0, U'é', U'𝄞', U'x'};
  const auto texts = [&](const std::string& file) { return texts_of(parse_npy(file, "a"), {}); };
  const std::vector<std::string> expected = {"歩く", "é𝄞x"};
  EXPECT_EQ(texts(npy_file("'<U3'", "(2,)", bytes_of(letters))), expected);
  EXPECT_EQ(texts(npy_file("'>U3'", "(2,)", bytes_of(letters, true))), expected);
  EXPECT_EQ(texts(npy_file("'|S4'", "()", std::string("male", 4))),
            std::vector<std::string>{"male"});
}

TEST(Npy, WhatIsWrittenIsReadAgain) {
  std::mt19937_64 random(38);
  std::vector<double> numbers;
  for (int i = 0; i < 24; ++i) numbers.push_back(std::ldexp(static_cast<double>(random()), -60));
  const NpyArray array = parse_npy(to_npy(array_of(numbers, {2, 3, 4})), "a");
  EXPECT_EQ(numbers_of(array, {}), numbers);
  EXPECT_EQ(array.shape, (std::vector<std::size_t>{2, 3, 4}));
  EXPECT_EQ(texts_of(parse_npy(to_npy(array_of_text("neutral")), "a"), {}).front(), "neutral");
  const std::string file = to_npy(array_of_floats(numbers, {24}));
  EXPECT_EQ(file.substr(10, 59), "{'descr': '<f4', 'fortran_order': False, 'shape': (24,), } ");
  EXPECT_EQ((file.size() - 24 * 4) % 64, 0u);
}

TEST(Npy, ObjectsAreRefusedInOneSentenceAndNeverUnpickled) {
  const std::string refusal = refusal_of_file(npy_file("'|O'", "()", "\x80\x03pickle"));
  EXPECT_EQ(refusal,
            "a.npy: the array holds Python objects, which are never unpickled; save its parts as "
            "arrays of numbers with numpy.savez(file, poses=…, trans=…)");
}

TEST(Npy, OtherKindsAreRefusedByName) {
  for (const auto& [descr, words] : std::vector<std::pair<std::string, std::string>>{
           {"'<c16'", "holds complex numbers"},
           {"'<M8[ns]'", "holds times"},
           {"[('a', '<f4'), ('b', '<i4', (2,))]", "holds records of several fields"},
           {"'<f16'", "holds numbers of 16 bytes"},
           {"'<U4'", "holds text"},
           {"'<q8'", "the type \"<q8\" is unknown"},
           {"''", "is unknown"},
           {"'<f'", "is unknown"},
           {"'<f8x'", "is unknown"}}) {
    const std::string refusal = refusal_of_file(npy_file(descr, "(1,)", std::string(16, '\0')));
    EXPECT_NE(refusal.find(words), std::string::npos) << refusal;
  }
}

TEST(Npy, FaultsAreRefusedWithTheByte) {
  const std::string whole = npy_file("'<f4'", "(3,)", std::string(12, '\0'));
  EXPECT_NE(
      refusal_of_file(whole.substr(0, whole.size() - 1)).find("is cut short: 11 bytes follow"),
      std::string::npos);
  EXPECT_NE(refusal_of_file(whole + "x").find("is followed by other bytes"), std::string::npos);
  EXPECT_NE(refusal_of_file("BVH").find("is not a NumPy array"), std::string::npos);
  for (const auto& [shape, words] : std::vector<std::pair<std::string, std::string>>{
           {"(3)", "at byte 62: a comma is missing"},
           {"(-3,)", "a length is missing"},
           {"(99999999999999999999,)", "a length is missing or too large"},
           {"(4294967296, 4294967296, 4294967296)", "as many as its shape needs"},
           {"(9223372036854775807,)", "as many as its shape needs"},
           {"(3,), 'more': 1", "the entry \"more\" is unknown"},
           {"(3,), 'shape': (3,)", "an entry occurs twice"},
           {"3", "'(' is missing"},
           {"(3,", "is missing"}}) {
    const std::string refusal = refusal_of_file(npy_file("'<f4'", shape, std::string(12, '\0')));
    EXPECT_NE(refusal.find(words), std::string::npos) << shape << ": " << refusal;
  }
  std::string fourth = whole;
  fourth[6] = 4;
  EXPECT_NE(refusal_of_file(fourth).find("is of version 4.0"), std::string::npos);
}

TEST(Npy, HostileTextIsQuotedInParts) {
  const std::string refusal =
      refusal_of_file(npy_file("'" + std::string(20'000, 'x') + "'", "()", ""));
  EXPECT_LT(refusal.size(), 400u);
}

TEST(Npy, EveryTruncationAndManyMutationsAreReadOrRefused) {
  const std::string whole =
      npy_file("'<f4'", "(2, 3)", bytes_of(std::vector<float>{1, 2, 3, 4, 5, 6}), true);
  const auto reads = [](const std::string& file) {
    try {
      numbers_in(file);
      return true;
    } catch (const Error&) {
      return false;
    }
  };
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(reads(whole.substr(0, size)));
  std::mt19937 random(1);
  int read = 0;
  for (int i = 0; i < 200; ++i) {
    std::string changed = whole;
    changed[random() % whole.size()] = static_cast<char>(random());
    read += reads(changed) ? 1 : 0;
  }
  EXPECT_GT(read, 0);
  EXPECT_LT(read, 200);
}

}  // namespace
}  // namespace mien::motion
