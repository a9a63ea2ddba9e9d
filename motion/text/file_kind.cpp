#include "motion/text/file_kind.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "motion/error.h"

namespace mien::motion {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::string_view export_again = "export the motion as BVH or glTF, and name that file";
constexpr std::string_view download_again = "download the file itself, not a page about it";

/// A kind of file that is recognised by its first bytes.
struct Signature {
  std::string_view bytes;        ///< with ASCII letters in lower case; compared regardless of case
  std::string_view is;           ///< what the file is, as words that follow its name
  std::string_view remedy;       ///< what to do instead of reading it
  std::string_view format = {};  ///< of motions: the reader that takes it
};

constexpr Signature signatures[] = {
    {"\x89png"sv, "is a picture (PNG)", "name the motion file"},
    {"\xff\xd8\xff"sv, "is a picture (JPEG)", "name the motion file"},
    {"gif8"sv, "is a picture (GIF)", "name the motion file"},
    {"%pdf"sv, "is a document (PDF)", "name the motion file"},
    {"pk\x03\x04"sv, "is a ZIP archive", "unpack it first"},
    {"\x1f\x8b"sv, "is compressed (gzip)", "unpack it first"},
    {"7z\xbc\xaf"sv, "is a 7z archive", "unpack it first"},
    {"kaydara fbx"sv, "is an FBX file, which is not read", export_again},
    {"; fbx"sv, "is an FBX file, which is not read", export_again},
    {"<!doctype html"sv, "is a web page (HTML)", download_again},
    {"<html"sv, "is a web page (HTML)", download_again},
    {"gltf"sv, "is a binary glTF file", "rename it to .glb", "gltf"},
    {"{"sv, "is JSON text, not a motion of this format", "rename it to .gltf if it is a glTF file",
     "gltf"},
    {"hierarchy"sv, "is a BVH file", "rename it to .bvh", "bvh"},
};

bool begins_with(std::string_view text, std::string_view lower_case) {
  if (text.size() < lower_case.size()) return false;
  return std::equal(lower_case.begin(), lower_case.end(), text.begin(), [](char a, char b) {
    return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
  });
}

/// With a byte order mark, or by the zero byte of every other character of ASCII.
bool is_utf16(std::string_view bytes) {
  if (bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("\xfe\xff"sv)) return true;
  if (bytes.size() < 8) return false;
  const auto has_zeros = [&](size_t first) {
    for (size_t i = 0; i < 8; ++i) {
      if ((bytes[i] == '\0') != (i % 2 == first)) return false;
    }
    return true;
  };
  return has_zeros(0) || has_zeros(1);
}

std::string_view from_first_letter(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf"sv)) bytes.remove_prefix(3);
  const size_t first = bytes.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : bytes.substr(first);
}

[[noreturn]] void refuse(std::string_view file, std::string_view is, std::string_view remedy) {
  throw Error({std::string(file)}, is, remedy);
}

}  // namespace

void require_kind(std::string_view bytes, std::string_view file, std::string_view format) {
  if (bytes.empty()) refuse(file, "is empty", "obtain the file again");
  const std::string_view text = from_first_letter(bytes);
  if (text.empty()) refuse(file, "contains only white space", "obtain it again");
  if (is_utf16(bytes)) refuse(file, "is text in UTF-16", "save it as UTF-8");
  for (const Signature& signature : signatures) {
    if (signature.format == format) continue;
    if (begins_with(text, signature.bytes)) refuse(file, signature.is, signature.remedy);
  }
}

}  // namespace mien::motion
