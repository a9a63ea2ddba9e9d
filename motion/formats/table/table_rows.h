#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "motion/text/text_cursor.h"

namespace mien::motion {

/// Largest number of fields in a row of a table of points.
inline constexpr std::size_t most_table_fields = 262'144;

/// The character that separates the fields of a table, by its first lines: a tab, a semicolon or a
/// comma. Semicolons come before commas, because with them numbers may have decimal commas. A
/// comma if there is none of them.
char separator_of(std::string_view text);

/// Whether lines that begin with '#' are comments.
enum class TableComments { skipped, none };

/// The rows of a table as text, one after another (RFC 4180, with any of the three separators).
///
/// - Lines end with LF, CR LF or CR. Empty lines and lines that begin with '#' are skipped; a cell
///   "#N/A" begins no comment.
/// - Blanks around a field do not belong to it. A field in double quotes may contain separators,
///   line ends and, doubled, quotes.
class TableRows {
 public:
  TableRows(std::string_view text, std::string file, char separator,
            TableComments comments = TableComments::skipped);

  /// Goes to the next row; false at the end. Throws mien::Error for a quote that is not closed, for
  /// text after a closing quote, and for more than `most_table_fields` fields.
  bool next();

  /// The fields of the row, valid until the next call of `next` or `go_to`.
  const std::vector<std::string_view>& fields() const { return fields_; }
  /// A field of the row; empty beyond its end.
  std::string_view field(std::size_t index) const {
    return index < fields_.size() ? fields_[index] : std::string_view();
  }

  char separator() const { return separator_; }
  const TextCursor& cursor() const { return cursor_; }
  std::size_t row_start() const { return row_start_; }  ///< index of the row in the text
  std::size_t position() const { return cursor_.at; }   ///< index of what follows the row
  void go_to(std::size_t position) { cursor_.at = position; }
  /// Index in the text where a field begins, or that of the row for a field beyond its end.
  std::size_t start_of_field(std::size_t index) const {
    return index < starts_.size() ? starts_[index] : row_start_;
  }
  /// The last comment before the row, without '#'; empty if there is none.
  std::string_view comment() const { return comment_; }

  [[noreturn]] void refuse(std::size_t field, std::string_view wrong,
                           std::string_view remedy) const;

 private:
  bool skip_to_row();
  void take_field();
  std::string_view quoted_field();
  std::string_view plain_field();

  TextCursor cursor_;
  char separator_;
  TableComments comments_;
  std::size_t row_start_ = 0;
  std::string_view comment_;
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> starts_;
  std::deque<std::string> unescaped_;  ///< fields that contain doubled quotes
};

}  // namespace mien::motion
