#pragma once

#include <string>

#include "render/error.h"

namespace mien::render {

/// Throws Error, with both sizes, when two pictures cannot be compared pixel by pixel.
template <class Picture>
void require_same_size(const Picture& a, const Picture& b) {
  const auto size_text = [](const Picture& picture) {
    return std::to_string(picture.width) + " x " + std::to_string(picture.height);
  };
  if (a.width != b.width || a.height != b.height)
    throw Error("the pictures differ in size: " + size_text(a) + " and " + size_text(b) +
                " pixels");
  if (a.width < 1 || a.height < 1) throw Error("the pictures have no pixels");
}

}  // namespace mien::render
