#include "pipeline/tasks/receipt.h"

#include <algorithm>
#include <iterator>
#include <system_error>

#include <nlohmann/json.hpp>

#include "pipeline/documents/files.h"
#include "pipeline/tasks/artifact_key.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

FrameReceipt frame_from(const json& entry) {
  return {entry.at("name"), entry.at("hash"), entry.at("size")};
}

bool frames_agree(const fs::path& folder, const std::vector<FrameReceipt>& frames) {
  if (!fs::is_directory(folder)) return false;
  const auto present = std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  if (present != static_cast<std::ptrdiff_t>(frames.size())) return false;
  return std::all_of(frames.begin(), frames.end(), [&](const FrameReceipt& frame) {
    return agrees(folder / frame.name, frame.hash, frame.size);
  });
}

}  // namespace

Hash hash_of(const std::vector<FrameReceipt>& frames) {
  KeyBuilder sequence;
  for (const FrameReceipt& frame : frames) sequence.add(frame.name, frame.hash);
  return sequence.key();
}

std::string to_json(const Receipt& receipt) {
  json object = {
      {"key", receipt.key}, {"path", receipt.path}, {"hash", receipt.hash}, {"size", receipt.size}};
  for (const FrameReceipt& frame : receipt.frames) {
    object["frames"].push_back({{"name", frame.name}, {"hash", frame.hash}, {"size", frame.size}});
  }
  return object.dump(1) + "\n";
}

std::optional<Receipt> receipt_from_json(const std::string& text) {
  try {
    const json object = json::parse(text);
    Receipt receipt{object.at("key"), object.at("path"), object.at("hash"), object.at("size"), {}};
    if (object.contains("frames")) {
      for (const json& frame : object["frames"]) receipt.frames.push_back(frame_from(frame));
    }
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
  if (!fs::is_regular_file(file)) return std::nullopt;
  return receipt_from_json(read_file(file));
}

std::optional<Receipt> find_artifact(const fs::path& folder, const std::string& path,
                                     const Hash& key) {
  std::optional<Receipt> receipt = read_receipt(folder, path);
  if (!receipt || receipt->key != key || receipt->path != path) return std::nullopt;
  const bool there = receipt->frames.empty() ? agrees(folder / path, receipt->hash, receipt->size)
                                             : frames_agree(folder / path, receipt->frames);
  return there ? receipt : std::nullopt;
}

bool agrees(const fs::path& file, const Hash& hash, std::uint64_t size) {
  std::error_code error;
  if (!fs::is_regular_file(file, error) || fs::file_size(file, error) != size) return false;
  return hash_of_file(file) == hash;
}

}  // namespace mien::pipeline
