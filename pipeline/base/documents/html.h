#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace mien::pipeline {

// Parts of pages that are opened from disk, without a network and without scripts.

/// Text as HTML content or attribute value.
std::string html_escaped(std::string_view text);

/// An HTML list of plain texts; empty for no texts.
std::string html_list(std::string_view css_class, const std::vector<std::string>& texts);

/// A table from the HTML of its column headings and rows. A heading that begins with ">" marks a
/// column of numbers: the heading, without the ">", and the column's cells that are plain <td> tags
/// get the class "number", so that style sheets can align them.
std::string html_table(std::initializer_list<std::string_view> heads, const std::string& rows);

/// A vector drawing as an img element that contains it as a data URI. (Inline drawings on one page
/// would share the names of their glyphs.) `alternative` is the text shown if images are not.
std::string embedded_svg(std::string_view svg, std::string_view alternative);

/// Bytes in base64 (RFC 4648).
std::string in_base64(std::string_view bytes);

/// Bytes as a data URI: "data:image/png;base64,…".
std::string data_uri(std::string_view media_type, std::string_view bytes);

/// A complete English page from its plain title, style sheet and the HTML of its body. Links are
/// relative to `base`, or to the page's own location if that is empty.
std::string html_page(std::string_view title, std::string_view style, std::string_view body,
                      std::string_view base = "");

}  // namespace mien::pipeline
