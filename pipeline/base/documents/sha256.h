#pragma once

#include <memory>
#include <string>
#include <string_view>

struct _GChecksum;

namespace mien::pipeline {

/// Incremental SHA-256 (FIPS 180-4), computed by GLib.
class Sha256 {
 public:
  Sha256();

  void add(std::string_view bytes);

  /// 64 hexadecimal digits of all that was added. Nothing may be added afterwards.
  std::string finish();

 private:
  std::unique_ptr<_GChecksum, void (*)(_GChecksum*)> sum_;
};

/// SHA-256 of `bytes`, 64 hexadecimal digits.
std::string sha256_of(std::string_view bytes);

}  // namespace mien::pipeline
