#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "motion/formats/fbx/fbx_document.h"

namespace mien::motion {

/// One value of a node.
struct FbxValue {
  enum class Kind { integer, number, text, raw, array };
  Kind kind = Kind::integer;
  std::int64_t integer = 0;  ///< of integers; of numbers the value without decimals
  double number = 0.0;       ///< of integers and numbers
  /// Of texts, as in the file; of raw bytes, arrays and single bytes of binary files (which may be
  /// letters), the bytes; of other numbers empty.
  std::string_view text;
};

/// An array of a binary file. `count` 0 with type 0 means that there is none.
struct FbxArray {
  char type = 0;  ///< f float, d double, l int64, i int32, b bool, c byte
  bool is_deflated = false;
  std::uint64_t count = 0;
  std::string_view stored;  ///< deflated or plain

  std::uint64_t inflated_bytes() const;
};

/// Bytes of the binary value at the start of `bytes`; 0 if its type is unknown or it is cut off.
std::size_t binary_value_size(std::string_view bytes);

/// The array at the start of `bytes`, which `binary_value_size` has accepted; no array if the value
/// is another one.
FbxArray binary_array(std::string_view bytes);

/// Reads the values of a node one after the other.
struct FbxValueCursor {
  const FbxDocument& document;
  std::string_view rest;
  std::uint32_t left = 0;  ///< values still to come, of binary files
};

FbxValueCursor values_of(const FbxDocument& document, std::uint32_t node);

/// The next value; empty after the last one. In text files, bare words are texts, and `*3` before
/// an array is skipped. Throws mien::Error for what is no value.
std::optional<FbxValue> next_value(FbxValueCursor& cursor);

/// The value of that index (from 0); empty if there are fewer.
std::optional<FbxValue> value_at(const FbxDocument& document, std::uint32_t node, int index);

/// The value of that index as a whole number (0 if it is missing). Throws mien::Error for a text.
std::int64_t integer_of(const FbxDocument& document, std::uint32_t node, int index);

/// The value of that index as a finite number (0 if it is missing). Throws mien::Error otherwise.
double number_of(const FbxDocument& document, std::uint32_t node, int index);

/// The value of that index as a text as in the file, empty if it is missing or no text.
std::string_view text_of(const FbxDocument& document, std::uint32_t node, int index);

/// A text for people: `&quot;` of text files as a quotation mark.
std::string decoded(const FbxDocument& document, std::string_view text);

}  // namespace mien::motion
