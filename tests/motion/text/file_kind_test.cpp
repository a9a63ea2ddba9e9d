#include "motion/text/file_kind.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "motion/refusal.h"

namespace mien::motion {
namespace {

using std::string_view_literals::operator""sv;

struct Foreign {
  std::string_view bytes;
  std::string_view words;
};

TEST(FileKind, OfWhatIsNoMotionIsTold) {
  const Foreign files[] = {
      {"", "is empty"},
      {" \r\n", "contains only white space"},
      {"\x89PNG\r\n\x1a\n"sv, "is a picture (PNG)"},
      {"\xff\xd8\xff\xe0"sv, "is a picture (JPEG)"},
      {"<!DOCTYPE html>\n<html>", "is a web page (HTML)"},
      {"\n <HTML lang=en>", "is a web page (HTML)"},
      {"\xff\xfeH\0I\0E\0R\0"sv, "is text in UTF-16"},
      {"\xfe\xff\0H\0I\0E\0R"sv, "is text in UTF-16"},
      {"H\0I\0E\0R\0A\0R\0"sv, "is text in UTF-16"},
      {"glTF\2\0\0\0"sv, "is a binary glTF file; rename it to .glb"},
      {"{\"asset\": {}}", "is JSON text, not a motion of this format"},
      {"PK\3\4"sv, "is a ZIP archive"},
      {"\x1f\x8b\x08"sv, "is compressed (gzip)"},
      {"Kaydara FBX Binary  ", "is an FBX file"},
  };
  for (const Foreign& file : files) {
    const std::string said = test::refusal_of([&] { require_kind(file.bytes, "walk.bvh", "bvh"); });
    EXPECT_EQ(said.find("walk.bvh: "), 0u) << said;
    EXPECT_NE(said.find(file.words), std::string::npos) << said << "\nlacks: " << file.words;
    EXPECT_NE(said.find("; "), std::string::npos) << "no remedy: " << said;
  }
  EXPECT_NE(test::refusal_of([&] {
              require_kind("HIERARCHY\n", "a.glb", "gltf");
            }).find("is a BVH file; rename it to .bvh"),
            std::string::npos);
}

TEST(FileKind, OfWhatItsNameSaysIsLeftToItsReader) {
  EXPECT_NO_THROW(require_kind("HIERARCHY\nROOT", "a.bvh", "bvh"));
  EXPECT_NO_THROW(require_kind("\xef\xbb\xbfHIERARCHY", "a.bvh", "bvh"));
  EXPECT_NO_THROW(require_kind("v 1 2 3", "a.bvh", "bvh"));
  EXPECT_NO_THROW(require_kind("glTF\2\0\0\0"sv, "a.glb", "gltf"));
  EXPECT_NO_THROW(require_kind("{}", "a.gltf", "gltf"));
  EXPECT_NO_THROW(require_kind("#!OML:ASF\n:FULLY-SPECIFIED", "a.amc", "amc"));
}

}  // namespace
}  // namespace mien::motion
