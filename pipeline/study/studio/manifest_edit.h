#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/base/documents/environment.h"
#include "pipeline/study/studio/document_change.h"

namespace mien::pipeline {

/// What a manifest's text says, members in the order in which they are written. Throws Faults for
/// what is no YAML; what the schema says of it is not looked at.
nlohmann::ordered_json document_of(std::string_view text, const std::string& file,
                                   const Environment& environment);

/// The text with the changes made, one after the other: lines that they do not touch stay as they
/// are to the last byte, comments, order, anchors, quotes and indentation included. What comes out
/// is read again, and says what was to be said and nothing else.
///
/// Throws Error, with the place, for what cannot be changed so: values behind an alias or a merge
/// key, values that an alias uses elsewhere, comments that would be lost between two members, and
/// forms of YAML that are not known here. `file` is what the text is called.
std::string edited(std::string text, const std::string& file,
                   const std::vector<DocumentChange>& changes, const Environment& environment);

}  // namespace mien::pipeline
