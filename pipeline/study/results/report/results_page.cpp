#include "pipeline/study/results/report/results_page.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "pipeline/base/documents/html.h"
#include "pipeline/study/results/people_counted.h"
#include "pipeline/study/results/report/page_style.h"
#include "pipeline/study/results/report/page_tables.h"

namespace mien::pipeline {

namespace {

/// Gathers the sections that hold something.
class PageParts {
 public:
  PageParts(const Results& results, const std::vector<ResultFigure>& figures)
      : simulated_(results.gathered.simulated), figures_(figures) {}

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
      html += fmt::format(
          "<figcaption>{}{} Files: {}{}</figcaption>\n</figure>\n", html_escaped(figure.caption),
          figure.thesis.empty() ? ""
                                : fmt::format(" After figure {} of the thesis.", figure.thesis),
          links(figure.name),
          figure.was.empty()
              ? ""
              : fmt::format(" Before, these files were called {}.", html_escaped(figure.was)));
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

std::string paragraph(const std::string& plain) { return "<p>" + html_escaped(plain) + "</p>\n"; }

std::string heading(const std::string& plain) { return "<h3>" + html_escaped(plain) + "</h3>\n"; }

/// A titled part, or nothing.
std::string part(const std::string& title, const std::string& html) {
  return html.empty() ? "" : heading(title) + html;
}

std::size_t judged_stimuli(const Gathered& gathered) {
  std::set<std::size_t> judged;
  for (const CountedRating& rating : gathered.ratings) judged.insert(rating.stimulus);
  for (const CountedChoice& choice : gathered.chosen) judged.insert(choice.stimulus);
  for (const CountedPreference& pair : gathered.preferences)
    judged.insert({pair.chosen, pair.other});
  std::set<std::string> in_words;
  for (const Remark& words : gathered.words) in_words.insert(words.stimulus);
  return std::max(judged.size(), in_words.size());
}

std::string head_html(const Results& results, const FrozenVerdict& frozen) {
  const Gathered& gathered = results.gathered;
  std::string html = "<h1>" + html_escaped(gathered.title) + "</h1>\n";
  if (gathered.simulated)
    html += "<p class=\"simulated\">Simulated: nobody gave these answers. 模擬評定</p>\n";
  const std::size_t answers = gathered.ratings.size() + gathered.chosen.size() +
                              gathered.preferences.size() + gathered.words.size();
  html += fmt::format("<p class=\"quiet\">Study {}: {} of {} about {}",
                      html_escaped(gathered.study), counted(answers, "answer", "answers"),
                      counted(gathered.people.size(), "person", "people"),
                      counted(judged_stimuli(gathered), "video", "videos"));
  html +=
      gathered.design.empty() ? ".</p>\n" : ", design " + html_escaped(gathered.design) + ".</p>\n";
  if (!frozen.sentence.empty())
    html += paragraph(frozen.sentence) + html_list("warnings", frozen.differences);
  return html;
}

std::string people_html(const Results& results) {
  const Gathered& gathered = results.gathered;
  const auto excluded = std::ranges::count_if(gathered.attention, &Attention::is_excluded);
  std::string html = paragraph(people_sentence(gathered) + ". " + to_sentence(gathered.rule));
  if (excluded > 0) {
    std::vector<std::string> names;
    for (const Attention& own : gathered.attention)
      if (own.is_excluded)
        names.push_back(
            fmt::format("{} ({} of {} checks passed)", own.participant, own.passed, own.checks));
    html += paragraph("Left out:") + html_list("", names);
  }
  html += html_list("", unfinished_sentences(gathered)) + html_list("", gathered.notes);
  html += part("What they say about themselves", demographics_html(results));
  html += "<details><summary>Every session</summary>\n" + sessions_html(results) + "</details>\n";
  return html;
}

std::string method_html(const Gathered& gathered) {
  return paragraph(fmt::format(
      "Level of all tests: {:g}, two-sided. Correction for their number: {}, within each kind of "
      "comparison; those on the scale of the emotion that was meant are corrected by themselves, "
      "but here, where every end of every scale is looked at, all together. Rows marked * are "
      "below the level after it.",
      gathered.alpha, name_of(gathered.correction)));
}

std::string best_html(const Results& results, const PageParts& parts) {
  const std::string table = best_seen_html(results);
  if (table.empty()) return "";
  std::string html = method_html(results.gathered) +
                     paragraph(
                         "Of each end of a scale, the video in which it is seen most. “Thesis”: "
                         "Welch’s test of the answers about the video against all answers about "
                         "the videos of the same setting; the video is among these, and answers "
                         "of one person are taken as independent. “Paired”: of each person, the "
                         "answer about the video less the mean of the person’s other videos of "
                         "the setting.") +
                     table + parts.figures("best");
  for (const StimulusGroup& group : stimulus_groups(results.gathered)) {
    const std::string rows = comparisons_html(results, ComparisonFamily::best_seen,
                                              group.name == "all" ? "" : group.name);
    if (rows.empty()) continue;
    html += fmt::format(
        "<details><summary>All {}{}</summary>\n{}</details>\n", html_escaped(group.words),
        group.name == "acted" || group.name == "all" ? " (after figure 31 of the thesis)" : "",
        rows);
  }
  return html;
}

/// Who judged both sides, but never of the same, is told.
std::string unmatched_html(const Results& results) {
  std::vector<std::string> sentences;
  for (const OverallComparison& c : results.overall)
    if (c.emotion.empty() && c.unmatched > 0)
      sentences.push_back(fmt::format(
          "{}: {} judged both sides, but never of one setting and emotion, and {} left out.",
          word_of(family_words, c.family),
          counted(static_cast<std::size_t>(c.unmatched), "person", "people"),
          c.unmatched == 1 ? "is" : "are"));
  return html_list("", sentences);
}

std::string differences_html(const Results& results, const PageParts& parts) {
  std::string html = parts.figures("differences");
  const auto add = [&](ComparisonFamily family, const std::string& title,
                       const std::string& thesis) {
    const std::string videos = comparisons_html(results, family);
    if (videos.empty()) return;
    html += heading(title) + overall_html(results, family) + "<details" +
            (results.overall.empty() ? " open" : "") + "><summary>Video by video" + thesis +
            "</summary>\n" + videos + "</details>\n";
  };
  add(ComparisonFamily::modified_acted, "Modified against acted motions",
      " (after figure 37 of the thesis)");
  add(ComparisonFamily::modified_neutral, "Modified against neutral motions", "");
  add(ComparisonFamily::modified_best, "Modified motions against the video seen most", "");
  add(ComparisonFamily::acted_neutral, "Acted against neutral motions", "");
  if (html.empty()) return "";
  return paragraph(
             "How far the emotion that was meant is seen, on the scale whose end it is, in points "
             "from the middle. First over all settings (the levels of all factors but made, "
             "emotion and strength), like with like: of each person the mean over the settings "
             "and emotions of which that person judged both sides. Below, video by video, where "
             "those count who saw both. The video seen most is the one of the setting, itself not "
             "modified, whose answers lie farthest towards the emotion: it is found by the same "
             "answers, which makes it look better than it is. results/comparisons.csv has the "
             "other scales too. Where all of few people differ by the same, there is no t test.") +
         unmatched_html(results) + html;
}

std::string levels_html(const Results& results, const PageParts& parts) {
  const std::string videos = comparisons_html(results, ComparisonFamily::between_levels);
  if (videos.empty()) return "";
  return paragraph(
             "Videos that differ in the level of one factor alone, such as two actors who show the "
             "same: within persons, the first less the second.") +
         parts.figures("levels") +
         "<details><summary>Video by video (of actors, after figure 38 of the "
         "thesis)</summary>\n" +
         videos + "</details>\n";
}

std::string groups_part(const Results& results, const PageParts& parts) {
  const std::string table = groups_html(results);
  if (table.empty()) return "";
  return paragraph(
             "How groups of participants differ, by what they say of themselves: Welch’s test of "
             "the people’s own means, the two answers that most gave. Where gender was asked, the "
             "answers of either group are drawn. Figures 41 to 43 of the thesis are about gender; "
             "whether about that of the participants or of who is seen, our text of it does not "
             "say: the latter is the scale masculine – feminine of all other sections.") +
         "<details><summary>Every video and scale</summary>\n" + table + "</details>\n" +
         parts.figures("groups");
}

std::string confusion_html(const Results& results, const PageParts& parts) {
  const std::string figures = parts.figures("confusion");
  if (figures.empty()) return "";
  std::string html;
  const auto is_of = [&](bool by_points) {
    return std::ranges::any_of(results.confusions,
                               [=](const Confusion& c) { return c.by_points == by_points; });
  };
  if (is_of(true))
    html += paragraph(
        "Ratings become points: an answer at the end of a scale gives that end 2 points, one half "
        "way 1, the middle none; a row’s shares are of all its points. The intervals take each "
        "judged showing as one trial. “Seen most”: showings in which the emotion itself got more "
        "points than any other end; the exact binomial test holds them against chance, one of the "
        "ends.");
  if (is_of(false))
    html += paragraph(
        fmt::format("Choices: each showing is one choice out of {}; a row’s shares are of its "
                    "choices. “Seen most”: choices of the emotion that was meant; the exact "
                    "binomial test holds them against chance, one of the {}.",
                    results.gathered.choices.size(), results.gathered.choices.size()));
  return html + recall_html(results) + figures;
}

std::string agreement_part(const Results& results) {
  const std::string table = agreement_html(results);
  if (table.empty()) return "";
  return paragraph(
             "Intraclass correlations after Shrout and Fleiss; k is the number of answers a "
             "video. Where people saw a part of the videos, every answer counts and nothing is "
             "filled in: ICC(1) from the one-way analysis of variance, ICC(2) and ICC(3) from "
             "variance components by fitting constants (Henderson’s method 3), which in a full "
             "table are the same mean squares. Cronbach’s α is of the people who saw all.") +
         table;
}

std::string catch_html(const Results& results) {
  const std::string table = catch_summary_html(results);
  if (table.empty()) return "";
  return paragraph(
             "Videos that were shown a second time: how alike the answers are. The first answer "
             "counts in all other results, the second in none. Differences are in points of the "
             "scale; the correlation is Pearson’s, of the first with the second ratings, all as if "
             "independent. Who is left out is told but not part of “all”. Attention checks are "
             "something else: they expect a certain answer, and are told under People.") +
         table + "<details><summary>Every answer that was given twice</summary>\n" +
         catch_answers_html(results) + "</details>\n";
}

/// The words that most gave, and behind a click what everybody wrote.
std::string words_html(const Results& results, const PageParts& parts) {
  const std::string answers = remarks_html(results.gathered.words);
  if (answers.empty()) return "";
  return paragraph(
             "Answers are divided at commas, semicolons and ends of lines; each word counts once a "
             "person and video, capital letters as small ones. results/word_counts.csv has all.") +
         parts.figures("words") + "<details><summary>Every answer</summary>\n" + answers +
         "</details>\n";
}

std::string files_html(const std::vector<WrittenTable>& tables, bool has_scripts) {
  std::string html = "<ul>\n";
  for (const WrittenTable& table : tables)
    html += fmt::format("<li><a href=\"{0}\">{0}</a>: {1} a row</li>\n", table.form.path,
                        html_escaped(table.form.rows));
  html +=
      "<li><a href=\"codebook.csv\">codebook.csv</a>: what every column means; "
      "<a href=\"dataset_description.json\">dataset_description.json</a>: the same of data/, for "
      "machines (Psych-DS)</li>\n";
  if (has_scripts)
    html +=
        "<li><a href=\"analysis/lme4.R\">analysis/lme4.R</a>, "
        "<a href=\"analysis/ordinal.R\">analysis/ordinal.R</a>: mixed models, to be run with "
        "R</li>\n";
  html +=
      "<li><a href=\"figures.csv\">figures.csv</a>: the figures by what they show, those of the "
      "thesis that they are like, and what their files were called before</li>\n</ul>\n";
  return html;
}

}  // namespace

std::string results_page(const Results& results, const std::vector<ResultFigure>& figures,
                         const std::vector<WrittenTable>& tables, const FrozenVerdict& frozen) {
  PageParts parts(results, figures);
  parts.section("people", "People", people_html(results));
  parts.section("means", "Means", parts.figures("means"));
  parts.section("histograms", "Answers", parts.figures("histograms"));
  parts.section("best", "What is seen where", best_html(results, parts));
  parts.section("differences", "Modified, acted, neutral", differences_html(results, parts));
  parts.section("levels", "Actors and other factors", levels_html(results, parts));
  parts.section("groups", "Groups of participants", groups_part(results, parts));
  parts.section("confusion", "Confusion", confusion_html(results, parts));
  parts.section("correlations", "Scales together", parts.figures("correlations"));
  parts.section("agreement", "Agreement", agreement_part(results));
  parts.section("catch", "Answered twice", catch_html(results));
  parts.section("preferences", "Pairs", parts.figures("preferences") + preferences_html(results));
  parts.section("comments", "Comments", remarks_html(results.gathered.remarks));
  parts.section("words", "Answers in words", words_html(results, parts));
  parts.section("files", "Files", files_html(tables, !results.gathered.ratings.empty()));
  const std::string mark = results.gathered.simulated ? "Simulated: " : "";
  return html_page(mark + results.gathered.title, results_style,
                   head_html(results, frozen) + parts.nav() + parts.body());
}

}  // namespace mien::pipeline
