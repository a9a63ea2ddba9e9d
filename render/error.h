#pragma once

#include <stdexcept>

namespace mien::render {

/// Files, pictures or libraries do not permit what was asked for: a full disk, a damaged file, a
/// missing codec, pictures of different sizes. The message states the reason and, if there is one,
/// the file.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mien::render
