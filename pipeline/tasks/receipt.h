#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

/// A file of a frame sequence.
struct FrameReceipt {
  std::string name;  ///< "00000.png"
  Hash hash;
  std::uint64_t size = 0;

  friend bool operator==(const FrameReceipt&, const FrameReceipt&) = default;
};

/// Who made something: what to tell when two differ.
struct Maker {
  std::string host;
  std::string instruction_set;

  friend bool operator==(const Maker&, const Maker&) = default;
};

/// What is known about a published artifact: a file, or a folder of frames.
struct Receipt {
  Hash key;
  std::string path;  ///< relative to the study's folder, with '/'
  Hash hash;         ///< of the bytes; of a frame sequence: of its frames' names and hashes
  std::uint64_t size = 0;
  std::vector<FrameReceipt> frames;  ///< of a frame sequence, in order
  Maker maker = {};
};

/// The hash of a frame sequence.
Hash hash_of(const std::vector<FrameReceipt>& frames);

std::string to_json(const Receipt& receipt);

/// Nothing when the text is no receipt, or one of which a character was changed since it was
/// written: it has a checksum of its own. (A damaged receipt is as good as none.)
std::optional<Receipt> receipt_from_json(const std::string& text);

/// Where the receipt of an artifact lies: <folder>/.mien/receipts/<path>.json.
std::filesystem::path receipt_path(const std::filesystem::path& folder, const std::string& path);

/// The receipt, whether or not the artifact still agrees with it.
std::optional<Receipt> read_receipt(const std::filesystem::path& folder, const std::string& path);

/// The receipt, if it has this key and the artifact is there with the size and hash that it states.
std::optional<Receipt> find_artifact(const std::filesystem::path& folder, const std::string& path,
                                     const Hash& key);

/// Whether a file has the size and hash that are stated.
bool agrees(const std::filesystem::path& file, const Hash& hash, std::uint64_t size);

/// Whether the artifact of a receipt is there with the size and hash that it states.
bool artifact_agrees(const std::filesystem::path& folder, const Receipt& receipt);

/// Whether a receipt's artifact seems to be there: files of these sizes, of which no byte is read.
bool artifact_seems_there(const std::filesystem::path& folder, const Receipt& receipt);

}  // namespace mien::pipeline
