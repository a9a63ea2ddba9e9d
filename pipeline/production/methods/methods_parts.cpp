#include "pipeline/production/methods/methods_parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "pipeline/production/methods/references.h"

namespace mien::pipeline {

void MethodsText::say(const std::string& sentence) {
  if (!text_.ends_with("\n")) text_ += " ";
  text_ += sentence_start(sentence) + ".";
}

void MethodsText::quote(const std::string& text) {
  end_paragraph();
  text_ += "> ";
  const std::size_t end = text.find_last_not_of(" \n\t") + 1;
  for (const char letter : std::string_view(text).substr(0, end)) {
    text_ += letter;
    if (letter == '\n') text_ += "> ";
  }
  text_ += "\n\n";
}

void MethodsText::end_paragraph() { text_ += text_.ends_with(".") ? "\n\n" : ""; }

void MethodsText::begin_section(const std::string& heading) {
  end_paragraph();
  text_ += "# " + heading + "\n\n";
}

std::string MethodsText::cite(const Names& keys) {
  std::string cited, incomplete;
  for (const std::string& key : keys) {
    const Reference* reference = find_reference(key);
    if (reference == nullptr || reference->missing.empty()) {
      cited += (cited.empty() ? "@" : "; @") + key;
      add_once(cited_, key);
      continue;
    }
    add_once(incomplete_, key);
    const auto place = std::ranges::find(incomplete_, key) - incomplete_.begin();
    incomplete += fmt::format("{}source {} above", incomplete.empty() ? "" : "; ", place + 1);
  }
  return (cited.empty() ? "" : " [" + cited + "]") +
         (incomplete.empty() ? "" : " (" + incomplete + ")");
}

std::string MethodsText::text() const {
  if (incomplete_.empty()) return text_;
  std::string note = fmt::format(
      "> To be completed by the author of the study: {} not known well enough to be cited. Look {} "
      "up, and replace the {} in the text.",
      incomplete_.size() == 1 ? "the following work is" : "the following works are",
      incomplete_.size() == 1 ? "it" : "them", incomplete_.size() == 1 ? "number" : "numbers");
  for (std::size_t i = 0; i < incomplete_.size(); ++i)
    note += fmt::format(" Source {}: {}.", i + 1, find_reference(incomplete_[i])->missing);
  return note + "\n\n" + text_;
}

MethodWords words_of(motion::InterpolationMethod method) {
  using Method = motion::InterpolationMethod;
  static const std::vector<MethodWords> all = {
      {Method::reach,
       "a quadratic program that reaches the requested values exactly or as closely as possible, "
       "with weights as close as possible to those of a cardinal basis of linear and radial "
       "basis functions",
       {"rose1998", "sloan2001", "huang2010"}},
      {Method::cardinal,
       "a cardinal basis of linear and radial basis functions",
       {"rose1998", "sloan2001", "adjectives"}},
      {Method::nearest,
       "nearest neighbours among the examples and random blends of them",
       {"kovar2004"}},
      {Method::inverse_distance, "inverse distance weighting", {"shepard1968"}},
      {Method::grid, "multilinear interpolation on a regular grid", {"wiley1997"}},
      {Method::kriging, "kriging", {"mukai2005"}},
      {Method::pca, "a statistical model of the motions (principal components)", {"min2009"}},
      {Method::incremental, "incremental steps along adjectives", {"forger2012", "adjectives"}},
  };
  for (const MethodWords& one : all) {
    if (one.method == method) return one;
  }
  return {method, std::string(motion::name_of(method)) + " interpolation", {}};
}

std::string source_of(StyleMethod method) {
  static constexpr Words<StyleMethod> sources = {{"amaya1996", StyleMethod::amaya},
                                                 {"unuma1995", StyleMethod::unuma},
                                                 {"hsu2005", StyleMethod::hsu},
                                                 {"witkin1995", StyleMethod::witkin},
                                                 {"bruderlin1995", StyleMethod::waveshape},
                                                 {"bruderlin1995", StyleMethod::displacement},
                                                 {"shapiro2006", StyleMethod::shapiro},
                                                 {"neff2009", StyleMethod::neff}};
  return std::string(word_of(sources, method));
}

}  // namespace mien::pipeline
