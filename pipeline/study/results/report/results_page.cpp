#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/results/report/html_row.h"
#include "pipeline/study/results/report/page_style.h"
#include "pipeline/study/results/report/page_tables.h"
#include "pipeline/study/results/report/results_report.h"

namespace mien::pipeline {

namespace {

/// Collects the sections that are not empty.
class PageParts {
 public:
  PageParts(const Results& results, const std::vector<ResultFigure>& figures)
      : simulated_(results.answer_set.simulated), figures_(figures) {}

  void section(const std::string& id, const std::string& title, const std::string& html) {
    if (html.empty()) return;
    nav_ += fmt::format("<a href=\"#{}\">{}</a>\n", id, html_escaped(title));
    body_ +=
        fmt::format("<section id=\"{}\">\n<h2>{}{}</h2>\n{}</section>\n", id, html_escaped(title),
                    simulated_ ? " <span class=\"mark\">simulated</span>" : "", html);
  }

  /// The figures of a section.
  std::string figures(const std::string& section) const {
    std::string html;
    for (const ResultFigure& figure : figures_) {
      if (figure.section != section) continue;
      html += "<figure>\n" + embedded_svg(as_svg(figure.plot), figure.plot.title);
      html += fmt::format("<figcaption>{} Files: {}</figcaption>\n</figure>\n",
                          html_escaped(figure.caption), links(figure.name));
    }
    return html;
  }

  std::string nav() const { return "<nav>\n" + nav_ + "</nav>\n"; }
  const std::string& body() const { return body_; }

 private:
  static std::string links(const std::string& name) {
    return fmt::format(
        "<a href=\"figures/{0}.pdf\">PDF</a>, <a href=\"figures/{0}.svg\">SVG</a>, "
        "<a href=\"figures/{0}.png\">PNG</a>.",
        name);
  }

