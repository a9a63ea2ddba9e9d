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
      {"\n<?xml version='1.0'?>\n<!DOCTYPE html PUBLIC \"x\">", "is a web page (HTML)"},
      {"<!-- saved from a page -->\n<html>", "is a web page (HTML)"},
      {"<?xml version=\"1.0\"?>\n<mvnx version=\"4\">", "is an MVNX file; rename it to .mvnx"},
      {"<?xml version=\"1.0\"?>\n<COLLADA>", "is a COLLADA file"},
      {"<svg>", "is text in XML"},
      {"PK\3\4"sv, "is a ZIP archive"},
      {"\x1f\x8b\x08"sv, "is compressed (gzip); rename it to walk.bvh.gz, or unpack it"},
      {"Kaydara FBX Binary  ", "is an FBX file; rename it to .fbx"},
      {"; FBX 7.3.0 project file", "is an FBX file; rename it to .fbx"},
      {"\x93NUMPY\1\0"sv, "is a NumPy array; rename it to .npy"},
      {"PathFileType\t4\t(X/Y/Z)\ta.trc", "is a TRC file; rename it to .trc"},
      {"MATLAB 5.0 MAT-file, Platform", "is a MATLAB file"},
      {"\x89HDF\r\n\x1a\n", "is an HDF5 file"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:", "is a git LFS pointer"},
      {"glTF\2\0\0\0    JSON{\"extensions\":{\"VRMC_vrm_animation\":{}}}"sv,
       "is a VRM animation; rename it to .vrma"},
      {"glTF\2\0\0\0    JSON{\"extensions\":{\"VRM\":{}}}"sv,
       "is a VRM character; rename it to .vrm"},
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

/// The beginning of a ZIP archive whose first member has this name.
std::string zip_of(std::string_view name) {
  std::string bytes = "PK\3\4" + std::string(22, '\0');
  bytes += static_cast<char>(name.size());
  return bytes + std::string(3, '\0') + std::string(name);
}

TEST(FileKind, OfArchivesIsToldByWhatIsInThem) {
  const auto said = [](const std::string& bytes, const std::string& format) {
    return test::refusal_of([&] { require_kind(bytes, "a.csv", format); });
  };
  EXPECT_NE(said(zip_of("poses.npy"), "csv").find("rename it to .npz"), std::string::npos);
  EXPECT_NE(said(zip_of("[Content_Types].xml"), "csv").find("Excel"), std::string::npos);
  EXPECT_NE(said(zip_of("a.bvh"), "bvh").find("is a ZIP archive; unpack"), std::string::npos);
  EXPECT_NE(said(zip_of("a.bvh"), "npz").find("not of NumPy arrays"), std::string::npos);
  EXPECT_NO_THROW(require_kind(zip_of("poses.npy"), "a.npz", "npz"));
}

/// A C3D file without contents: parameters from block 2 on, written on such a processor.
std::string c3d_like(char processor) {
  std::string bytes(1024, '\0');
  bytes[0] = 2;
  bytes[1] = 0x50;
  bytes[515] = processor;
  return bytes;
}

TEST(FileKind, OfC3dIsToldByItsProcessorToo) {
  for (const char processor : {84, 85, 86}) {
    EXPECT_NE(test::refusal_of([&] {
                require_kind(c3d_like(processor), "a.bvh", "bvh");
              }).find("is a C3D file; rename it to .c3d"),
              std::string::npos);
    EXPECT_NO_THROW(require_kind(c3d_like(processor), "a.c3d", "c3d"));
  }
  EXPECT_NO_THROW(require_kind(c3d_like(83), "a.bvh", "bvh"));
  EXPECT_NO_THROW(require_kind(c3d_like(84).substr(0, 515), "a.bvh", "bvh"));
}

TEST(FileKind, OfWhatItsNameSaysIsLeftToItsReader) {
  EXPECT_NO_THROW(require_kind("HIERARCHY\nROOT", "a.bvh", "bvh"));
  EXPECT_NO_THROW(require_kind("\xef\xbb\xbfHIERARCHY", "a.bvh", "bvh"));
  EXPECT_NO_THROW(require_kind("v 1 2 3", "a.bvh", "bvh"));
  EXPECT_NO_THROW(require_kind("glTF\2\0\0\0"sv, "a.glb", "gltf"));
  EXPECT_NO_THROW(require_kind("{}", "a.gltf", "gltf"));
  EXPECT_NO_THROW(require_kind("<?xml version=\"1.0\"?><mvnx>", "a.mvnx", "mvnx"));
  EXPECT_NO_THROW(require_kind("{}", "a.json", "json"));
  EXPECT_NO_THROW(require_kind("Kaydara FBX Binary  ", "a.fbx", "fbx"));
  EXPECT_NO_THROW(require_kind("\x93NUMPY\1\0"sv, "a.npy", "npy"));
  EXPECT_NO_THROW(require_kind("PathFileType\t4", "a.trc", "trc"));
  EXPECT_NO_THROW(
      require_kind("xPos,yPos,zPos\n1,2,3\n" + std::string(70000, 'T'), "a.csv", "csv"));
  EXPECT_NO_THROW(require_kind("#!OML:ASF\n:FULLY-SPECIFIED", "a.amc", "amc"));
}

}  // namespace
}  // namespace mien::motion
