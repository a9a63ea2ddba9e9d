#include "pipeline/base/documents/html.h"

#include <cctype>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

bool is_head_of_numbers(std::string_view head) { return head.starts_with('>'); }

/// Rows in which the plain cells of number columns get the class "number".
std::string with_numbers_marked(std::string_view rows,
                                std::initializer_list<std::string_view> heads) {
  std::string marked;
  std::size_t column = 0;
  while (!rows.empty()) {
    const bool is_row = rows.starts_with("<tr");
    const bool is_cell = !is_row && (rows.starts_with("<td") || rows.starts_with("<th"));
    if (is_row) column = 0;
    const bool is_number =
        is_cell && column < heads.size() && is_head_of_numbers(heads.begin()[column]);
    if (is_cell) ++column;
    const bool is_marked = is_number && rows.starts_with("<td>");
    marked += is_marked ? "<td class=\"number\">" : rows.substr(0, 1);
    rows.remove_prefix(is_marked ? 4 : 1);
  }
  return marked;
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string html_list(std::string_view css_class, const std::vector<std::string>& texts) {
  if (texts.empty()) return "";
  std::string list = fmt::format("<ul class=\"{}\">\n", css_class);
  for (const std::string& text : texts) list += "<li>" + html_escaped(text) + "</li>\n";
  return list + "</ul>\n";
}

std::string html_table(std::initializer_list<std::string_view> heads, const std::string& rows) {
  std::string table = "<table><thead><tr>";
  for (const std::string_view head : heads)
    table += is_head_of_numbers(head) ? fmt::format("<th class=\"number\">{}</th>", head.substr(1))
                                      : fmt::format("<th>{}</th>", head);
  return table + "</tr></thead>\n<tbody>" + with_numbers_marked(rows, heads) + "</tbody></table>\n";
}

std::string embedded_svg(std::string_view svg, std::string_view alternative) {
  std::string encoded;
  for (const char c : svg) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                          std::string_view(" .,-_:;/=()").find(c) != std::string_view::npos;
    if (is_plain) {
      encoded += c;
    } else {
      encoded += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return fmt::format("<img loading=\"lazy\" src=\"data:image/svg+xml,{}\" alt=\"{}\">\n", encoded,
                     html_escaped(alternative));
}

std::string in_base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view three = bytes.substr(i, 3);
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8U | (k < three.size() ? static_cast<unsigned char>(three[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= three.size() ? digits[bits >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

std::string data_uri(std::string_view media_type, std::string_view bytes) {
  return fmt::format("data:{};base64,{}", media_type, in_base64(bytes));
}

std::string html_page(std::string_view title, std::string_view style, std::string_view body,
                      std::string_view base) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n{}"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      base.empty() ? "" : fmt::format("<base href=\"{}\">\n", base), html_escaped(title), style,
      body);
}

}  // namespace mien::pipeline