  bool simulated_;
  const std::vector<ResultFigure>& figures_;
  std::string nav_, body_;
};

std::string heading(const std::string& plain) { return "<h3>" + html_escaped(plain) + "</h3>\n"; }

std::size_t judged_stimuli(const AnswerSet& answer_set) {
  std::set<std::size_t> judged;
  for (const AnalysedRating& rating : answer_set.ratings) judged.insert(rating.stimulus);
  for (const AnalysedChoice& choice : answer_set.chosen) judged.insert(choice.stimulus);
  for (const AnalysedPreference& pair : answer_set.preferences)
    judged.insert({pair.chosen, pair.other});
  std::set<std::string> in_words;
  for (const Remark& words : answer_set.words) in_words.insert(words.stimulus);
  return std::max(judged.size(), in_words.size());
}

/// "−2", "0.5"
std::string scale_value(double value) {
  return fmt::format("{}{:g}", value < 0.0 ? "−" : "", std::abs(value));
}

/// What a unit of the ratings is, if all scales have the same range.
std::string units_html(const AnswerSet& answer_set) {
  if (answer_set.ratings.empty()) return "";
  const Scale& first = answer_set.scales.front();
  const auto has_same_range = [&](const Scale& scale) {
    return scale.least == first.least && scale.most == first.most;
  };
  if (!std::ranges::all_of(answer_set.scales, has_same_range)) return "";
  const double range = first.most - first.least;
  return fmt::format(
      "<p class=\"quiet\">Ratings are in scale units: {} at the low end, {} at the high end. "
      "{}.</p>\n",
      scale_value(first.least), scale_value(first.most),
      answer_set.form->is_continuous ? "Those of a trial are the mean of its trace after the lead"
      : answer_set.is_slider         ? fmt::format("A slider’s length is {:g} units", range)
                             : fmt::format("Neighbouring points of the {} shown differ by {:.3g}",
                                           answer_set.points, range / (answer_set.points - 1)));
}

std::string head_html(const Results& results, const FrozenVerdict& frozen) {
  const AnswerSet& answer_set = results.answer_set;
  std::string html = "<h1>" + html_escaped(answer_set.title) + "</h1>\n";
  if (answer_set.simulated) html += "<p class=\"simulated\">Simulated answers.</p>\n";
  const std::size_t answers = answer_set.ratings.size() + answer_set.chosen.size() +
                              answer_set.preferences.size() + answer_set.words.size();
  const std::string people = counted_noun(answer_set.people.size(), "participant", "participants");
  // Answers that are hits and false alarms alone are counted in their own section.
  html += fmt::format(
      "<p class=\"quiet\">Study {}: {}", html_escaped(answer_set.study),
      answers == 0
          ? people
          : fmt::format("{} of {} about {}", counted_noun(answers, "answer", "answers"), people,
                        counted_noun(judged_stimuli(answer_set), "video", "videos")));
  html += answer_set.design.empty()
              ? ".</p>\n"
              : ". Design hash: " + html_escaped(answer_set.design) + ".</p>\n";
  html += units_html(answer_set);
  if (!frozen.sentence.empty())
    html += html_paragraph(frozen.sentence) + html_list("warnings", frozen.differences);
  return html;
}

constexpr char differences_title[] = "Modified, acted and neutral motions";

/// Actors are named only if there are several.
std::string levels_title(const Results& results) {
  const bool has_actors = std::ranges::any_of(results.comparisons, [](const Comparison& c) {
    return c.family == ComparisonFamily::between_levels && c.factor == "actor";
  });
  return has_actors ? "Actors and other factors" : "Videos that differ in one factor";
}

/// Empty for continuous trials, in which films are not rated as a whole.
std::string best_html(const Results& results, const PageParts& parts,
                      const std::vector<std::string>& others) {
  if (results.answer_set.form->is_continuous) return "";
  const std::string table = best_seen_html(results);
  if (table.empty()) return "";
  std::string html =
      correction_html(results.answer_set, others, !results.overall.empty()) +
      html_paragraph(
          "A setting is a combination of levels of all factors except “made”, “emotion”, "
          "“strength”, “example” and “clip”, such as “woman, walk”. For each setting and each end "
          "of each scale, the video rated highest relative to the "
          "other videos of the setting. Difference: for each participant, the rating of this video "
          "minus the mean of the participant’s ratings of the other videos; the table gives the "
          "mean over participants, positive towards the end. The video listed is the one for which "
          "it is largest. “Paired”: paired t test of this difference. "
          "“Welch”: Welch’s test of the ratings of this video against all ratings of videos of the "
          "same setting, including this one, treating ratings by the "
          "same participant as independent. g_z: Hedges’ g of these within-participant "
          "differences. In the tables of all videos, V is the statistic of the "
          "Wilcoxon signed-rank test, the sum of the ranks of the positive differences, "
          "followed by the numbers of nonzero, zero and tied differences.") +
      table + parts.figures("best");
  for (const StimulusGroup& group : stimulus_groups(results.answer_set)) {
    const std::string rows = comparisons_html(results, ComparisonFamily::best_seen,
                                              group.name == "all" ? "" : group.name);
    if (rows.empty()) continue;
    html += fmt::format("<details><summary>All {}</summary>\n{}</details>\n",
                        html_escaped(group.words), rows);
  }
  return html;
}

/// "Modified vs. acted motions"
std::string title_of(ComparisonFamily family) {
  switch (family) {
    case ComparisonFamily::modified_acted:
      return "Modified vs. acted motions";
    case ComparisonFamily::modified_neutral:
      return "Modified vs. neutral motions";
    case ComparisonFamily::modified_best:
      return "Modified motions vs. the highest-rated unmodified video";
    case ComparisonFamily::acted_neutral:
      return "Acted vs. neutral motions";
    default:
      return std::string(word_of(family_words, family));
  }
}

/// A sentence on participants who rated both makings, but never in the same cell.
std::string unmatched_html(const Results& results) {
  std::vector<std::string> sentences;
  for (const OverallComparison& c : results.overall)
    if (c.emotion.empty() && c.unmatched > 0)
      sentences.push_back(fmt::format(
          "{}: {} rated motions of both kinds, but never of the same setting and emotion, and {} "
          "not included in the table over all settings.",
          title_of(c.family),
          counted_noun(static_cast<std::size_t>(c.unmatched), "participant", "participants"),
          c.unmatched == 1 ? "is" : "are"));
  return html_list("", sentences);
}

std::string differences_html(const Results& results, const PageParts& parts) {
  std::string html = parts.figures("differences");
  const auto add = [&](ComparisonFamily family) {
    const std::string videos = comparisons_html(results, family);
    if (videos.empty()) return;
    html += heading(title_of(family)) + overall_html(results, family) + "<details" +
            (results.overall.empty() ? " open" : "") + "><summary>Video by video</summary>\n" +
            videos + "</details>\n";
  };
  add(ComparisonFamily::modified_acted);
  add(ComparisonFamily::modified_neutral);
  add(ComparisonFamily::modified_best);
  add(ComparisonFamily::acted_neutral);
  if (html.empty()) return "";
  return html_paragraph(
             "How strongly the intended emotion is perceived. A setting is a combination of "
             "levels of all factors except “made”, “emotion”, “strength”, “example” and “clip”. "
             "For each kind of comparison, the first table is over all settings (none for the "
             "highest-rated unmodified video); its values are scale units from the middle of "
             "the scale towards the emotion. It is based on each participant’s means over the "
             "settings and emotions for which the participant rated both motions compared "
             "(matched pairs: their number, summed over participants). The other table is video "
             "by video: means and Welch’s test include all ratings of the two videos, and the "
             "other columns the n participants who rated both; its values are on the scale "
             "itself, positive towards its high end. The highest-rated unmodified video is, of "
             "the setting’s unmodified videos, the one with the mean rating farthest towards "
             "the emotion; it was selected using the same answers, so its ratings are biased "
             "upwards. The other scales are in results/comparisons.csv. Where all "
             "within-participant differences are equal, no t test is possible (“all equal”).") +
         unmatched_html(results) + html;
}

std::string levels_html(const Results& results, const PageParts& parts) {
  const std::string videos = comparisons_html(results, ComparisonFamily::between_levels);
  if (videos.empty()) return "";
  return html_paragraph(
             "Pairs of videos that differ in the level of one factor only, such as two actors "
             "showing the same emotion: within-participant differences, first minus second.") +
         parts.figures("levels") + "<details><summary>Video by video</summary>\n" + videos +
         "</details>\n";
}

std::string groups_part(const Results& results, const PageParts& parts) {
  const std::string table = groups_html(results);
  if (table.empty()) return "";
  return html_paragraph(
             "Differences between groups of participants: Welch’s test of the participants’ means, "
             "for the two most frequent answers to each demographic question whose answers are not "
             "numbers. If gender was asked, the ratings of each group are drawn.") +
         "<details><summary>All videos and scales</summary>\n" + table + "</details>\n" +
         parts.figures("groups");
}

std::string confusion_html(const Results& results, const PageParts& parts) {
  const std::string figures = parts.figures("confusion");
  if (figures.empty()) return "";
  const std::string by_ratings = recall_html(results, true);
  const std::string by_choices = recall_html(results, false);
  const auto is_of = [&](bool by_points) {
    return std::ranges::any_of(results.confusions,
                               [=](const Confusion& c) { return c.by_points == by_points; });
  };
  std::string html;
  if (is_of(true))
    html += (is_of(false) ? heading("By ratings") : "") +
            html_paragraph(
                "Ratings are converted to points: a rating at an end of a scale gives that end 2 "
                "points, a rating halfway between the middle and an end 1 point, and others in "
                "proportion. Recall is the intended emotion’s share of its row’s points, as in the "
                "matrix; its interval treats each rated presentation as one trial. “Top response” "
                "is another measure: of the presentations in which one end alone received the most "
                "points, the number in which it was the intended emotion. The exact binomial test "
                "is of this number, against chance (1 / number of ends). Presentations in which "
                "several ends received the most points do not count.") +
            by_ratings;
  if (is_of(false))
    html += (is_of(true) ? heading("By choices") : "") +
            html_paragraph(fmt::format(
                "Each presentation is one choice out of {0}. Recall is the share of choices of the "
                "intended emotion, as in the matrix; the exact binomial test compares their number "
                "with chance (one of the {0}).",
                results.answer_set.choices.size())) +
            by_choices;
  return html + figures;
}

std::string agreement_part(const Results& results) {
  const std::string table = agreement_html(results);
  if (table.empty()) return "";
  return html_paragraph(
             "Intraclass correlations (Shrout and Fleiss); k is the number of ratings per video. "
             "Where participants saw only some of the videos, all ratings are used and none are "
             "imputed: ICC(1) comes from the one-way analysis of variance, ICC(2) and ICC(3) from "
             "variance components estimated by fitting constants (Henderson’s method 3); for "
             "complete data they equal those from the usual mean squares. Cronbach’s α is computed "
             "over the participants who rated all videos.") +
         table;
}

std::string retest_html(const Results& results) {
  const std::string table = retest_summary_html(results);
  if (table.empty()) return "";
  return html_paragraph(
             "Consistency of answers to videos shown twice. All other results use the first answer "
             "only. Differences are in scale units; the correlation is Pearson’s, of first with "
             "second ratings, treated as independent. Excluded participants are listed but not "
             "part of “all”. Attention checks, which require a particular answer, are reported "
             "under Participants.") +
         table + "<details><summary>All repeated answers</summary>\n" +
         retest_answers_html(results) + "</details>\n";
}

/// The most frequent words, and all texts in a collapsed section.
std::string words_html(const Results& results, const PageParts& parts) {
  const std::string answers = remarks_html(results.answer_set.words);
  if (answers.empty()) return "";
  return html_paragraph(
             "Answers are split at commas, semicolons and line ends; case is ignored, and each "
             "word counts once per participant and video. All counts are in "
             "results/word_counts.csv.") +
         parts.figures("words") + "<details><summary>All answers</summary>\n" + answers +
         "</details>\n";
}

std::string files_html(const std::vector<WrittenTable>& tables, bool has_scripts,
                       bool has_variance) {
  std::string html = "<ul>\n";
  for (const WrittenTable& table : tables)
    html += fmt::format("<li><a href=\"{0}\">{0}</a>: one row per {1}</li>\n", table.form.path,
                        html_escaped(table.form.rows));
  html +=
      "<li><a href=\"codebook.csv\">codebook.csv</a>: what every column means; <a "
      "href=\"dataset_description.json\">dataset_description.json</a>: metadata of data/ in "
      "machine-readable form (Psych-DS)</li>\n";
  if (has_scripts)
    html +=
        "<li><a href=\"analysis/lme4.R\">analysis/lme4.R</a>, <a "
        "href=\"analysis/ordinal.R\">analysis/ordinal.R</a>: mixed models in R</li>\n";
  if (has_variance)
    html +=
        "<li><a href=\"analysis/afex.R\">analysis/afex.R</a>: the analysis of variance in R</li>\n";
  html +=
      "<li><a href=\"figures.csv\">figures.csv</a>: list of figures with their "
      "former file names</li>\n</ul>\n";
  return html;
}

}  // namespace

std::string results_page(const Results& results, const std::vector<ResultFigure>& figures,
                         const std::vector<WrittenTable>& tables, const FrozenVerdict& frozen) {
  PageParts parts(results, figures);
  parts.section("people", "Participants", people_html(results));
  parts.section("quality", "Quality rules", quality_html(results));
  // What the analysis plan states comes first.
  const auto add_factors = [&] {
    parts.section("factors", "Factors of the design",
                  factor_section_html(results, parts.figures("factors")));
  };
  const bool is_planned = !results.answer_set.factorial.empty();
  if (is_planned) add_factors();
  parts.section("means", "Means", parts.figures("means"));
  parts.section("grid", "Sets of stimuli", grid_section_html(results, parts.figures("grid")));
  parts.section("traces", "Ratings over time",
                trace_section_html(results, parts.figures("traces")));
  parts.section("histograms", "Distributions of answers", parts.figures("histograms"));
  const std::string differences = differences_html(results, parts);
  const std::string levels = levels_html(results, parts);
  std::vector<std::string> others;
  if (!differences.empty()) others.emplace_back(differences_title);
  if (!levels.empty()) others.push_back(levels_title(results));
  parts.section("best", "Highest-rated videos", best_html(results, parts, others));
  parts.section("differences", differences_title, differences);
  if (!is_planned) add_factors();
  parts.section("levels", levels_title(results), levels);
  parts.section("groups", "Groups of participants", groups_part(results, parts));
  parts.section("confusion", "Confusion", confusion_html(results, parts));
  parts.section("correlations", "Correlations", parts.figures("correlations"));
  parts.section("agreement", "Agreement", agreement_part(results));
  parts.section("retest", "Test–retest", retest_html(results));
  parts.section("preferences", "Pairs", parts.figures("preferences") + preferences_html(results));
  parts.section("worth",
                results.best_worst.empty() ? "Worth of compared stimuli" : "Best and worst",
                worth_section_html(results, parts.figures("worth")));
  parts.section("sensitivity", "Sensitivity",
                detection_section_html(results, parts.figures("sensitivity")));
  parts.section("thresholds", "Thresholds",
                threshold_section_html(results, parts.figures("thresholds")));
  parts.section("comments", "Comments", remarks_html(results.answer_set.remarks));
  parts.section("words", "Free-text answers", words_html(results, parts));
  parts.section(
      "files", "Files",
      files_html(tables, !results.answer_set.ratings.empty(), !results.effects.crossing.empty()));
  const std::string mark = results.answer_set.simulated ? "Simulated: " : "";
  return html_page(mark + results.answer_set.title, results_style,
                   head_html(results, frozen) + parts.nav() + parts.body());
}

}  // namespace mien::pipeline
