#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/manifest/texts/page_texts.h"

namespace mien::pipeline {

/// The language of a study's pages.
struct PageLanguage {
  /// Tags (BCP 47): "de". Of several, each participant reads the one that the browser prefers; the
  /// first if it prefers none of them.
  std::vector<std::string> offered = {"en"};
  bool by_browser = false;

  const std::string& first() const { return offered.front(); }
  friend bool operator==(const PageLanguage&, const PageLanguage&) = default;
};

/// `language: de`, or `language: {browser: [en, de]}`.
struct PageLanguageForm {
  static void read(const DocumentValue& given, PageLanguage& language);
  static nlohmann::ordered_json write(const PageLanguage& language, const WritingOptions& how);
  static void walk(auto& names) { names.add("browser"); }
};

/// Values by the tags of their languages, in the order of the document.
template <class Value>
using ByLanguage = std::vector<std::pair<std::string, Value>>;

/// The value in a language; null if there is none.
template <class Value>
const Value* in_language(const ByLanguage<Value>& values, std::string_view language) {
  const auto found = std::ranges::find(values, language, &std::pair<std::string, Value>::first);
  return found == values.end() ? nullptr : &found->second;
}

/// A short text of a study, such as a question: one for all languages, or one for each.
struct LocalText {
  std::string text;  ///< that of the first language offered, once the manifest has been resolved
  ByLanguage<std::string> by_language = {};

  bool empty() const { return text.empty() && by_language.empty(); }
  friend bool operator==(const LocalText&, const LocalText&) = default;
};

/// `title: Walks`, or `title: {en: Walks, de: Gangarten}`.
struct LocalTextForm {
  static void read(const DocumentValue& given, LocalText& text);
  static nlohmann::ordered_json write(const LocalText& text, const WritingOptions& how);
};

/// Words in an order, such as the choices of a question: for all languages, or for each.
struct LocalWords {
  std::vector<std::string> words;  ///< of the first language offered, once resolved
  ByLanguage<std::vector<std::string>> by_language = {};

  bool empty() const { return words.empty() && by_language.empty(); }
  friend bool operator==(const LocalWords&, const LocalWords&) = default;
};

/// `[happy, sad]`, or `{en: [happy, sad], de: [fröhlich, traurig]}`.
struct LocalWordsForm {
  static void read(const DocumentValue& given, LocalWords& words);
  static nlohmann::ordered_json write(const LocalWords& words, const WritingOptions& how);
};

/// A text in the manifest or in a file. In both cases, `text` contains it once the manifest has
/// been resolved.
struct FiledText {
  std::string text;
  std::filesystem::path file;  ///< resolved; empty: the text is in the manifest
};

/// A text for participants, given in the manifest or in a file: one for all languages, or one for
/// each.
struct TextSource {
  std::string text;            ///< that of the first language offered, once resolved
  std::filesystem::path file;  ///< resolved; empty: the text is in the manifest
  ByLanguage<FiledText> by_language = {};

  bool empty() const { return text.empty() && by_language.empty(); }
};

/// `consent: |` …, `consent: {file: consent.txt}`, or
/// `consent: {en: {file: consent.txt}, de: …}`.
struct TextForm {
  static void read(const DocumentValue& given, TextSource& source);
  static nlohmann::ordered_json write(const TextSource& source, const WritingOptions& how);
  static void walk(auto& names) { names.add("file"); }
};

/// Files of a study's own texts of pages, and what they hold once the manifest has been resolved.
struct OwnTexts {
  std::vector<std::filesystem::path> files;
  std::vector<PageTexts> texts;
};

/// `texts: sv.yaml`, or `texts: [sv.yaml, de.yaml]`.
struct OwnTextsForm {
  static void read(const DocumentValue& given, OwnTexts& own);
  static nlohmann::ordered_json write(const OwnTexts& own, const WritingOptions& how);
};

/// The own texts in a language; null if there are none.
const PageTexts* texts_in(const OwnTexts& own, std::string_view language);

/// Whether sentences of a language follow each other without spaces between words.
bool is_written_without_spaces(std::string_view language);

}  // namespace mien::pipeline
