#include <algorithm>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

std::string rules_html(const Results& results) {
  std::string rows;
  for (const RuleCount& count : results.rule_counts)
    rows += HtmlRow()
                .text(count.rule.empty() ? "" : count.rule + ": " + count.bound)
                .prose(count.words)
                .number(count.is_examined ? std::to_string(count.participants) : "not examined",
                        count.is_examined ? std::to_string(count.answers) : "–")
                .html();
  return wide_table({"<rule", "<flags", "participants", "answers"}, rows);
}

std::string flags_html(const Results& results) {
  std::string rows;
  for (const ListedFlag& one : results.quality_flags)
    rows += HtmlRow()
                .text(one.participant)
                .number(one.trial == 0 ? "" : std::to_string(one.trial))
                .text(one.stimulus, one.against, one.item, one.flag.reason,
                      one.is_excluded ? "excluded" : "included")
                .html();
  return wide_table({"<participant", "trial", "<video", "<reference", "<item", "<reason", "<"},
                    rows);
}

bool is_of_grid(const StatedRule& rule) {
  return rule.rule == QualityRule::hidden_reference || rule.rule == QualityRule::anchor;
}

}  // namespace

std::string quality_html(const Results& results) {
  const std::string rules = rules_html(results);
  if (rules.empty()) return "";
  const AnswerSet& answer_set = results.answer_set;
  const QualityRules& stated = answer_set.quality.rules;
  std::string html = "<p>";
  if (!has_no_rules(stated))
    html += stated.flagged == FlaggedAnswers::excluded
                ? "The rules that the manifest states. Flagged answers, and all answers of flagged "
                  "participants, are excluded from the results. "
                : "The rules that the manifest states. Flagged answers and participants are "
                  "included in the results" +
                      std::string(has_attention_checks(answer_set)
                                      ? ", except participants who failed attention checks. "
                                      : ". ");
  if (std::ranges::any_of(answer_set.quality.stated, is_of_grid))
    html += fmt::format(
        "hidden_reference and anchor are the post-screening of ITU-R BS.1534-3; participants whom "
        "it flags are {} the results. ",
        stated.post_screening == FlaggedAnswers::excluded ? "excluded from" : "included in");
  html +=
      "Answers are those to analysed trials, including those of flagged participants; participants "
      "are those who are flagged or some of whose answers are. All data, with their flags, are in "
      "data/.</p>\n" +
      rules;
  const std::string flags = flags_html(results);
  if (!flags.empty()) html += "<details><summary>All flags</summary>\n" + flags + "</details>\n";
  return html;
}

std::string flagged_people_html(const Results& results) {
  std::vector<std::string> excluded, included;
  const QualityFlags& quality = results.answer_set.quality;
  for (const auto& [participant, flags] : quality.participants)
    (quality.leaves_out(participant) ? excluded : included)
        .push_back(fmt::format("{} ({})", participant, reasons_text(flags)));
  std::string html;
  if (!excluded.empty()) html += "<p>Excluded:</p>\n" + html_list("", excluded);
  if (!included.empty()) html += "<p>Flagged, but included:</p>\n" + html_list("", included);
  return html;
}

}  // namespace mien::pipeline
