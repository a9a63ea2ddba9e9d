#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "pipeline/tasks/store.h"

namespace mien::pipeline {

/// State shared by a Store and its FrameStores.
struct Store::State {
  State(std::filesystem::path at, Sharing sharing);
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  std::filesystem::path internal() const { return folder / ".mien"; }
  const std::string& worker() const { return heartbeat.self().name; }
  Maker self() const { return {heartbeat.self().host, heartbeat.self().instruction_set}; }

  /// Calls `work` with a new empty folder that no other attempt uses, and removes it afterwards.
  /// Throws DiskFault if the study's folder has disappeared or is on another disk now, or if the
  /// disk is the reason why `work` failed (checked before the attempt's files are removed, since
  /// that frees space).
  void in_attempt(const std::function<void(const std::filesystem::path& attempt)>& work);

  /// Moves an attempt's file or folder to the artifact's path and then writes and returns its
  /// receipt. If an intact artifact with the same key has been published before, that artifact
  /// stays and its receipt is returned.
  Receipt publish(const std::filesystem::path& attempt, Receipt receipt);

  /// Notes nondeterminism when the hashes differ.
  void compare(const std::string& path, const Hash& before, const Maker& before_by,
               const Hash& now);

  void note_repair(std::string text);

  /// Creates the parent folders of `path`, which is relative to the study's folder. Files in place
  /// of these folders, and an entry of the wrong kind at the path itself, are set aside, since they
  /// may be the user's own.
  void clear_path_for(const std::string& path, bool for_folder);

  std::filesystem::path folder;
  WorkerHeartbeat heartbeat;
  const std::uint64_t disk;  ///< device number of the disk that holds the folder
  WorkerWatch watch;
  std::atomic<int> attempts = 0;
  mutable std::mutex mutex;
  std::vector<Nondeterminism> nondeterminism;
  std::set<std::string> repairs;

 private:
  void refuse_other_workers(Sharing sharing);
  void refuse_missing_folder() const;
  std::filesystem::path new_attempt();
  void move_into_place(const std::filesystem::path& attempt, const Receipt& receipt);
  void write_receipt(const Receipt& receipt);
  std::filesystem::path new_aside();
  void set_aside(const std::filesystem::path& obstacle);
  void set_aside_foreign(const Receipt& next);
};

}  // namespace mien::pipeline
