#pragma once

#include <stdexcept>

namespace mien::render {

/// The machine failed, not the user: a full disk, a broken file, a missing codec. The message
/// states the path and the library's error text.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mien::render
