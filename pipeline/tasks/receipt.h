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

/// Where an artifact was produced, to be reported if two attempts differ.
struct Maker {
  std::string host;
  std::string instruction_set;

  friend bool operator==(const Maker&, const Maker&) = default;
};

/// Record of a published artifact: a file, or a folder of frames.
struct Receipt {
  Hash key;
  std::string path;  ///< relative to the study's folder, with '/'
  Hash hash;         ///< hash of the file's bytes, or of the names and hashes of the frames
  std::uint64_t size = 0;
  std::vector<FrameReceipt> frames;  ///< frames of a frame sequence, in order
  Maker maker = {};
};

/// The hash of a frame sequence.
Hash hash_of(const std::vector<FrameReceipt>& frames);

std::string to_json(const Receipt& receipt);

/// Parses a receipt. Nothing if the text is not a receipt, its checksum is wrong, or it names a
/// file outside the study's folder: a damaged receipt counts as missing.
std::optional<Receipt> receipt_from_json(const std::string& text);

/// Path of an artifact's receipt: <folder>/.mien/receipts/<path>.json.
std::filesystem::path receipt_path(const std::filesystem::path& folder, const std::string& path);

/// Reads a receipt without checking its artifact; nothing if it is missing or damaged.
std::optional<Receipt> read_receipt(const std::filesystem::path& folder, const std::string& path);

/// The receipt, if it has this key and the artifact exists with the stated size and hash.
std::optional<Receipt> find_artifact(const std::filesystem::path& folder, const std::string& path,
                                     const Hash& key);

/// Whether a file exists with this size and hash.
bool agrees(const std::filesystem::path& file, const Hash& hash, std::uint64_t size);

/// Whether the artifact of a receipt exists with the stated size and hash; for a frame sequence,
/// whether this is true of each frame and its folder contains nothing else.
bool artifact_agrees(const std::filesystem::path& folder, const Receipt& receipt);

/// Whether the files of a receipt's artifact exist with the stated sizes; their bytes are not read.
bool artifact_seems_present(const std::filesystem::path& folder, const Receipt& receipt);

}  // namespace mien::pipeline
