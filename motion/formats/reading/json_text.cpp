#include "motion/formats/reading/json_text.h"

#include <nlohmann/json.hpp>

#include "motion/text/json_depth.h"
#include "motion/text/text_cursor.h"

namespace mien::motion {

namespace {

constexpr char get_it_again[] = "obtain or export the file again";

/// The text with NaN as an empty text of the same length, so that places stay the same.
std::string without_nan(std::string_view text) {
  std::string json(text);
  bool is_quoted = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (is_quoted && json[i] == '\\') {
      ++i;
    } else if (json[i] == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && json[i] == 'N' && json.compare(i, 3, "NaN") == 0) {
      json[i] = '"';
      json[++i] = '"';
      json[++i] = ' ';
    }
  }
  return json;
}

}  // namespace

nlohmann::json parse_json_text(std::string_view text, const std::string& file,
                               const std::string& what) {
  const TextCursor cursor = start_of(text, file);
  if (is_nested_deeper(cursor.text, max_json_depth))
    throw Error({file}, "lists nested more than " + std::to_string(max_json_depth) + " deep",
                "this is not the JSON of " + what);
  try {
    const bool has_nan = cursor.text.find("NaN") != std::string_view::npos;
    if (!has_nan) return nlohmann::json::parse(cursor.text.begin(), cursor.text.end());
    return nlohmann::json::parse(without_nan(cursor.text));
  } catch (const nlohmann::json::parse_error& error) {
    fail(cursor, error.byte == 0 ? 0 : error.byte - 1, "this is not the JSON of " + what,
         get_it_again);
  } catch (const nlohmann::json::out_of_range&) {
    throw Error({file}, "holds a number that is too large", get_it_again);
  }
}

}  // namespace mien::motion
