#include "motion/text/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "motion/error.h"

namespace mien::motion {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::string_view export_again = "export the motion as BVH or glTF, and name that file";
constexpr std::string_view download_again = "download the file itself, not a page about it";

/// Magic bytes of a kind of file.
struct Signature {
  std::string_view bytes;
  std::string_view is;
  std::string_view remedy;
};

constexpr std::array signatures = {
    Signature{"\x89PNG"sv, "is a picture (PNG)", "name the motion file"},
    Signature{"\xff\xd8\xff"sv, "is a picture (JPEG)", "name the motion file"},
    Signature{"GIF8"sv, "is a picture (GIF)", "name the motion file"},
    Signature{"%PDF"sv, "is a document (PDF)", "name the motion file"},
    Signature{"PK\x03\x04"sv, "is a ZIP archive", "unpack it first"},
    Signature{"\x1f\x8b"sv, "is compressed (gzip)", "unpack it first"},
    Signature{"7z\xbc\xaf"sv, "is a 7z archive", "unpack it first"},
    Signature{"Kaydara FBX"sv, "is an FBX file, which is not read", export_again},
    Signature{"; FBX"sv, "is an FBX file, which is not read", export_again},
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

void refuse_other_motion(std::string_view bytes, std::string_view file, FileKind kind) {
  const std::string_view text = from_first_letter(bytes);
  if (kind != FileKind::gltf && bytes.starts_with("glTF")) {
    refuse(file, "is a binary glTF file", "rename it to .glb");
  }
  if (kind != FileKind::gltf && text.starts_with('{')) {
    refuse(file, "is JSON text, not a motion of this format",
           "rename it to .gltf if it is a glTF file");
  }
  if (kind != FileKind::bvh && begins_with(text, "hierarchy")) {
    refuse(file, "is a BVH file", "rename it to .bvh");
  }
}

}  // namespace

void require_kind(std::string_view bytes, std::string_view file, FileKind kind) {
  if (bytes.empty()) refuse(file, "is empty", "obtain the file again");
  if (from_first_letter(bytes).empty())
    refuse(file, "contains only white space", "obtain it again");
  for (const Signature& signature : signatures) {
    if (bytes.starts_with(signature.bytes)) refuse(file, signature.is, signature.remedy);
  }
  if (is_utf16(bytes)) refuse(file, "is text in UTF-16", "save it as UTF-8");
  const std::string_view text = from_first_letter(bytes);
  if (begins_with(text, "<!doctype html") || begins_with(text, "<html")) {
    refuse(file, "is a web page (HTML)", download_again);
  }
  refuse_other_motion(bytes, file, kind);
}

}  // namespace mien::motion
