#include <algorithm>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

/// The list of participants who failed attention checks.
std::string inattentive_html(const AnswerSet& answer_set) {
  std::vector<std::string> names;
  for (const Attention& own : answer_set.attention)
    if (own.is_excluded)
      names.push_back(
          fmt::format("{} ({} of {} checks passed)", own.participant, own.passed, own.checks));
  return names.empty() ? "" : html_paragraph("Excluded:") + html_list("", names);
}

/// How many took part, and where the others left.
std::string flow_html(const Results& results) {
  std::string rows;
  for (const FlowStage& one : results.flow)
    rows += HtmlRow().text(one.stage).number(one.sessions).html();
  if (rows.empty()) return "";
  return wide_table({"<participation", "sessions"}, rows) +
         "<p class=\"quiet\">Nothing is kept of people who refuse or withdraw; their numbers are "
         "on "
         "the experimenter’s page of a served study.</p>\n";
}

}  // namespace

std::string people_html(const Results& results) {
  const AnswerSet& answer_set = results.answer_set;
  std::string html =
      html_paragraph(people_sentence(answer_set) + "." +
                     (has_attention_checks(answer_set) ? " " + to_sentence(answer_set.rule) : ""));
  html += flow_html(results);
  html += results.rule_counts.empty() ? inattentive_html(answer_set) : flagged_people_html(results);
  html += html_list("", unfinished_sentences(answer_set));
  for (const std::string& note : answer_set.notes) html += html_paragraph(note);
  const std::string demographics = demographics_html(results);
  if (!demographics.empty())
    html += "<h3>Demographics of the participants analysed</h3>\n" + demographics;
  html += "<details><summary>All sessions</summary>\n" + sessions_html(results) + "</details>\n";
  return html;
}

}  // namespace mien::pipeline
