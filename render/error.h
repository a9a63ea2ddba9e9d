#pragma once

#include <stdexcept>

namespace mien::render {

/// The machine failed, not the user: a full disk, a broken file, a missing codec. The message names
/// the path and what the library said.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mien::render
