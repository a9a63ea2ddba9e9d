#include "pipeline/manifest/reading/example_source.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

TEST(ExampleSource, IsABuiltInSetAFolderOrAPattern) {
  EXPECT_EQ(parse_examples("builtin:walks-27").builtin, "walks-27");
  const test::TemporaryFolder folder;
  const Examples all = parse_examples(folder.path().string());
  EXPECT_EQ(all.folder, folder.path());
  EXPECT_EQ(all.include, "*");
  const Examples some = parse_examples((folder.path() / "*walk*.bvh").string());
  EXPECT_EQ(some.folder, folder.path());
  EXPECT_EQ(some.include, "*walk*.bvh");
  EXPECT_EQ(parse_examples("a.bvh").folder, ".");
}

TEST(ExampleSource, TakesSharesByName) {
  EXPECT_EQ(parse_weights("normal=0.6,proud=.4"), (NamedValues{{"normal", 0.6}, {"proud", 0.4}}));
  EXPECT_EQ(parse_weights("a=1"), (NamedValues{{"a", 1.0}}));
  for (const char* text : {"", "a", "a=", "a=x", "a=-1", "a=nan", "a=1e999", "a=0", "a=1,,b=1"}) {
    EXPECT_THROW(parse_weights(text), Error) << text;
  }
  try {
    parse_weights("a=1,b=many");
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "--weights: \"b=many\" has no weight; write name=weight with a weight of at least "
                 "0, for example normal=0.6,proud=0.4");
  }
}

}  // namespace
}  // namespace mien::pipeline
