#include "motion/text/words.h"

#include <gtest/gtest.h>

#include "motion/interpolation/interpolation_options.h"
#include "motion/live/slider_interface.h"

namespace mien::motion {
namespace {

TEST(Words, MeanTheValuesThatTheyName) {
  for (const auto& [word, method] : interpolation_methods) {
    EXPECT_EQ(name_of(method), word);
    EXPECT_EQ(meaning_of(interpolation_methods, word), method);
  }
  for (const auto& [word, kind] : interface_kinds)
    EXPECT_EQ(meaning_of(interface_kinds, name_of(kind)), kind) << word;
}

TEST(Words, NameEveryValueOfAnEnumeration) {
  for (int i = 0; i <= static_cast<int>(InterpolationMethod::direct); ++i) {
    const auto method = static_cast<InterpolationMethod>(i);
    EXPECT_EQ(meaning_of(interpolation_methods, name_of(method)), method) << i;
  }
  for (const InterfaceKind kind :
       {InterfaceKind::adjectives, InterfaceKind::features, InterfaceKind::weights})
    EXPECT_EQ(meaning_of(interface_kinds, name_of(kind)), kind);
}

TEST(Words, ThatAreUnknownMeanNothing) {
  EXPECT_EQ(meaning_of(interpolation_methods, "Kriging"), std::nullopt);
  EXPECT_EQ(meaning_of(interpolation_methods, ""), std::nullopt);
}

}  // namespace
}  // namespace mien::motion
