#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace mien {

/// A position in a file. `line` and `column` count from 1; 0 means unknown.
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// "file:line:column", omitting unknown parts.
std::string to_string(const Place& place);

/// An error in the user's input: a file, a manifest, an option.
///
/// `what()` reads "file:line:column: what is wrong; how to fix it". The command line returns exit
/// code 2 for it.
class Error : public std::runtime_error {
 public:
  Error(Place place, std::string_view wrong, std::string_view remedy);
  Error(std::string_view wrong, std::string_view remedy) : Error(Place{}, wrong, remedy) {}

  const Place& place() const { return place_; }

 private:
  Place place_;
};

}  // namespace mien
