#include "pipeline/manifest/study_texts.h"

namespace mien::pipeline {

namespace {

/// Sets a text to that of a language.
class LanguageChoice {
 public:
  explicit LanguageChoice(const std::string& language) : language_(language) {}

  void operator()(const std::string&, LocalText& text) const {
    if (const std::string* found = in_language(text.by_language, language_)) text.text = *found;
  }
  void operator()(const std::string&, LocalWords& words) const {
    if (const auto* found = in_language(words.by_language, language_)) words.words = *found;
  }
  void operator()(const std::string&, TextSource& source) const {
    if (const FiledText* found = in_language(source.by_language, language_))
      source.text = found->text;
  }

 private:
  const std::string& language_;
};

}  // namespace

void choose_first_language(Manifest& manifest) {
  visit_experiments(manifest, [](auto& experiment) {
    visit_texts(experiment, LanguageChoice(experiment.language.first()));
  });
}

Manifest in_language(Manifest manifest, const std::string& language) {
  visit_experiments(manifest, [&](auto& experiment) {
    visit_texts(experiment, LanguageChoice(language));
    visit_texts(experiment, [](const std::string&, auto& text) { text.by_language.clear(); });
    experiment.language = {{language}, false};
  });
  return manifest;
}

const nlohmann::json& page_texts(const OwnTexts& own, std::string_view language) {
  const PageTexts* texts = texts_in(own, language);
  return texts == nullptr ? built_in_texts(language) : texts->texts;
}

}  // namespace mien::pipeline
