#include "pipeline/study/results/report/html_row.h"

#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"

namespace mien::pipeline {

std::string decimal(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const std::string text = fmt::format("{:.{}f}", std::abs(value), digits);
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0.0 && !is_zero ? "−" + text : text;
}

std::string interval_text(double low, double high, int digits) {
  return std::isnan(low) ? "–"
                         : fmt::format("[{}, {}]", decimal(low, digits), decimal(high, digits));
}

std::string percent_text(double share) {
  return std::isnan(share) ? "–" : decimal(100.0 * share, 0) + " %";
}

std::string share_interval(double low, double high) {
  return fmt::format("[{}, {}] %", decimal(100.0 * low, 0), decimal(100.0 * high, 0));
}

std::string p_text(double p) {
  if (std::isnan(p)) return "–";
  if (p < 0.001) return "< .001";
  const std::string text = fmt::format("{:.3f}", p);
  return text.starts_with('0') ? text.substr(1) : text;
}

std::string scale_name(const Scale& scale) { return scale.low + " – " + scale.high; }

std::string HtmlRow::html(bool is_significant) const {
  return (is_significant ? "<tr class=\"found\">" : "<tr>") + cells_ + "</tr>\n";
}

void HtmlRow::add(std::string_view css_class, const std::string& plain) {
  cells_ += css_class.empty() ? "<td>" : fmt::format("<td class=\"{}\">", css_class);
  cells_ += html_escaped(plain) + "</td>";
}

std::string wide_table(const std::vector<std::string_view>& heads, const std::string& rows) {
  if (rows.empty()) return "";
  std::string html = "<div class=\"wide\" tabindex=\"0\"><table><thead><tr>";
  for (const std::string_view head : heads)
    html += head.starts_with('<') ? fmt::format("<th class=\"text\">{}</th>", head.substr(1))
                                  : fmt::format("<th>{}</th>", head);
  return html + "</tr></thead>\n<tbody>" + rows + "</tbody></table></div>\n";
}

std::string html_paragraph(const std::string& plain) {
  return "<p>" + html_escaped(plain) + "</p>\n";
}

std::string closed_table(const std::string& summary, const std::string& table) {
  if (table.empty()) return "";
  return "<details><summary>" + html_escaped(summary) + "</summary>\n" + table + "</details>\n";
}

}  // namespace mien::pipeline
