#pragma once

#include <locale.h>

namespace mien::pipeline {

/// Sets the character set of the calling thread's locale to UTF-8 during the object's lifetime, so
/// that libarchive reads and writes file names as UTF-8 whatever the user's locale.
class Utf8Names {
 public:
  Utf8Names() : names_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (names_ != nullptr) before_ = ::uselocale(names_);
  }
  ~Utf8Names() {
    if (names_ == nullptr) return;
    ::uselocale(before_);
    ::freelocale(names_);
  }
  Utf8Names(const Utf8Names&) = delete;
  Utf8Names& operator=(const Utf8Names&) = delete;

 private:
  locale_t names_;
  locale_t before_ = nullptr;
};

}  // namespace mien::pipeline
