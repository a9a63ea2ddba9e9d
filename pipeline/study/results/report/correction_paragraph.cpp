#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

std::string correction_html(const AnswerSet& answer_set, const std::vector<std::string>& others,
                            bool has_overall) {
  std::string text = fmt::format(
      "All tests are two-sided with α = {:g}. Correction for multiple comparisons: {}, "
      "within each family of comparisons. In this section, the comparisons of all "
      "videos on all scales form one family. ",
      answer_set.alpha, name_of(answer_set.correction));
  if (!others.empty())
    text += fmt::format(
        "In the section{} “{}”, each kind of comparison forms two families: those on the intended "
        "emotion’s scale, and those on all other scales{}. ",
        others.size() == 1 ? "" : "s", fmt::join(others, "” and “"),
        has_overall ? "; in tables over all settings, the single emotions form one family, and the "
                      "row “all” is not corrected"
                    : "");
  text += others.empty()       ? "Rows"
          : others.size() == 1 ? "In both sections, rows"
                               : "In these three sections, rows";
  return html_paragraph(text + " marked * are significant by the paired t test after correction.");
}

}  // namespace mien::pipeline
