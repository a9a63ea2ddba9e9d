#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

// Pieces of pages that work from disk, without a network and without scripts.

/// Text as HTML content or attribute value.
std::string html_escaped(std::string_view text);

/// A list of plain texts; empty without any.
std::string html_list(std::string_view css_class, const std::vector<std::string>& texts);

/// A table from the HTML of its heads and of its rows. A head that begins with ">" stands above
/// numbers: it and the cells below it have the class "number", for style sheets to align alike.
std::string html_table(std::initializer_list<std::string_view> heads, const std::string& rows);

/// A vector drawing as part of the page. A picture of its own, since glyphs of drawings in one page
/// would share their names.
std::string embedded_svg(std::string_view svg, std::string_view alternative);

/// Bytes in base64 (RFC 4648).
std::string in_base64(std::string_view bytes);

/// Bytes as an address: "data:image/png;base64,…".
std::string data_uri(std::string_view media_type, std::string_view bytes);

/// A whole page in English: its plain title, its style sheet and the HTML of its body. Links are
/// taken from `base`, or else from where the page lies.
std::string html_page(std::string_view title, std::string_view style, std::string_view body,
                      std::string_view base = "");

}  // namespace mien::pipeline
