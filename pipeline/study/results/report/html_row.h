#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

// Numbers as printed on the page of results: with a typographic minus sign, and "–" for NaN.

/// "−0.25": with `digits` decimals
std::string decimal(double value, int digits = 2);
/// "[0.10, 0.42]"
std::string interval_text(double low, double high, int digits = 2);
/// "25 %" for 0.25
std::string percent_text(double share);
/// "[10, 42] %" for 0.10 and 0.42
std::string share_interval(double low, double high);
/// "< .001", ".034"
std::string p_text(double p);

/// "sad – happy"
std::string scale_name(const Scale& scale);

/// A row of an HTML table. Cells of `text` and `prose` are left-aligned and may wrap; numbers do
/// not. Contents are escaped.
class HtmlRow {
 public:
  HtmlRow& text(const auto&... plain) { return (add("text", plain), ..., *this); }
  HtmlRow& prose(const std::string& plain) { return add("prose", plain), *this; }
  /// Appends right-aligned cells: doubles with two decimals, integers, or text.
  HtmlRow& number(const auto&... shown) { return (add("", shown), ..., *this); }
  std::string html(bool is_significant = false) const;

 private:
  void add(std::string_view css_class, const std::string& plain);
  void add(std::string_view css_class, int count) { add(css_class, std::to_string(count)); }
  void add(std::string_view css_class, double value) { add(css_class, decimal(value)); }

  std::string cells_;
};

/// An HTML table that can be scrolled horizontally, also by keyboard, and has shadows at the edges
/// beyond which it goes on; empty if there are no rows. A "<" at the beginning of a
/// heading is not shown; it aligns the heading to the left, for a column of text.
std::string wide_table(const std::vector<std::string_view>& heads, const std::string& rows);

/// A paragraph of plain text.
std::string html_paragraph(const std::string& plain);

/// A table that is shown when its summary is opened; empty if there is no table.
std::string closed_table(const std::string& summary, const std::string& table);

}  // namespace mien::pipeline
