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

#include "pipeline/tasks/claim.h"
#include "pipeline/tasks/receipt.h"
#include "pipeline/tasks/worker_heartbeat.h"

namespace mien::pipeline {

/// A second attempt at the same key produced other bytes.
struct Nondeterminism {
  std::string path;
  Hash before;
  Hash now;
  Maker before_by;
  Maker now_by;
};

/// A sentence that states what differs and where both versions were produced.
std::string to_string(const Nondeterminism& met);

/// Another process works in the same folder, and one of the two requires exclusive access.
class StoreBusy : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

enum class Sharing { shared, exclusive };

class FrameStore;

/// The folder of one study and the only way to write to it, for any number of processes at a time,
/// on one machine or on several that share the folder.
///
/// An artifact is written to a separate folder for each attempt, flushed to disk, verified by the
/// caller's check, hashed, and published by rename; its receipt follows. It counts as present only
/// if its receipt has the required key and its size and hash still agree, so that incomplete or
/// edited files are produced again. Of two attempts at one key, the one published first stays; the
/// second is compared with it and dropped. There are no locks: a process that was stopped, or whose
/// machine was believed dead, may continue at any time without harm.
class Store {
 public:
  /// Writes the artifact to the given path, which has the artifact's own file name.
  using Write = std::function<void(const std::filesystem::path& file)>;
  /// Reads the written file back and throws if its content is wrong.
  using Verify = std::function<void(const std::filesystem::path& file)>;

  /// Creates the folder and removes files of dead processes. Throws StoreBusy if another process
  /// works there and one of the two requires exclusive access, and WriteFailure if the folder is
  /// not writable: a DiskFault if the disk is the reason.
  explicit Store(const std::filesystem::path& folder, Sharing sharing = Sharing::shared);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  const std::filesystem::path& folder() const;

  /// The receipt of an artifact that is present with this key.
  std::optional<Receipt> find(const std::string& path, const Hash& key) const;

  /// Produces and publishes an artifact, and returns its receipt. If another attempt at this key
  /// was published in the meantime, its artifact stays and its receipt is returned. Calls for
  /// different paths may run at the same time. Anything at the path other than a file, such as a
  /// folder or a symbolic link, is set aside.
  Receipt put(const std::string& path, const Hash& key, const Write& write, const Verify& verify);

  /// Starts or resumes a frame sequence. The result must not outlive the store.
  std::unique_ptr<FrameStore> frames(const std::string& path, const Hash& key);

  /// Claims a task (Claim::take); null while another live process holds the claim.
  std::unique_ptr<Claim> claim(const std::string& what);

  /// Removes claims, and unpublished frames unless other processes are drawing. For complete
  /// studies.
  void remove_intermediates();

  /// The heartbeat of this process, which writes its record for other processes.
  WorkerHeartbeat& heartbeat();

  /// All nondeterminism detected so far, sorted by path.
  std::vector<Nondeterminism> nondeterminism() const;

  /// Records that an artifact was found damaged.
  void note_damage(const std::string& path);

  /// Sentences about artifacts that were found damaged and about files that were set aside, sorted.
  std::vector<std::string> repairs() const;

 private:
  friend class FrameStore;
  struct State;
  std::unique_ptr<State> state_;
};

/// An unpublished frame sequence, written by any number of processes; calls for different frames
/// may run at the same time.
///
/// Frames are stored one by one. Frames that other processes, including killed ones, have written
/// for the same key are reused; so are frames of a published sequence with that key, if they still
/// agree with its receipt.
class FrameStore {
 public:
  FrameStore(const FrameStore&) = delete;
  FrameStore& operator=(const FrameStore&) = delete;

  /// The file of a frame if it already exists with its recorded hash. The caller decodes it, and
  /// calls `discard` if that fails.
  std::optional<std::filesystem::path> find(const std::string& name);

  void discard(const std::string& name);

  /// Writes one frame, verifies it and records its hash. Returns its file.
  std::filesystem::path put(const std::string& name, const Store::Write& write,
                            const Store::Verify& verify);

  /// Publishes the frames of these names, in this order, and then calls `drop`. `find` or `put`
  /// must have succeeded for each.
  Receipt publish(const std::vector<std::string>& names);

  /// Removes the unpublished frames, which are no longer needed. Unpublished frames of the same
  /// film with another key are removed, too, unless another process has drawn frames for that key
  /// and is not proven to have ended.
  void drop();

 private:
  friend class Store;

  /// A frame that some process has drawn.
  struct Note {
    FrameReceipt frame;
    Maker maker;
  };
  /// A frame that has been verified, and its file.
  struct Found {
    FrameReceipt frame;
    std::filesystem::path file;
  };

  FrameStore(Store::State& store, std::string path, Hash key);
  std::vector<Note> notes_of(const std::string& name);
  std::optional<Note> published_note(const std::string& name) const;
  void note_damage(const std::string& name);
  void read_new_notes();
  void compare_with_earlier(const FrameReceipt& frame);
  void add_note(const FrameReceipt& frame);
  void remember(const std::string& name, Found found);
  void link_frames(const std::vector<FrameReceipt>& frames, const std::filesystem::path& into);
  Receipt receipt_of(const std::vector<std::string>& names) const;
  void drop_other_keys();

  Store::State* store_;
  std::string path_;
  Hash key_;
  std::filesystem::path folder_;  ///< folder of the unpublished sequence, with frames/ and notes/
  std::mutex mutex_;              ///< guards the members below
  std::map<std::string, std::uintmax_t> read_;  ///< note file → number of bytes read from it
  std::multimap<std::string, Note> notes_;      ///< notes by the name of their frame
  std::map<std::string, Found> found_;
};

}  // namespace mien::pipeline
