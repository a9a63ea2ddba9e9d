#include "motion/formats/fbx/fbx_document.h"

#include <algorithm>
#include <cstring>

#include "motion/error.h"
#include "motion/formats/fbx/fbx_values.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view binary_start = "Kaydara FBX Binary  \0"sv;
constexpr int oldest_version = 6100;
constexpr int newest_version = 7999;

int binary_version(const FbxDocument& document) {
  if (document.bytes.size() < 27) {
    refuse_fbx(document, document.bytes.data() + document.bytes.size(), "the file is truncated",
               fbx_again);
  }
  std::uint32_t version = 0;
  std::memcpy(&version, document.bytes.data() + 23, sizeof version);
  return static_cast<int>(version & 0x7FFFFFFF);
}

/// From "; FBX 6.1.0 project file".
int version_of_comment(std::string_view text) {
  const size_t at = text.substr(0, 256).find("; FBX ");
  if (at == std::string_view::npos) return 0;
  int version = 0;
  int factor = 1000;
  for (size_t i = at + 6; i < text.size() && factor > 0; ++i) {
    if (text[i] >= '0' && text[i] <= '9') {
      version += factor * (text[i] - '0');
      factor /= 10;
    } else if (text[i] != '.') {
      break;
    }
  }
  return version;
}

int text_version(const FbxDocument& document) {
  if (const std::uint32_t header = find_child(document, 0, "FBXHeaderExtension")) {
    if (const std::uint32_t version = find_child(document, header, "FBXVersion")) {
      return static_cast<int>(std::min<std::int64_t>(integer_of(document, version, 0), 1'000'000));
    }
  }
  return version_of_comment(document.bytes);
}

void require_version(const FbxDocument& document) {
  const int version = document.version;
  if (version >= oldest_version && version <= newest_version) return;
  const std::string given = "FBX of version " + std::to_string(version / 1000) + "." +
                            std::to_string(version % 1000 / 100);
  throw Error({document.file},
              version <= 0 ? "states no version of FBX"
                           : "is " + given + " (" + std::to_string(version) + ")",
              "export it as FBX of version 6.1 to 7.7, such as \"FBX 2014/2015\" or \"FBX 2020\"");
}

}  // namespace

bool is_binary_fbx(std::string_view bytes) { return bytes.starts_with(binary_start); }

FbxDocument parse_fbx_document(std::string_view bytes, const std::string& file_name) {
  FbxDocument document{file_name, bytes, !is_binary_fbx(bytes), 0, {}};
  document.nodes.push_back({});
  if (document.is_text) {
    if (document.bytes.starts_with("\xEF\xBB\xBF")) document.bytes.remove_prefix(3);
    const int told = version_of_comment(document.bytes);
    if (told > 0 && told < oldest_version) {
      document.version = told;
      require_version(document);
    }
    parse_text_fbx(document);
    document.version = text_version(document);
    require_version(document);
  } else {
    document.version = binary_version(document);
    require_version(document);
    parse_binary_fbx(document);
  }
  document.nodes.front().end = static_cast<std::uint32_t>(document.nodes.size());
  return document;
}

std::uint32_t find_child(const FbxDocument& document, std::uint32_t node, std::string_view name) {
  // While a document is parsed, its first node has no end yet.
  const std::uint32_t end =
      node == 0 ? static_cast<std::uint32_t>(document.nodes.size()) : document.nodes[node].end;
  for (std::uint32_t child = first_child(node); child < end; child = document.nodes[child].end) {
    if (document.nodes[child].name == name) return child;
  }
  return 0;
}

void refuse_fbx(const FbxDocument& document, const char* position, std::string_view wrong,
                std::string_view remedy) {
  const auto offset = static_cast<size_t>(position - document.bytes.data());
  if (document.is_text) {
    throw Error(place_at({document.bytes, document.file}, offset), wrong, remedy);
  }
  throw Error({document.file}, "at byte " + std::to_string(offset) + ": " + std::string(wrong),
              remedy);
}

void refuse_fbx(const FbxDocument& document, std::uint32_t node, std::string_view wrong) {
  const char* position = node == 0 ? document.bytes.data() : document.nodes[node].name.data();
  refuse_fbx(document, position, wrong, fbx_again);
}

}  // namespace mien::motion
