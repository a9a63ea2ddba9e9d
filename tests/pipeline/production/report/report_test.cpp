#include "pipeline/production/report/report.h"

#include <regex>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

Manifest study_called(const std::string& name) {
  Manifest manifest;
  manifest.file = "a&b.yaml";
  manifest.study = name;
  manifest.examples.builtin = "walks-10";
  manifest.ratings.source = Ratings::Source::builtin;
  Stimulus mix;
  mix.id = "mix";
  mix.weights = {{"normal", 0.6}, {"proud", 0.4}};
  Stimulus target = mix;
  target.id = "target";
  target.role = Role::target;
  manifest.stimuli = {target, mix};
  Sheet sheet;
  sheet.id = "target_mix";
  sheet.target = "target";
  sheet.created = "mix";
  manifest.sheets = {sheet};
  return manifest;
}

std::string report_of(const Manifest& manifest) {
  Motions motions(manifest);
  return report(manifest, motions, methods_of(manifest, motions), {});
}

/// The first tag that is closed wrongly or left open; empty when all are balanced.
std::string unbalanced_tag(const std::string& page) {
  const std::set<std::string> empty_elements = {"meta", "img", "br", "link", "!DOCTYPE"};
  std::vector<std::string> open;
  const std::regex tag(R"(<(/?)([!A-Za-z0-9]+)[^<>]*>)");
  for (std::sregex_iterator i(page.begin(), page.end(), tag), end; i != end; ++i) {
    const std::string name = (*i)[2];
    if (empty_elements.contains(name)) continue;
    if ((*i)[1].length() == 0) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return (*i)[0];
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

TEST(Report, ClosesEveryTag) { EXPECT_EQ(unbalanced_tag(report_of(study_called("plain"))), ""); }

TEST(Report, ListsTheWarningsOfFilms) {
  const Manifest manifest = study_called("plain");
  Motions motions(manifest);
  const FilmWarnings films = {{"mix", {"\"ann\": relaxed <hands> are drawn."}}};
  const std::string page = report(manifest, motions, methods_of(manifest, motions), {}, films);
  const std::string sentence = "&quot;ann&quot;: relaxed &lt;hands&gt; are drawn.";
  const std::size_t in_table = page.find("<a href=\"#mix\">mix</a> (film)");
  EXPECT_NE(in_table, std::string::npos);
  EXPECT_LT(page.find(sentence, in_table), page.find("</tr>", in_table));
  const std::size_t on_card = page.find("id=\"mix\"");
  EXPECT_LT(page.find("<ul class=\"warnings\">\n<li>" + sentence, on_card),
            page.find("</article>", on_card));
  EXPECT_EQ(unbalanced_tag(page), "");
  EXPECT_EQ(report_of(manifest).find("(film)"), std::string::npos);
}

TEST(Report, EscapesNames) {
  const std::string page = report_of(study_called("<script>alert(1)</script> & co"));
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(1)&lt;/script&gt; &amp; co"), std::string::npos);
  EXPECT_NE(page.find("a&amp;b.yaml"), std::string::npos);
  EXPECT_EQ(unbalanced_tag(page), "");
}

TEST(Report, LinksOnlyWhatIsBesideIt) {
  const std::string page = report_of(study_called("plain"));
  const std::regex link(R"re((?:src|href)="([^"]*)")re");
  std::set<std::string> links;
  for (std::sregex_iterator i(page.begin(), page.end(), link), end; i != end; ++i) {
    links.insert((*i)[1]);
  }
  const std::set<std::string> expected = {"videos/target.mp4",
                                          "videos/mix.mp4",
                                          "sheets/contact/target.png",
                                          "sheets/contact/mix.png",
                                          "sheets/target_mix.png",
                                          "sheets/target_mix.pdf",
                                          "metrics/",
                                          "metrics/codebook.json",
                                          "methods.md",
                                          "references.bib",
                                          "provenance.json"};
  EXPECT_EQ(links, expected);
}

TEST(Report, ShowsSheetsOfStillsApartFromComparisons) {
  Manifest manifest = study_called("plain");
  Sheet looks;
  looks.id = "looks";
  looks.stills = {"target", "mix"};
  manifest.sheets.push_back(looks);
  const std::string both = report_of(manifest);
  EXPECT_NE(both.find("src=\"sheets/looks.png\""), std::string::npos);
  EXPECT_NE(both.find("<h2>Comparisons</h2>"), std::string::npos);
  EXPECT_EQ(unbalanced_tag(both), "");
  manifest.sheets = {looks};
  const std::string page = report_of(manifest);
  EXPECT_NE(page.find("a frame of each of 2 stimuli"), std::string::npos);
  EXPECT_EQ(page.find("<h2>Comparisons</h2>"), std::string::npos);
}

TEST(Report, SaysWhatIsMadeAlike) {
  Manifest manifest = study_called("plain");
  EXPECT_EQ(report_of(manifest).find("Equalized"), std::string::npos);
  manifest.equalize = {.luminance = EqualizeGroup::study, .duration = true};
  const std::string page = report_of(manifest);
  EXPECT_NE(page.find("<p>Equalized across stimuli: duration (to the shortest: "),
            std::string::npos);
  EXPECT_EQ(page.find("with the same kind of figure"), std::string::npos);
  EXPECT_NE(page.find("href=\"metrics/exposure.csv\""), std::string::npos);
  EXPECT_EQ(page.find("metrics/sizes.csv"), std::string::npos);
  EXPECT_EQ(unbalanced_tag(page), "");
}

TEST(Report, SaysAmongWhichStimuliEachIsAlike) {
  const auto alike_in = [](const std::string& page, const std::string& words) {
    const std::size_t start = page.find("<p>Equalized " + words + ": ");
    return start == std::string::npos ? "" : page.substr(start, page.find("</p>", start) - start);
  };
  using Member = std::optional<EqualizeGroup> Equalize::*;
  const std::pair<Member, std::string> members[] = {{&Equalize::luminance, "mean luminance"},
                                                    {&Equalize::size, "height of the standing"},
                                                    {&Equalize::place, "position in the image"}};
  for (const auto& [member, what] : members) {
    for (const EqualizeGroup among : {EqualizeGroup::study, EqualizeGroup::figure}) {
      Manifest manifest = study_called("plain");
      manifest.equalize.*member = among;
      const std::string page = report_of(manifest);
      const bool by_figure = among == EqualizeGroup::figure;
      const std::string of_all = alike_in(page, "across stimuli");
      const std::string of_kinds = alike_in(page, "across stimuli with the same kind of figure");
      EXPECT_EQ(of_all.find(what) != std::string::npos, !by_figure) << what;
      EXPECT_EQ(of_kinds.find(what) != std::string::npos, by_figure) << what;
    }
  }
}

TEST(Report, ShowsNoVideoThatIsNotMade) {
  Manifest manifest = study_called("plain");
  for (Stimulus& stimulus : manifest.stimuli) stimulus.output.video.clear();
  EXPECT_EQ(report_of(manifest).find("<video"), std::string::npos);
}

TEST(Report, SaysSimulatedRatingsOnlyWhereSomethingRestsOnThem) {
  Manifest manifest = study_called("plain");
  EXPECT_EQ(report_of(manifest).find("Simulated ratings"), std::string::npos);
  manifest.stimuli[1].weights.clear();
  manifest.stimuli[1].adjectives = {{"quickness", 0.5}};
  EXPECT_NE(report_of(manifest).find("Simulated ratings"), std::string::npos);
}

TEST(Report, SaysWhichExpectedOrdersDoNotHold) {
  Manifest manifest = study_called("plain");
  manifest.ratings.expected = {{"slow-fast", {"tired", "brisk"}},
                               {"slow-fast", {"brisk", "tired"}}};
  const std::string page = report_of(manifest);
  EXPECT_NE(page.find("<li class=\"holds\">slow-fast: tired 0."), std::string::npos);
  EXPECT_NE(page.find("<li class=\"fails\">slow-fast: brisk 0."), std::string::npos);
  EXPECT_EQ(unbalanced_tag(page), "");
}

TEST(Report, ShowsNoRatingsWhereThereAreNone) {
  Manifest manifest = study_called("plain");
  manifest.ratings.source = Ratings::Source::none;
  EXPECT_EQ(report_of(manifest).find("Ratings of the examples"), std::string::npos);
}

/// Asked for an adjective that its examples do not have so much of.
Manifest adjective_study() {
  Manifest manifest = study_called("plain");
  Stimulus& asked = manifest.stimuli[1];
  asked.weights.clear();
  asked.adjectives = {{"slow-fast", 1.0}, {"sad-happy", 0.0}};
  return manifest;
}

TEST(Report, OpensWithWhatWasFoundAndTheSheets) {
  const std::string page = report_of(adjective_study());
  const std::size_t findings = page.find("<h2>Findings</h2>");
  const std::size_t sheets = page.find("<h2>Comparisons</h2>");
  const std::size_t films = page.find("<h2>Stimuli</h2>");
  EXPECT_LT(findings, sheets);
  EXPECT_LT(sheets, films);
  EXPECT_LT(films, page.size());
  EXPECT_NE(page.find("<a href=\"#mix\">mix</a>"), std::string::npos);
  EXPECT_EQ(unbalanced_tag(page), "");
}

/// The card of a stimulus, and what of it is not folded away.
std::string open_part_of(const std::string& page, const std::string& id) {
  const std::size_t first = page.find("id=\"" + id + "\"");
  std::string card = page.substr(first, page.find("</article>", first) - first);
  for (std::size_t at = card.find("<details>"); at != std::string::npos;
       at = card.find("<details>"))
    card.erase(at, card.find("</details>", at) - at + 10);
  return card;
}

TEST(Report, ShowsWhatWasAskedAndFoldsTheOtherScales) {
  const std::string page = report_of(adjective_study());
  const std::string open = open_part_of(page, "mix");
  EXPECT_NE(open.find("slow – fast"), std::string::npos);
  EXPECT_NE(open.find("sad – happy"), std::string::npos);
  EXPECT_EQ(open.find("weak – strong"), std::string::npos);
  EXPECT_NE(page.find("weak – strong"), std::string::npos);
  // Of the mixture by weights nothing was asked but these.
  const std::string weights = open_part_of(page, "target");
  EXPECT_EQ(weights.find("sad – happy"), std::string::npos);
  EXPECT_NE(weights.find("proud"), std::string::npos);
  EXPECT_NE(page.find("other parameters</summary>"), std::string::npos);
  EXPECT_EQ(page.find("without requested values"), std::string::npos);
}

TEST(Report, NamesScalesInTheLanguageOfTheStudyAlone) {
  Manifest manifest = adjective_study();
  const std::string english = open_part_of(report_of(manifest), "mix");
  EXPECT_EQ(english.find("遅い"), std::string::npos);
  manifest.questionnaire.emplace();
  manifest.questionnaire->language = {{"ja"}, false};
  const std::string japanese = open_part_of(report_of(manifest), "mix");
  EXPECT_NE(japanese.find("遅い – 速い"), std::string::npos);
  EXPECT_EQ(japanese.find("slow – fast</th>"), std::string::npos);
}

TEST(Report, NamesScalesInBothLanguagesByChoice) {
  Manifest manifest = adjective_study();
  manifest.names = NameLanguage::both;
  EXPECT_NE(open_part_of(report_of(manifest), "mix").find("slow – fast 遅い – 速い"),
            std::string::npos);
  manifest.questionnaire.emplace();
  manifest.questionnaire->language = {{"ja"}, false};
  manifest.names = NameLanguage::english;
  EXPECT_EQ(open_part_of(report_of(manifest), "mix").find("遅い"), std::string::npos);
}

TEST(Report, StandsAtAFrameOfTheFilmBeforeItPlays) {
  Manifest manifest = study_called("plain");
  EXPECT_EQ(report_of(manifest).find("#t="), std::string::npos);
  for (Stimulus& stimulus : manifest.stimuli) {
    stimulus.output.fps = 10.0;
    stimulus.output.presentation.fixation_seconds = 1.0;
    stimulus.output.presentation.blank_before = 0.5;
  }
  // In the middle of frame 15, the film's first.
  EXPECT_NE(report_of(manifest).find("videos/mix.mp4#t=1.550\""), std::string::npos);
  for (Stimulus& stimulus : manifest.stimuli) stimulus.output.presentation.fade_in = 0.5;
  EXPECT_NE(report_of(manifest).find("videos/mix.mp4#t=1.950\""), std::string::npos);
}

TEST(Report, IsTheSameEachTime) {
  EXPECT_EQ(report_of(study_called("plain")), report_of(study_called("plain")));
}

}  // namespace
}  // namespace mien::pipeline
