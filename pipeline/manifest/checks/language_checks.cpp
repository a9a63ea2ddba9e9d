#include <algorithm>
#include <set>
#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/study_texts.h"
#include "pipeline/manifest/texts/page_texts.h"

namespace mien::pipeline {

namespace {

using Names = std::vector<std::string>;

bool is_one_of(const std::string& name, const Names& names) {
  return std::ranges::find(names, name) != names.end();
}

/// "en, de and ja".
std::string listed(const Names& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

/// Checks that an experiment has all texts in all languages offered.
class LanguageCheck {
 public:
  /// `path` is that of the experiment: "questionnaire".
  LanguageCheck(const Manifest& manifest, const std::string& path, const PageLanguage& language,
                const OwnTexts& own)
      : path_(path), offered_(language.offered), own_(own), list_(manifest.places) {
    known_ = built_in_languages();
    for (const PageTexts& texts : own.texts)
      if (!is_one_of(texts.language, known_)) known_.push_back(texts.language);
    check_offered(language.by_browser);
    check_own();
  }

  void operator()(const std::string& path, const LocalText& text) { check(path, text); }
  void operator()(const std::string& path, const TextSource& source) {
    if (source.file.empty() || source.by_language.empty()) return check(path, source);
    list_.add_at_key(member_path(path, "file"), "there are also texts by language",
                     "write the file of each language: {" + by_language() + "}");
  }
  void operator()(const std::string& path, const LocalWords& words) {
    check(path, words);
    const auto* first = in_language(words.by_language, offered_.front());
    if (first == nullptr) return;
    for (const auto& [language, translated] : words.by_language)
      if (translated.size() != first->size())
        list_.add(member_path(path, language),
                  fmt::format("has {} {}, but there {} {} in {}", translated.size(),
                              translated.size() == 1 ? "word" : "words",
                              first->size() == 1 ? "is" : "are", first->size(), offered_.front()),
                  "give the same words in the same order in all languages");
  }

  /// Scales whose ends are displayed; `key` is that of the option that names them.
  void check_scales(const std::vector<Scale>& scales, const char* key) {
    if (offered_.size() == 1) return;
    for (const std::string& language : offered_) {
      Names without;
      for (const Scale& scale : scales)
        if (!ends_in(scale, language)) without.push_back(scale.id);
      if (without.empty()) continue;
      list_.add(member_path(path_, key),
                fmt::format("{} {} no words in {}", without.front(),
                            without.size() == 1
                                ? "has"
                                : fmt::format("and {} more scales have", without.size() - 1),
                            language),
                fmt::format("add {}: [low, high] to them in a scales file", language));
    }
  }

  /// What sliders are called.
  void check_sliders(const Manifest& manifest, const Matching& matching) {
    const ScaleSet scales = scales_of(manifest.scales);
    Names groups;
    ScaleSet displayed;
    for (const ScaleGroup& group : scales.groups)
      if (matching.primary.empty() || is_one_of(group.id, matching.primary))
        groups.push_back(group.id);
    for (const Scale& scale : scales.scales)
      if (matching.offered.empty() || is_one_of(scale.id, matching.offered) ||
          is_one_of(scale.id, matching.primary))
        displayed.scales.push_back(scale);
    const auto has_names = [](const std::string& language) {
      return language == "en" || language == "ja";
    };
    for (const std::string& language : offered_) {
      if (offered_.size() == 1 || has_names(language)) continue;
      if (is_one_of("features", matching.interfaces))
        list_.add(member_path(path_, "interfaces"), "motion features have no names in " + language,
                  "use interfaces: [adjectives, weights], or pages in English and Japanese");
      if (is_one_of("adjectives", matching.interfaces) && !groups.empty())
        list_.add(member_path(path_, "primary"),
                  "the group " + groups.front() + " has no name in " + language,
                  "name adjective pairs: primary: [sad-happy, …]");
    }
    if (is_one_of("adjectives", matching.interfaces))
      check_scales(displayed.scales, matching.offered.empty() ? "primary" : "pairs_offered");
  }

  /// Levels of a factor are displayed as they are.
  void check_choices(const Questionnaire& asked) {
    if (offered_.size() > 1 && asked.trials->offers_choices && asked.choices.empty())
      list_.add(member_path(path_, "trials"),
                "the levels of the factor emotion have no texts in " + listed(offered_),
                "add choices: {sad: {" + by_language() + "}}");
  }

  std::vector<Fault> faults() { return list_.take(); }

 private:
  void check_offered(bool by_browser) {
    const std::string path = member_path(path_, "language");
    std::set<std::string> taken;
    for (std::size_t i = 0; i < offered_.size(); ++i) {
      const std::string at = by_browser ? element_path(member_path(path, "browser"), i) : path;
      if (!is_one_of(offered_[i], known_))
        list_.add(at, "there are no texts of pages in " + motion::in_quotes(offered_[i]),
                  motion::did_you_mean(offered_[i], known_) + ", or add them: texts: my.yaml");
      if (!taken.insert(offered_[i]).second)
        list_.add(at, motion::in_quotes(offered_[i]) + " appears twice", "name it once");
    }
  }

  void check_own() {
    const std::string path = member_path(path_, "texts");
    std::set<std::string> taken;
    for (std::size_t i = 0; i < own_.texts.size(); ++i) {
      const std::string& language = own_.texts[i].language;
      const std::string at = own_.files.size() == 1 ? path : element_path(path, i);
      if (!is_one_of(language, offered_))
        list_.add(at, "no page is in the language of this file, " + language,
                  "add it to language: {browser: […]}, or omit the file");
      if (!taken.insert(language).second)
        list_.add(at, "another file has the texts in " + language, "put them into one file");
    }
  }

  /// "en: …, de: …".
  std::string by_language() const {
    std::string form;
    for (const std::string& language : offered_)
      form += (form.empty() ? "" : ", ") + language + ": …";
    return form;
  }

  void check(const std::string& path, const auto& text) {
    if (text.empty()) return;
    if (text.by_language.empty()) {
      if (offered_.size() > 1)
        list_.add(path, "is in one language, but the pages are in " + listed(offered_),
                  "write {" + by_language() + "}");
      return;
    }
    for (const auto& [language, translated] : text.by_language)
      if (!is_one_of(language, known_))
        list_.add_at_key(member_path(path, language), "unknown language",
                         motion::did_you_mean(language, known_));
    for (const std::string& language : offered_)
      if (in_language(text.by_language, language) == nullptr)
        list_.add(path, "has no text in " + language, "add " + language + ": …");
  }

  std::string path_;
  const Names& offered_;
  const OwnTexts& own_;
  Names known_;
  FaultList list_;
};

}  // namespace

std::vector<Fault> check_languages(const Manifest& manifest) {
  std::vector<Fault> faults;
  visit_experiments(manifest, [&](const auto& experiment) {
    using Experiment = std::remove_cvref_t<decltype(experiment)>;
    constexpr bool is_questionnaire = std::is_same_v<Experiment, Questionnaire>;
    constexpr bool is_matching = std::is_same_v<Experiment, Matching>;
    LanguageCheck check(manifest,
                        is_questionnaire ? "questionnaire"
                        : is_matching    ? "matching"
                                         : "adaptive",
                        experiment.language, experiment.texts);
    visit_texts(experiment, [&](const std::string& path, const auto& text) { check(path, text); });
    if constexpr (is_questionnaire) {
      check.check_scales(questionnaire_scales(manifest).scales, "scales");
      check.check_choices(experiment);
    } else if constexpr (is_matching) {
      check.check_sliders(manifest, experiment);
    }
    append(faults, check.faults());
  });
  return faults;
}

}  // namespace mien::pipeline
