#include "pipeline/base/documents/utf8.h"

#include <string>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

TEST(Utf8, TakesEveryLengthOfCharacter) {
  EXPECT_FALSE(first_invalid_utf8("a\nß 速 \xF0\x9F\x9A\xB6"));
  EXPECT_FALSE(first_invalid_utf8(""));
  EXPECT_EQ(count_characters("aß速\xF0\x9F\x9A\xB6"), 4u);
}

TEST(Utf8, FindsTheFirstWrongByteByLineAndCharacter) {
  const auto position = first_invalid_utf8("a\n速x\xFFy");
  ASSERT_TRUE(position);
  EXPECT_EQ(position->line, 2);
  EXPECT_EQ(position->column, 3);
}

TEST(Utf8, RefusesWhatTheStandardForbids) {
  for (const std::string text : {"\x80", "\xC0\xAF", "\xC3", "\xE0\x80\xAF", "\xED\xA0\x80",
                                 "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80"}) {
    EXPECT_TRUE(first_invalid_utf8(text)) << text.size();
  }
  EXPECT_TRUE(first_invalid_utf8(std::string(1, '\0')));
}

}  // namespace
}  // namespace mien::pipeline
