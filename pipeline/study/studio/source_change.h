#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "motion/error.h"
#include "pipeline/study/studio/document_change.h"
#include "pipeline/study/studio/source_tree.h"

namespace mien::pipeline {

/// Bytes [begin, end) of a text make way for others.
struct TextChange {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string text;
  Place place;  ///< of the value that it is about
};

/// How a change of the document is made in its text. Throws Error, with the place, where an alias
/// or a merge key is in the way, a value is used again by an alias, or comments would be lost.
TextChange text_change(std::string_view text, const SourceNode& root, const DocumentChange& change);

}  // namespace mien::pipeline
