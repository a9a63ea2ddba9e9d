#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace mien::render {

/// SHA-256 of bytes that come piece by piece (FIPS 180-4), as FFmpeg's library of utilities works
/// it out.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void add(std::string_view bytes);

  /// 64 hexadecimal digits of all that was added. Nothing may be added afterwards.
  std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mien::render
