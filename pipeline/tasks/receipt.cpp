#include "pipeline/tasks/receipt.h"

#include <algorithm>
#include <system_error>

#include <nlohmann/json.hpp>

#include "motion/text/file_contents.h"
#include "motion/text/safe_name.h"

namespace mien::pipeline {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FrameReceipt, name, hash, size)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Maker, host, instruction_set)

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// Whether all paths of a receipt are inside the study's folder.
bool is_of_its_folder(const Receipt& receipt) {
  return motion::fault_of_relative(receipt.path).empty() &&
         std::ranges::all_of(receipt.frames, [](const FrameReceipt& frame) {
           return motion::fault_of_name(frame.name).empty();
         });
}

/// A network file system may cache for a while that a file did not exist. Opening its folder makes
/// it ask the server again.
bool is_file(const fs::path& file) {
  std::error_code error;
  if (fs::is_regular_file(file, error)) return true;
  const fs::directory_iterator opened(file.parent_path(), error);
  return fs::is_regular_file(file, error);
}

bool has_size(const fs::path& file, std::uint64_t size) {
  std::error_code error;
  return is_file(file) && fs::file_size(file, error) == size && !error;
}

/// Hidden files do not count: file browsers (.DS_Store) and network file systems (.nfs…) leave
/// them.
std::ptrdiff_t count_in(const fs::path& folder) {
  std::error_code error;
  const fs::directory_iterator entries(folder, error);
  if (error) return -1;
  return std::count_if(begin(entries), end(entries), [](const fs::directory_entry& entry) {
    return !entry.path().filename().string().starts_with('.');
  });
}

/// Whether a test holds for an artifact's file, or for each of its frames and nothing is beside
/// them but hidden files.
template <class Test>
bool holds_for_files(const fs::path& folder, const Receipt& receipt, const Test& test) {
  const fs::path target = folder / receipt.path;
  if (receipt.frames.empty()) return test(target, receipt.hash, receipt.size);
  if (count_in(target) != static_cast<std::ptrdiff_t>(receipt.frames.size())) return false;
  return std::ranges::all_of(receipt.frames, [&](const FrameReceipt& frame) {
    return test(target / frame.name, frame.hash, frame.size);
  });
}

json object_of(const Receipt& receipt) {
  json object = {{"key", receipt.key},
                 {"path", receipt.path},
                 {"hash", receipt.hash},
                 {"size", receipt.size},
                 {"made_by", receipt.maker}};
  if (!receipt.frames.empty()) object["frames"] = receipt.frames;
  return object;
}

}  // namespace

Hash hash_of(const std::vector<FrameReceipt>& frames) {
  KeyBuilder sequence;
  for (const FrameReceipt& frame : frames) sequence.add(frame.name, frame.hash);
  return sequence.key();
}

std::string to_json(const Receipt& receipt) {
  json object = object_of(receipt);
  object["checksum"] = hash_of(object.dump());
  return object.dump(1) + "\n";
}

std::optional<Receipt> receipt_from_json(const std::string& text) {
  try {
    const json object = json::parse(text);
    const Receipt receipt{object.at("key"),
                          object.at("path"),
                          object.at("hash"),
                          object.at("size"),
                          object.value("frames", std::vector<FrameReceipt>()),
                          object.at("made_by")};
    if (object.at("checksum") != hash_of(object_of(receipt).dump())) return std::nullopt;
    if (!is_of_its_folder(receipt)) return std::nullopt;
    return receipt;
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

fs::path receipt_path(const fs::path& folder, const std::string& path) {
  return folder / ".mien" / "receipts" / (path + ".json");
}

std::optional<Receipt> read_receipt(const fs::path& folder, const std::string& path) {
  const fs::path file = receipt_path(folder, path);
  if (!is_file(file)) return std::nullopt;
  const motion::FileReading text = motion::bytes_of_file(file, motion::max_document_bytes);
  return text.bytes ? receipt_from_json(*text.bytes) : std::nullopt;
}

std::optional<Receipt> find_artifact(const fs::path& folder, const std::string& path,
                                     const Hash& key) {
  std::optional<Receipt> receipt = read_receipt(folder, path);
  if (!receipt || receipt->key != key || receipt->path != path) return std::nullopt;
  return artifact_agrees(folder, *receipt) ? receipt : std::nullopt;
}

bool agrees(const fs::path& file, const Hash& hash, std::uint64_t size) {
  if (!has_size(file, size)) return false;
  try {
    return hash_of_file(file) == hash;
  } catch (const std::system_error&) {  // it went away, or the disk cannot read it
    return false;
  }
}

bool artifact_agrees(const fs::path& folder, const Receipt& receipt) {
  return holds_for_files(folder, receipt, agrees);
}

bool artifact_seems_present(const fs::path& folder, const Receipt& receipt) {
  return holds_for_files(
      folder, receipt,
      [](const fs::path& file, const Hash&, std::uint64_t size) { return has_size(file, size); });
}

}  // namespace mien::pipeline
