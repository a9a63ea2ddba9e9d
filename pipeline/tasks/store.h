#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

/// A second attempt at the same key gave other bytes.
struct Nondeterminism {
  std::string path;
  Hash before;
  Hash now;
};

/// Another run works in the same folder.
class StoreBusy : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

class FrameStore;

/// The folder of one study and the only way to write into it.
///
/// An artifact is written into a folder of the attempt's own, verified by the caller's check,
/// flushed to disk, hashed, and published by rename; its receipt follows. An artifact counts as
/// present only if its receipt has the key asked for and its size and hash still agree, so what a
/// killed run or an editor left behind is made again.
class Store {
 public:
  /// Writes the artifact to the given path, which has the artifact's own file name.
  using Write = std::function<void(const std::filesystem::path& file)>;
  /// Reads the written file back and throws if it is not what it should be.
  using Verify = std::function<void(const std::filesystem::path& file)>;

  /// Creates the folder, takes its lock and removes what killed attempts left. Throws StoreBusy
  /// when another process has the lock.
  explicit Store(std::filesystem::path folder);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  const std::filesystem::path& folder() const;

  /// The receipt of an artifact that is present with this key.
  std::optional<Receipt> find(const std::string& path, const Hash& key) const;

  /// Makes an artifact. Different paths may be made at the same time.
  Receipt put(const std::string& path, const Hash& key, const Write& write, const Verify& verify);

  /// Begins or resumes a sequence of frames. It must not outlive the store.
  std::unique_ptr<FrameStore> frames(const std::string& path, const Hash& key);

  /// All nondeterminism met so far, by path.
  std::vector<Nondeterminism> nondeterminism() const;

 private:
  friend class FrameStore;
  struct State;
  std::unique_ptr<State> state_;
};

/// A frame sequence in the making; frames of different names may be found and put at the same time.
///
/// Frames of a killed attempt at the same key, and those of a published sequence of that key that
/// still agree with its receipt, are taken over.
class FrameStore {
 public:
  FrameStore(const FrameStore&) = delete;
  FrameStore& operator=(const FrameStore&) = delete;

  /// The file of a frame that is already there with the hash noted for it; the caller decodes it
  /// and calls `discard` when that fails.
  std::optional<std::filesystem::path> find(const std::string& name) const;

  void discard(const std::string& name);

  /// Writes one frame, verifies it and notes its hash. Returns its file.
  std::filesystem::path put(const std::string& name, const Store::Write& write,
                            const Store::Verify& verify);

  /// Publishes the frames of these names, in this order, and nothing else. All must be there.
  Receipt publish(const std::vector<std::string>& names);

 private:
  friend class Store;
  FrameStore(Store::State& store, std::string path, Hash key);
  std::optional<FrameReceipt> noted(const std::string& name) const;
  void take_back_unreceipted();
  void read_journal();
  void write_journal() const;
  void adopt_published();

  Store::State* store_;
  std::string path_;
  Hash key_;
  std::filesystem::path folder_;   ///< of the frames so far
  std::filesystem::path journal_;  ///< a line "hash size name" for each, after the key
  mutable std::mutex mutex_;       ///< of noted_ and the journal
  std::map<std::string, FrameReceipt> noted_;
};

}  // namespace mien::pipeline
