#pragma once

#include <string_view>

namespace mien::motion {

/// A cell of a table of numbers.
struct TableCell {
  enum Kind { number, missing, text };
  Kind kind = missing;
  double value = 0.0;  ///< of a number
};

/// The decimal marks that numbers of a table were found to have.
struct DecimalMarks {
  bool may_be_commas = false;  ///< commas do not separate the fields
  bool has_commas = false;
  bool has_points = false;

  /// "1.234" beside "1,5" may be a thousand or one and a quarter.
  bool are_mixed() const { return has_commas && has_points; }
};

/// A field, without blanks at its ends, as a finite number between −1e12 and 1e12, as missing
/// (empty, NaN, NA, n/a, #N/A, null or none, in upper or lower case), or else as a text. Infinities
/// are texts. Notes the decimal mark in `marks` if it may be a comma.
TableCell read_cell(std::string_view field, DecimalMarks& marks);

}  // namespace mien::motion
