#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

/// What the trials ask and how d′ is determined.
std::string detection_method(const TrialForm& form) {
  if (&form == &same_different_form)
    return "Participants say whether two stimuli are the same or different. A hit is “different” "
           "to "
           "two different stimuli, a false alarm “different” to the same stimulus shown twice; "
           "for a pair, false alarms are those to its two stimuli. d′ is that of the differencing "
           "model (Macmillan and Creelman 2005, chapter 9): the answer is “different” if the "
           "observations of the two stimuli differ by more than the criterion. Intervals: profile "
           "likelihood, beginning with 0 if the answers to same and different pairs do not differ "
           "enough.";
  if (&form == &two_interval_form)
    return "Participants say which of two stimuli, shown one after the other, has the signal. A "
           "hit "
           "is “the first” to pairs with the signal in the first interval, a false alarm “the "
           "first” to the others. d′ = (z(H) − z(F))/√2 (Macmillan and Creelman 2005, chapter 7); "
           "the criterion c = −(z(H) + z(F))/2 is positive if the second interval is preferred. "
           "Intervals: ± 1.96 standard errors (Gourevitch and Galanter 1967).";
  return "Participants say whether a stimulus has the signal. A hit is “yes” to a stimulus with "
         "the "
         "signal, a false alarm “yes” to one without it. d′ = z(H) − z(F) and the criterion c = "
         "−(z(H) + z(F))/2, positive if “no” is preferred (Macmillan and Creelman 2005, chapters 1 "
         "and 2). Intervals: ± 1.96 standard errors (Gourevitch and Galanter 1967).";
}

std::string detection_name(const AnswerSet& answer_set, const DetectionResult& one) {
  if (one.person) return answer_set.people[*one.person];
  if (!one.stimulus) return "all answers";
  const std::string& name = answer_set.stimuli[*one.stimulus].id;
  return one.other ? name + " – " + answer_set.stimuli[*one.other].id : name;
}

std::string detection_table(const Results& results, std::string_view head, auto is_listed) {
  std::string rows;
  for (const DetectionResult& one : results.detection.rows) {
    if (!is_listed(one)) continue;
    const DetectionRates rates = log_linear_rates(one.counts);
    const Sensitivity& found = one.sensitivity;
    rows += HtmlRow()
                .text(detection_name(results.answer_set, one))
                .number(fmt::format("{} of {}", one.counts.hits, one.counts.signal_trials),
                        fmt::format("{} of {}", one.counts.false_alarms, one.counts.noise_trials),
                        rates.hit, rates.false_alarm, percent_text(one.correct()), found.d,
                        interval_text(found.d_ends.low, found.d_ends.high), found.criterion,
                        interval_text(found.criterion_ends.low, found.criterion_ends.high))
                .html();
  }
  return wide_table({head, "hits", "false alarms", "H", "F", "correct", "d′", "95 % interval",
                     "criterion", "95 % interval"},
                    rows);
}

}  // namespace

std::string detection_section_html(const Results& results, const std::string& figures) {
  const DetectionResults& found = results.detection;
  if (found.rows.empty()) return "";
  const TrialForm& form = *results.answer_set.form;
  std::string html =
      html_paragraph(detection_method(form)) +
      html_paragraph(
          "H and F are rates with the log-linear correction (Hautus 1995): 0.5 is added to the "
          "number of hits and of false alarms and 1 to the numbers of trials, whatever they are, "
          "so "
          "that d′ is always finite. “Correct” is the mean of the shares of right answers to both "
          "kinds of trials, without correction. The intervals treat all answers as "
          "independent; that of “all answers” is too narrow if participants differ, and pooled "
          "rates give a smaller d′ than the mean of different participants.") +
      figures;
  if (found.people > 1)
    html += html_paragraph(fmt::format(
        "Mean d′ of {} participants: {}, 95 % interval {} (Student; participants are independent).",
        found.people, decimal(found.mean_d),
        interval_text(found.mean_ends.low, found.mean_ends.high)));
  html +=
      detection_table(results, "<", [](const auto& one) { return !one.person && !one.stimulus; });
  html += detection_table(results, form.stimuli > 1 ? "<pair" : "<stimulus",
                          [](const auto& one) { return one.stimulus.has_value(); });
  html += "<details><summary>All participants</summary>\n" +
          detection_table(results, "<participant",
                          [](const auto& one) { return one.person.has_value(); }) +
          "</details>\n";
  return html;
}

}  // namespace mien::pipeline
