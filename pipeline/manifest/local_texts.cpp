#include "pipeline/manifest/local_texts.h"

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"

namespace mien::pipeline {

namespace {

constexpr char file_key[] = "file";

FiledText filed_text(const DocumentValue& given) {
  FiledText text;
  assign(&given.value, text.text);
  if (const nlohmann::json* file = member(given.value, file_key))
    read({*file, member_path(given.path, file_key), given.context}, text.file);
  return text;
}

OrderedJson written_text(const std::string& text, const std::filesystem::path& file,
                         const WritingOptions& how) {
  if (!file.empty()) return {{file_key, written(file, how)}};
  return text.empty() ? OrderedJson() : OrderedJson(text);
}

}  // namespace

void PageLanguageForm::read(const DocumentValue& given, PageLanguage& language) {
  if (given.value.is_string()) language = {{given.value.get<std::string>()}, false};
  const nlohmann::json* offered = member(given.value, "browser");
  if (offered == nullptr) return;
  std::vector<std::string> tags;
  pipeline::read({*offered, member_path(given.path, "browser"), given.context}, tags);
  if (!tags.empty()) language = {tags, true};
}

OrderedJson PageLanguageForm::write(const PageLanguage& language, const WritingOptions& how) {
  if (language.by_browser) return {{"browser", written(language.offered, how)}};
  return language.first();
}

void LocalTextForm::read(const DocumentValue& given, LocalText& text) {
  text = {};
  assign(&given.value, text.text);
  pipeline::read(given, text.by_language);
}

OrderedJson LocalTextForm::write(const LocalText& text, const WritingOptions& how) {
  if (!text.by_language.empty()) return written(text.by_language, how);
  return written(text.text, how);
}

void LocalWordsForm::read(const DocumentValue& given, LocalWords& words) {
  words = {};
  pipeline::read(given, words.words);
  pipeline::read(given, words.by_language);
}

OrderedJson LocalWordsForm::write(const LocalWords& words, const WritingOptions& how) {
  if (!words.by_language.empty()) return written(words.by_language, how);
  return written(words.words, how);
}

void TextForm::read(const DocumentValue& given, TextSource& source) {
  source = {};
  FiledText text = filed_text(given);
  source.text = std::move(text.text);
  source.file = std::move(text.file);
  if (!given.value.is_object()) return;
  for (const std::string& key : written_order(given.value, given.path, given.context.places))
    if (key != file_key)
      source.by_language.emplace_back(
          key, filed_text({given.value[key], member_path(given.path, key), given.context}));
}

OrderedJson TextForm::write(const TextSource& source, const WritingOptions& how) {
  if (source.by_language.empty()) return written_text(source.text, source.file, how);
  OrderedJson map = OrderedJson::object();
  for (const auto& [language, text] : source.by_language)
    map[language] = written_text(text.text, text.file, how);
  return map;
}

void OwnTextsForm::read(const DocumentValue& given, OwnTexts& own) {
  own = {};
  pipeline::read(given, own.files);
  if (!given.value.is_string()) return;
  own.files.emplace_back();
  pipeline::read(given, own.files.back());
}

OrderedJson OwnTextsForm::write(const OwnTexts& own, const WritingOptions& how) {
  return own.files.size() == 1 ? written(own.files.front(), how) : written(own.files, how);
}

const PageTexts* texts_in(const OwnTexts& own, std::string_view language) {
  const auto found = std::ranges::find(own.texts, language, &PageTexts::language);
  return found == own.texts.end() ? nullptr : &*found;
}

bool is_written_without_spaces(std::string_view language) {
  const std::string_view main = language.substr(0, language.find('-'));
  return main == "ja" || main == "zh";
}

}  // namespace mien::pipeline
