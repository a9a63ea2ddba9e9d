#include <algorithm>
#include <regex>
#include <string>

#include "pipeline/base/documents/html.h"
#include "pipeline/production/methods/methods.h"
#include "pipeline/production/methods/references.h"

namespace mien::pipeline {

namespace {

/// "Rose, Cohen and Bodenheimer 1998; …" for "@rose1998; …". Empty for the program itself, which is
/// named where it is cited.
std::string labels_of(const std::string& keys) {
  static const std::regex key("@(\\w+)");
  std::string labels;
  for (std::sregex_iterator at(keys.begin(), keys.end(), key), end; at != end; ++at) {
    const Reference* reference = find_reference((*at)[1].str());
    if (reference == nullptr) continue;
    labels += (labels.empty() ? "" : "; ") + std::string(reference->label);
  }
  return labels;
}

/// "[@rose1998]" becomes "(Rose, Cohen and Bodenheimer 1998)".
std::string with_labels(const std::string& text) {
  static const std::regex citation(R"( \[(@[\w; @]+)\])");
  std::string result;
  auto rest = text.cbegin();
  for (std::sregex_iterator at(text.begin(), text.end(), citation), end; at != end; ++at) {
    result.append(rest, (*at)[0].first);
    const std::string labels = labels_of((*at)[1]);
    if (!labels.empty()) result += " (" + labels + ")";
    rest = (*at)[0].second;
  }
  result.append(rest, text.cend());
  return result;
}

/// Lines without their "> "; empty ones end paragraphs, which are told apart by a space alone.
std::string unquoted(const std::string& part) {
  static const std::regex mark("(^|\n)> ?");
  return std::regex_replace(part, mark, "$1");
}

}  // namespace

std::string methods_html(const std::string& markdown) {
  std::string html;
  std::size_t start = 0;
  bool is_first_heading = true;  // which the page has itself
  while (start < markdown.size()) {
    const std::size_t end = std::min(markdown.find("\n\n", start), markdown.size());
    std::string part = markdown.substr(start, end - start);
    start = end + 2;
    while (part.ends_with('\n')) part.pop_back();
    if (part.starts_with("# ")) {
      if (!is_first_heading) html += "<h3>" + html_escaped(part.substr(2)) + "</h3>\n";
      is_first_heading = false;
    } else if (!part.empty()) {
      const bool is_note = part.starts_with("> ");
      const std::string text = html_escaped(with_labels(is_note ? unquoted(part) : part));
      html += is_note ? "<blockquote><p>" + text + "</p></blockquote>\n" : "<p>" + text + "</p>\n";
    }
  }
  return html;
}

}  // namespace mien::pipeline
