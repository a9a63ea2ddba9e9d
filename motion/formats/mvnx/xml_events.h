#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "motion/text/text_cursor.h"

namespace mien::motion {

/// The attributes of a tag.
class XmlAttributes {
 public:
  /// Names and values in turn, as expat gives them; ends with a null pointer.
  XmlAttributes(const char* const* list = nullptr) : list_(list) {}

  /// The value of the attribute of that name; empty if there is none.
  std::string of(std::string_view name) const {
    for (const char* const* at = list_; at != nullptr && *at != nullptr; at += 2) {
      if (name == *at) return at[1];
    }
    return "";
  }

 private:
  const char* const* list_;
};

/// What is done with the parts of an XML text, in their order.
class XmlEvents {
 public:
  virtual ~XmlEvents() = default;

  /// A start tag. Its name is without a prefix ("mvn:frame" is "frame"); `place` is its index in
  /// the text.
  virtual void start(std::string_view name, const XmlAttributes& attributes, size_t place) = 0;

  /// Characters between tags, perhaps in several pieces.
  virtual void text(std::string_view characters) = 0;

  /// An end tag.
  virtual void end() = 0;
};

/// Parses an XML text (XML 1.0, by expat) and calls `events` as it goes; what they throw is thrown.
/// A document type is refused, because it can define entities that expand to any size or name other
/// files. Memory does not grow with the text, apart from what `events` keep.
///
/// Throws mien::Error with line and column if the text is not well-formed.
void parse_xml(const TextCursor& cursor, XmlEvents& events);

}  // namespace mien::motion
