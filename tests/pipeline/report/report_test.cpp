#include "pipeline/report/report.h"

#include <algorithm>
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
  return report(manifest, motions, methods_of(manifest, motions));
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
  EXPECT_NE(page.find("a picture of each of 2 stimuli"), std::string::npos);
  EXPECT_EQ(page.find("<h2>Comparisons</h2>"), std::string::npos);
}

TEST(Report, SaysWhatIsMadeAlike) {
  Manifest manifest = study_called("plain");
  EXPECT_EQ(report_of(manifest).find("Made alike"), std::string::npos);
  manifest.equalize = {.luminance = Among::study, .duration = true};
  const std::string page = report_of(manifest);
  EXPECT_NE(page.find("<p>Made alike in all stimuli: length (as the shortest), mean luminance"),
            std::string::npos);
  EXPECT_NE(page.find("href=\"metrics/exposure.csv\""), std::string::npos);
  EXPECT_EQ(page.find("metrics/sizes.csv"), std::string::npos);
  EXPECT_EQ(unbalanced_tag(page), "");
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
  EXPECT_EQ(report_of(manifest).find("What people think"), std::string::npos);
}

TEST(Report, IsTheSameEachTime) {
  EXPECT_EQ(report_of(study_called("plain")), report_of(study_called("plain")));
}

}  // namespace
}  // namespace mien::pipeline
