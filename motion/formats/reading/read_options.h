#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mien::motion {

/// What a reader of recordings is told besides the file. Empty: as the file says.
struct ReadOptions {
  std::optional<std::string> take{};          ///< name of one of several motions
  std::optional<std::string> subject{};       ///< name or number, from 1, of one of several people
  std::optional<double> frames_per_second{};  ///< of files that do not state their rate
  std::vector<std::string> joints;            ///< names of the points, for files without names
  /// The user's own SMPL model (.npz), which gives the body of SMPL motions (smpl_model.h). Empty:
  /// none.
  std::filesystem::path body_model;

  friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

}  // namespace mien::motion
