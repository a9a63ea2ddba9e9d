#pragma once

#include <string>
#include <string_view>

#include "motion/error.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

/// A parsing position in a text. Lines end with LF, CR LF or CR.
struct TextCursor {
  std::string_view text;
  std::string file;    ///< name for error messages
  size_t at = 0;       ///< index of the next character
  int first_line = 1;  ///< number of the line that the text begins with
};

/// A cursor at the start of the text, after a UTF-8 byte order mark if present.
TextCursor start_of(std::string_view text, std::string file);

/// Line and column (in characters, not bytes) of an index.
Place place_at(const TextCursor& cursor, size_t index);

/// Throws mien::Error with the place of the index. Where the word there is the last of the text,
/// and no line end follows, it may have been cut, and the error says so, too.
[[noreturn]] void fail(const TextCursor& cursor, size_t index, std::string_view wrong,
                       std::string_view remedy);

/// Whether two words are equal, ignoring the case of ASCII letters.
bool same_word(std::string_view a, std::string_view b);

bool at_end(const TextCursor& cursor);
bool at_line_end(const TextCursor& cursor);

void skip_blanks(TextCursor& cursor);  ///< within the line
void skip_space(TextCursor& cursor);   ///< including line ends
void skip_line(TextCursor& cursor);    ///< to the next line's start

/// The next word, on any line; a brace is a separate word. Empty at the end.
std::string_view next_word(TextCursor& cursor);

/// The next word of this line, in which braces are ordinary characters; empty if there is none.
std::string_view next_word_on_line(TextCursor& cursor);

/// The next word, which must be a finite number between −1e12 and 1e12; `meaning` describes it for
/// the error message ("a channel of frame 3"). Throws mien::Error.
double parse_number(TextCursor& cursor, std::string_view meaning);

/// The next word, which must be a whole number from 0 to 2^31 − 1. Throws mien::Error.
long parse_count(TextCursor& cursor, std::string_view meaning);

}  // namespace mien::motion
