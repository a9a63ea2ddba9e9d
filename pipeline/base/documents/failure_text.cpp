#include "pipeline/base/documents/failure_text.h"

#include <new>
#include <stdexcept>

namespace mien::pipeline {

std::string failure_text(const std::exception& failure) {
  const bool is_memory = dynamic_cast<const std::bad_alloc*>(&failure) != nullptr ||
                         dynamic_cast<const std::length_error*>(&failure) != nullptr;
  if (!is_memory) return failure.what();
  return "not enough memory; provide more, or use smaller images, shorter motions or fewer --jobs";
}

}  // namespace mien::pipeline
