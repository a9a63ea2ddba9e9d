#include "motion/text/excerpt.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

std::size_t characters_in(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

/// Any bytes, with those that matter more often than others.
std::string random_text(std::mt19937_64& random, std::size_t longest) {
  const std::vector<std::string> pieces = {"a",    "é",  "歩",   "\U0001F6B6",   "\x1b[2J", "\n",
                                           "\r",   "\\", "\x7f", "\xC2\x9B",     "\u202E",  "\xff",
                                           "\xe6", "\"", "\t",   "\xED\xA0\x80", "\xC0\x80"};
  std::string text;
  const std::size_t count = random() % longest;
  for (std::size_t i = 0; i < count; ++i) text += pieces[random() % pieces.size()];
  return text;
}

bool has_what_a_terminal_obeys(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto code = static_cast<unsigned char>(text[i]);
    if (code < 0x20 || code == 0x7F) return true;
    if (code == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0)
      return true;
  }
  return text.find("\u202E") != std::string_view::npos;
}

TEST(Excerpt, WritesOutWhatATerminalWouldObey) {
  EXPECT_EQ(printable("\x1b[31mred\x07"), "\\x1b[31mred\\x07");
  EXPECT_EQ(printable("a\nb\tc\rd"), "a\\nb\\tc\\rd");
  EXPECT_EQ(printable("a\nb\tc\rd", LineEnds::kept), "a\nb\tc\\rd");
  EXPECT_EQ(printable("\x7f"), "\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\u009b31m");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(Excerpt, WritesOutWhatHidesOrReordersText) {
  EXPECT_EQ(printable("gpj.\u202Eexe"), "gpj.\\u202eexe");
  EXPECT_EQ(printable("\u2066\u200B\uFEFF\U000E0041"), "\\u2066\\u200b\\ufeff\\U000e0041");
}

TEST(Excerpt, WritesOutBytesThatAreNotUtf8) {
  EXPECT_EQ(printable("\xff"), "\\xff");
  EXPECT_EQ(printable("\xC0\x80"), "\\xc0\\x80");                    // overlong
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80");           // a surrogate
  EXPECT_EQ(printable("\xE6\xAD"), "\\xe6\\xad");                    // cut short
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond Unicode
}

TEST(Excerpt, LeavesHarmlessTextAsItIs) {
  const std::string text = "walk-1 \"é\" 歩く 🚶 C:\\walks 100 %";
  EXPECT_EQ(printable(text), text);
  EXPECT_EQ(excerpt(text), text);
  EXPECT_EQ(in_quotes("walk"), "\"walk\"");
}

TEST(Excerpt, IsNeverLongerThanItMayBe) {
  EXPECT_EQ(excerpt(std::string(80, 'x')), std::string(80, 'x'));
  EXPECT_EQ(excerpt(std::string(81, 'x')), std::string(79, 'x') + "…");
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = random_text(random, 120);
    for (const std::size_t most : {1, 7, 80}) {
      const std::string shown = excerpt(text, most);
      EXPECT_LE(characters_in(shown), most);
      EXPECT_FALSE(has_what_a_terminal_obeys(shown)) << shown;
      EXPECT_EQ(printable(shown), shown);
    }
  }
}

TEST(Excerpt, IsTheBeginningOfTheWholeTextAndCutsNothingInTwo) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 2000; ++i) {
    const std::string whole = printable(random_text(random, 120));
    std::string shown = excerpt(whole);
    if (characters_in(whole) <= max_quoted_characters) {
      EXPECT_EQ(shown, whole);
      continue;
    }
    ASSERT_TRUE(shown.ends_with("…"));
    shown.erase(shown.size() - std::string("…").size());
    EXPECT_TRUE(whole.starts_with(shown));
    EXPECT_EQ(characters_in(shown), max_quoted_characters - 1);
  }
  EXPECT_EQ(excerpt("abc\x1b", 6), "abc…");  // not "abc\x…"
  EXPECT_EQ(excerpt("abc\x1b", 7), "abc\\x1b");
}

TEST(Excerpt, OfNamesNamesTwelveAndCountsTheRest) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed(std::vector<std::string>{"a", "b\n"}), "a, b\\n");
  EXPECT_EQ(listed(std::vector<std::string>(13, "a")),
            "a, a, a, a, a, a, a, a, a, a, a, a, … (13 in all)");
}

}  // namespace
}  // namespace mien::motion
