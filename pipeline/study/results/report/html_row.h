#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/ratings/scales/scales.h"

namespace mien::pipeline {

// Numbers as the page of results prints them: with a true minus sign, and "–" for what is not
// known.

std::string decimal(double value, int digits = 2);
std::string interval_text(double low, double high, int digits = 2);
std::string percent_text(double share);
std::string share_interval(double low, double high);
/// "< .001", ".034"
std::string p_text(double p);

/// "sad – happy"
std::string scale_name(const Scale& scale);

/// A row of cells; those of `text` and `prose` are set left, and prose may break.
class HtmlRow {
 public:
  HtmlRow& text(const auto&... plain) { return (add("text", plain), ..., *this); }
  HtmlRow& prose(const std::string& plain) { return add("prose", plain), *this; }
  /// Numbers of two decimals, whole ones, or as they are written already.
  HtmlRow& number(const auto&... shown) { return (add("", shown), ..., *this); }
  std::string html(bool is_significant = false) const;

 private:
  void add(std::string_view css_class, const std::string& plain);
  void add(std::string_view css_class, int count) { add(css_class, std::to_string(count)); }
  void add(std::string_view css_class, double value) { add(css_class, decimal(value)); }

  std::string cells_;
};

/// A table that may be wider than the page; nothing without rows. Heads that begin with "<" are of
/// columns of text.
std::string wide_table(const std::vector<std::string_view>& heads, const std::string& rows);

}  // namespace mien::pipeline
