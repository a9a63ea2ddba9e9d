#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace mien::test {

/// Folder of the real motion capture: $MIEN_DATA, else ../shared/data beside the project. Empty
/// when there is none; a test that needs it then skips and says so.
inline std::optional<std::filesystem::path> real_data() {
  const char* named = std::getenv("MIEN_DATA");
  const std::filesystem::path folder =
      named ? std::filesystem::path(named)
            : std::filesystem::path(MIEN_SOURCE_DIR) / ".." / "shared" / "data";
  if (std::filesystem::is_directory(folder / "mocap")) return folder;
  return std::nullopt;
}

}  // namespace mien::test
