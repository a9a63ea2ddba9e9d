#pragma once

#include <string_view>

#include "pipeline/study/studio/source_tree.h"

namespace mien::pipeline {

/// Finds where the values of a tree begin behind their anchors and tags (`content`), where they
/// end, and which are in brackets. The parser tells where they begin, and no more.
///
/// Of forms that it does not know (keys behind "?", elements without a value) positions are wrong:
/// whatever is written with their help is read again and compared (manifest_edit.h).
void find_ends(std::string_view text, SourceNode& root);

}  // namespace mien::pipeline
