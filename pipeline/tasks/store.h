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
#include "pipeline/tasks/worker_presence.h"

namespace mien::pipeline {

/// A second attempt at the same key gave other bytes.
struct Nondeterminism {
  std::string path;
  Hash before;
  Hash now;
  Maker before_by;
  Maker now_by;
};

/// For people: what differs, and who made it where.
std::string to_string(const Nondeterminism& met);

/// Another process works in the same folder, and one of the two wants to be alone.
class StoreBusy : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

enum class Sharing { shared, exclusive };

class FrameStore;

/// The folder of one study and the only way to write into it, for any number of processes at a
/// time, on one machine or on several that share the folder.
///
/// An artifact is written into a folder of the attempt's own, verified by the caller's check,
/// flushed to disk, hashed, and published by rename; its receipt follows. An artifact counts as
/// present only if its receipt has the key asked for and its size and hash still agree, so what a
/// killed process or an editor left behind is made again. Of two attempts at one key the first
/// that is published stays; another one is compared with it and dropped. Nothing rests on locks: a
/// process that was stopped, or whose machine was thought dead, may go on at any time and harms
/// nothing.
class Store {
 public:
  /// Writes the artifact to the given path, which has the artifact's own file name.
  using Write = std::function<void(const std::filesystem::path& file)>;
  /// Reads the written file back and throws if it is not what it should be.
  using Verify = std::function<void(const std::filesystem::path& file)>;

  /// Creates the folder and removes what attempts left whose processes are gone. Throws StoreBusy
  /// when another process works there and one of the two wants it to itself, and WriteFailure when
  /// the folder cannot be written to: a DiskFault where the disk is the reason.
  explicit Store(const std::filesystem::path& folder, Sharing sharing = Sharing::shared);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  const std::filesystem::path& folder() const;

  /// The receipt of an artifact that is present with this key.
  std::optional<Receipt> find(const std::string& path, const Hash& key) const;

  /// Makes an artifact. Different paths may be made at the same time. What lies in its place and
  /// is no file (a folder, a loop of links) is set aside. Returns the receipt of what is there
  /// then: of an earlier attempt at this key, if one was published in the meantime.
  Receipt put(const std::string& path, const Hash& key, const Write& write, const Verify& verify);

  /// Begins or resumes a sequence of frames. It must not outlive the store.
  std::unique_ptr<FrameStore> frames(const std::string& path, const Hash& key);

  /// Tells other processes that this one makes something; nothing while another one does.
  std::unique_ptr<Claim> claim(const std::string& what);

  /// Once all of the study is made: removes claims and frames in the making, unless others draw.
  void remove_workings();

  /// What others see of this process.
  WorkerPresence& presence();

  /// All nondeterminism met so far, by path.
  std::vector<Nondeterminism> nondeterminism() const;

  /// Notes an artifact that was there once and has been damaged since.
  void note_damage(const std::string& path);

  /// What was found damaged or in the way, and made good, in words, sorted.
  std::vector<std::string> repairs() const;

 private:
  friend class FrameStore;
  struct State;
  std::unique_ptr<State> state_;
};

/// A frame sequence in the making, by any number of processes; frames of different names may be
/// found and put at the same time.
///
/// Each frame is a unit: those of other processes and of killed ones at the same key are taken
/// over, and so are those of a published sequence of that key that still agree with its receipt.
class FrameStore {
 public:
  FrameStore(const FrameStore&) = delete;
  FrameStore& operator=(const FrameStore&) = delete;

  /// The file of a frame that is already there with the hash noted for it; the caller decodes it
  /// and calls `discard` when that fails.
  std::optional<std::filesystem::path> find(const std::string& name);

  void discard(const std::string& name);

  /// Writes one frame, verifies it and notes its hash. Returns its file.
  std::filesystem::path put(const std::string& name, const Store::Write& write,
                            const Store::Verify& verify);

  /// Publishes the frames of these names, in this order, and nothing else. All must have been found
  /// or put.
  Receipt publish(const std::vector<std::string>& names);

  /// Removes the frames that are not published: what they were kept for is made.
  void drop();

 private:
  friend class Store;

  /// A frame that some process has drawn.
  struct Note {
    FrameReceipt frame;
    Maker maker;
  };
  /// One that is known to be whole, and where it lies.
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
  std::filesystem::path folder_;  ///< of the sequence in the making: frames/ and notes/
  std::mutex mutex_;              ///< of what follows
  std::map<std::string, std::uintmax_t> read_;  ///< notes' file → size when it was last read
  std::multimap<std::string, Note> notes_;      ///< by frame
  std::map<std::string, Found> found_;
};

}  // namespace mien::pipeline
