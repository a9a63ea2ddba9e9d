#include "faults/study_bytes.h"

#include "end_to_end/program.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;

/// Of the store's own folder, what has to be there in the end.
bool is_lasting(const std::string& path) {
  if (path.starts_with("farm/")) return false;
  return !path.starts_with(".mien/") || path.starts_with(".mien/receipts/") ||
         path.starts_with(".mien/motions/");
}

bool is_transient(const std::string& path) {
  for (const char* folder : {".mien/attempts/", ".mien/claims/", ".mien/partial/"}) {
    if (path.starts_with(folder)) return true;
  }
  return path.ends_with(".new");
}

}  // namespace

Bytes bytes_in(const fs::path& folder) {
  Bytes bytes;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().lexically_relative(folder).generic_string();
    const fs::file_status status = entry.symlink_status();
    if (!is_lasting(path) || fs::is_directory(status)) continue;
    bytes[path] = fs::is_regular_file(status) ? text_of(entry.path()) : "(no regular file)";
  }
  return bytes;
}

std::vector<std::string> differences(const Bytes& undisturbed, const Bytes& found) {
  std::vector<std::string> all;
  for (const auto& [path, bytes] : undisturbed) {
    const auto there = found.find(path);
    if (there == found.end()) {
      all.push_back(path + " is missing");
    } else if (there->second != bytes) {
      all.push_back(path + " differs");
    }
  }
  for (const auto& [path, bytes] : found) {
    if (!undisturbed.contains(path)) all.push_back(path + " was left behind");
  }
  return all;
}

std::vector<std::string> leftovers(const fs::path& folder) {
  std::vector<std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().lexically_relative(folder).generic_string();
    if (!is_transient(path)) continue;
    if (!entry.is_directory() || path.starts_with(".mien/attempts/")) left.push_back(path);
  }
  return left;
}

}  // namespace mien::test
