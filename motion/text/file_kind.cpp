#include "motion/text/file_kind.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

#include "motion/error.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"

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
    {"7z\xbc\xaf"sv, "is a 7z archive", "unpack it first"},
    {"rar!\x1a"sv, "is a RAR archive", "unpack it first"},
    {"bzh"sv, "is compressed (bzip2)", "unpack it first"},
    {"\xfd\x37zxz"sv, "is compressed (xz)", "unpack it first"},
    {"\x28\xb5\x2f\xfd"sv, "is compressed (Zstandard)", "unpack it first"},
    {"riff"sv, "is a sound, picture or film (RIFF)", "name the motion file"},
    {"\x89hdf\r\n"sv, "is an HDF5 file (or MATLAB 7.3)", "save its arrays as .npy or .npz"},
    {"matlab 5.0 mat-file"sv, "is a MATLAB file", "save its arrays as .npy or .csv"},
    {"blender"sv, "is a Blender file", export_again},
    {"#usda"sv, "is a USD file", export_again},
    {"pxr-usdc"sv, "is a USD file", export_again},
    {"kaydara fbx binary"sv, "is an FBX file", "rename it to .fbx", "fbx"},
    {"; fbx"sv, "is an FBX file", "rename it to .fbx", "fbx"},
    {"gltf"sv, "is a binary glTF file", "rename it to .glb", "gltf"},
    {"hierarchy"sv, "is a BVH file", "rename it to .bvh", "bvh"},
    {"#!oml:asf"sv, "is an Acclaim motion (AMC)", "rename it to .amc", "amc"},
    {"# ast/asf file"sv, "is an Acclaim skeleton (ASF)", "rename it to .asf", "amc"},
    {"pathfiletype"sv, "is a TRC file", "rename it to .trc", "trc"},
    {"\x93numpy"sv, "is a NumPy array", "rename it to .npy", "npy"},
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

/// Whether the text has a word, given in lower case, near its beginning.
bool has_early(std::string_view text, std::string_view word) {
  constexpr size_t near = 4096;
  std::string beginning(text.substr(0, near));
  std::ranges::transform(beginning, beginning.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return beginning.find(word) != std::string::npos;
}

/// Byte 0 is the block of the parameter section, whose fourth byte is the kind of processor.
bool is_c3d(std::string_view bytes) {
  if (bytes.size() < 512 || bytes[1] != 0x50) return false;
  const auto block = static_cast<unsigned char>(bytes[0]);
  const size_t parameters = (block - size_t{1}) * 512;
  const bool is_possible = block >= 1 && block < 0x20 && parameters + 4 <= bytes.size();
  return is_possible && bytes[parameters + 3] >= 84 && bytes[parameters + 3] <= 86;
}

/// The name of the first member of a ZIP archive.
std::string_view first_in_zip(std::string_view bytes) {
  constexpr size_t header = 30;
  if (bytes.size() < header) return {};
  const auto byte = [&](size_t at) { return size_t{static_cast<unsigned char>(bytes[at])}; };
  return bytes.substr(header, byte(26) | byte(27) << 8);
}

[[noreturn]] void refuse(std::string_view file, std::string_view is, std::string_view remedy) {
  throw Error({std::string(file)}, is, remedy);
}

void require_zip_of(std::string_view bytes, std::string_view file, std::string_view format) {
  const std::string_view first = first_in_zip(bytes);
  if (first.ends_with(".npy")) {
    if (format != "npz") refuse(file, "is an archive of NumPy arrays", "rename it to .npz");
  } else if (first == "[Content_Types].xml") {
    refuse(file, "is an Office document, such as an Excel workbook", "save the table as .csv");
  } else {
    refuse(file, format == "npz" ? "is a ZIP archive, but not of NumPy arrays" : "is a ZIP archive",
           "unpack it first");
  }
}

void require_gltf_of(std::string_view bytes, std::string_view file, std::string_view format) {
  if (format == "gltf") return;
  if (bytes.find("\"VRMC_vrm_animation\"") != std::string_view::npos)
    refuse(file, "is a VRM animation", "rename it to .vrma");
  if (bytes.find("\"VRMC_vrm\"") != std::string_view::npos ||
      bytes.find("\"VRM\"") != std::string_view::npos)
    refuse(file, "is a VRM character", "rename it to .vrm");
}

/// XML and HTML, from the first "<".
void require_markup_of(std::string_view text, std::string_view file, std::string_view format) {
  if (has_early(text, "<!doctype html") || has_early(text, "<html"))
    refuse(file, "is a web page (HTML)", download_again);
  if (format == "mvnx") return;
  if (has_early(text, "<mvnx") || has_early(text, "<mvn "))
    refuse(file, "is an MVNX file", "rename it to .mvnx");
  if (has_early(text, "<collada")) refuse(file, "is a COLLADA file", export_again);
  refuse(file, "is text in XML, not a motion of this format", "name the motion file");
}

void require_json_of(std::string_view file, std::string_view format) {
  if (format == "gltf" || format == "json") return;
  refuse(file, "is JSON text, not a motion of this format",
         "rename it to .gltf if it is a glTF file, to .json if it has key points");
}

}  // namespace

void require_kind(std::string_view bytes, std::string_view file, std::string_view format) {
  if (bytes.empty()) refuse(file, "is empty", "obtain the file again");
  if (is_c3d(bytes)) {
    if (format != "c3d") refuse(file, "is a C3D file", "rename it to .c3d");
    return;
  }
  const std::string_view text = from_first_letter(bytes);
  if (text.empty()) refuse(file, "contains only white space", "obtain it again");
  if (is_lfs_pointer(text))
    refuse(file, "is a git LFS pointer; the file itself has not been fetched", "run: git lfs pull");
  if (is_utf16(bytes)) refuse(file, "is text in UTF-16", "save it as UTF-8");
  if (is_gzip(bytes)) {
    const std::string name = std::filesystem::path(file).filename().string();
    refuse(file, "is compressed (gzip)", "rename it to " + excerpt(name) + ".gz, or unpack it");
  }
  if (bytes.starts_with("PK\x03\x04")) return require_zip_of(bytes, file, format);
  if (bytes.starts_with("glTF")) require_gltf_of(bytes, file, format);
  if (text.starts_with('<')) return require_markup_of(text, file, format);
  if (text.starts_with('{')) return require_json_of(file, format);
  for (const Signature& signature : signatures) {
    if (signature.format == format) continue;
    if (begins_with(text, signature.bytes)) refuse(file, signature.is, signature.remedy);
  }
}

}  // namespace mien::motion
