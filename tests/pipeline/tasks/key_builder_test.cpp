#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "pipeline/tasks/hash.h"

namespace mien::pipeline {
namespace {

TEST(Key, MindsNamesValuesOrderAndBoundaries) {
  const auto key = [](auto&&... pairs) {
    KeyBuilder builder;
    (builder.add(pairs.first, pairs.second), ...);
    return builder.key();
  };
  using Text = std::pair<std::string, std::string>;
  const Hash base = key(Text{"a", "b"}, Text{"c", "d"});
  EXPECT_EQ(base, key(Text{"a", "b"}, Text{"c", "d"}));
  EXPECT_NE(base, key(Text{"c", "d"}, Text{"a", "b"}));
  EXPECT_NE(base, key(Text{"a", "bc"}, Text{"", "d"}));
  EXPECT_NE(base, key(Text{"a", "b"}, Text{"c", "e"}));
  EXPECT_NE(key(Text{"a", "1"}), key(std::pair{"a", 1.0}));
  EXPECT_NE(key(std::pair{"a", 0.1 + 0.2}), key(std::pair{"a", 0.3}));
}

}  // namespace
}  // namespace mien::pipeline
