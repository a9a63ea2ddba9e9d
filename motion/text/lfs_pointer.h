#pragma once

#include <string_view>

namespace mien::motion {

/// Whether a file's bytes are what git keeps in place of a large file (git LFS).
inline bool is_lfs_pointer(std::string_view bytes) {
  return bytes.starts_with("version https://git-lfs.github.com/spec/");
}

}  // namespace mien::motion
