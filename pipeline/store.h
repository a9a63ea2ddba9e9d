#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace mien::pipeline {

/// 128-bit content hash (XXH3), 32 hexadecimal digits.
using Hash = std::string;

Hash hash_of(std::string_view bytes);
/// Throws std::system_error when the file cannot be read.
Hash hash_of_file(const std::filesystem::path& file);

/// Builds a key out of everything that determines an artifact. Order and boundaries count.
class KeyBuilder {
 public:
  KeyBuilder& add(std::string_view name, std::string_view value);
  KeyBuilder& add(std::string_view name, double value);
  KeyBuilder& add(std::string_view name, std::int64_t value);

  Hash key() const;

 private:
  std::string determinants_;
};

/// What is known about a published artifact.
struct Receipt {
  Hash key;
  std::string path;  ///< relative to the study's folder, with '/'
  Hash hash;         ///< of the bytes; of a frame sequence: of its frames' hashes in order
  std::uint64_t size = 0;
};

/// A second attempt at the same key gave other bytes.
struct Nondeterminism {
  std::string path;
  Hash key;
  Hash before;
  Hash now;
};

/// The folder of one study and the only way to write into it.
///
/// An artifact is written under a name unique to the attempt, flushed to disk, verified by the
/// caller's check, hashed, and published by rename; its receipt follows. An artifact counts as
/// present only if its receipt has the key asked for and its size and hash still agree.
class Store {
 public:
  /// Writes the artifact to the given temporary path.
  using Write = std::function<void(const std::filesystem::path& temporary)>;
  /// Reads the written file back and throws if it is not what it should be.
  using Verify = std::function<void(const std::filesystem::path& written)>;

  enum class Wait { fail, wait };

  /// Creates the folder, takes its lock and removes what killed attempts left. With Wait::fail a
  /// folder in use throws Error; otherwise the call blocks until the other run has ended.
  explicit Store(std::filesystem::path folder, Wait wait = Wait::fail);
  ~Store();
  Store(Store&& other) noexcept;
  Store& operator=(Store&&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path path_of(std::string_view relative) const;

  /// The receipt of an artifact that is present with this key.
  std::optional<Receipt> find(const std::string& path, const Hash& key) const;

  /// Makes an artifact. Thread-safe for different paths.
  Receipt put(const std::string& path, const Hash& key, const Write& write, const Verify& verify);

  /// All nondeterminism met by `put` so far, by path.
  std::vector<Nondeterminism> nondeterminism() const;

 private:
  std::filesystem::path folder_;
  int lock_ = -1;
};

}  // namespace mien::pipeline
