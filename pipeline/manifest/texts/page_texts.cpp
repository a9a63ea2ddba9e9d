#include "pipeline/manifest/texts/page_texts.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/reading/yaml_json.h"

#include "embedded/texts_ar.h"
#include "embedded/texts_de.h"
#include "embedded/texts_en.h"
#include "embedded/texts_es.h"
#include "embedded/texts_fi.h"
#include "embedded/texts_fr.h"
#include "embedded/texts_ja.h"
#include "embedded/texts_zh.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

constexpr char english[] = "en";
constexpr const char* section_names[] = {"questionnaire", "matching", "in_matching", "chains"};

struct BuiltInLanguage {
  std::string_view tag;
  std::string_view yaml;
  /// Plural categories of CLDR 44 for cardinal numbers.
  std::vector<std::string> categories;
};

const std::vector<BuiltInLanguage>& languages() {
  static const std::vector<BuiltInLanguage> all = {
      {"en", embedded_texts_en, {"one", "other"}},
      {"ja", embedded_texts_ja, {"other"}},
      {"de", embedded_texts_de, {"one", "other"}},
      {"fr", embedded_texts_fr, {"one", "many", "other"}},
      {"es", embedded_texts_es, {"one", "many", "other"}},
      {"fi", embedded_texts_fi, {"one", "other"}},
      {"zh", embedded_texts_zh, {"other"}},
      {"ar", embedded_texts_ar, {"zero", "one", "two", "few", "many", "other"}}};
  return all;
}

const BuiltInLanguage* language_with(std::string_view tag) {
  const auto found = std::ranges::find(languages(), tag, &BuiltInLanguage::tag);
  return found == languages().end() ? nullptr : &*found;
}

JsonReading reading_of(std::string_view yaml, const std::string& file) {
  static const json no_schema = json::object();
  std::vector<Fault> faults;
  JsonReading reading = read_json(yaml, file, no_schema, Environment(), faults);
  if (!faults.empty()) throw Faults(faults);
  return reading;
}

/// A text for each plural category of a number: {count: {one: …, other: …}}.
bool is_plural(const json& text) {
  return text.is_object() && text.size() == 1 && text.front().is_object();
}

/// The names in braces of a text or of all its plural forms.
Names placeholders(const json& text) {
  Names names;
  if (text.is_object()) {
    for (const json& one : text) {
      for (std::string& name : placeholders(one))
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    return names;
  }
  if (!text.is_string()) return names;
  const auto& words = text.get_ref<const std::string&>();
  for (std::size_t open = words.find('{'); open != words.npos; open = words.find('{', open + 1)) {
    const std::size_t close = words.find('}', open);
    if (close == words.npos) break;
    std::string name = words.substr(open + 1, close - open - 1);
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

/// Compares texts with those of English.
class TextsCheck {
 public:
  TextsCheck(std::string_view language, bool complete, const Places& places)
      : categories_(plural_categories(language)), complete_(complete), list_(places) {}

  void check_group(const json& given, const json& measure, const std::string& path) {
    if (!given.is_object()) return list_.add(path, "is not a map of texts", "write key: text");
    Names known;
    for (const auto& [key, text] : measure.items()) known.push_back(key);
    for (const auto& [key, text] : given.items()) {
      const std::string at = member_path(path, key);
      if (measure.contains(key)) {
        check_text(text, measure[key], at);
      } else {
        list_.add_at_key(at, "no page has this text", motion::did_you_mean(key, known));
      }
    }
    const Names missing = missing_in(given, known);
    if (!complete_ || missing.empty()) return;
    const std::string more =
        missing.size() == 1 ? "" : " and " + std::to_string(missing.size() - 1) + " more";
    list_.add(path, "has no text " + motion::in_quotes(missing.front()) + more,
              "add it, or complete_from: a language with built-in texts");
  }

  std::vector<Fault> take() { return list_.take(); }

 private:
  void check_text(const json& given, const json& measure, const std::string& path) {
    if (measure.is_array()) {
      const bool is_list =
          given.is_array() && !given.empty() && std::ranges::all_of(given, [](const json& one) {
            return one.is_string() && !one.get_ref<const std::string&>().empty();
          });
      if (!is_list) list_.add(path, "is not a list of paragraphs", "write [text, text]");
    } else if (measure.is_object() && !is_plural(measure)) {
      check_group(given, measure, path);
    } else if (is_plural(given)) {
      check_plural(given, placeholders(measure), path);
    } else {
      check_words(given, placeholders(measure), placeholders(measure), path);
      if (is_plural(measure) && categories_.size() > 1 && given.is_string())
        list_.add(path, "has no plural forms", form_of(measure.begin().key()));
    }
  }

  static Names missing_in(const json& given, const Names& known) {
    Names missing;
    for (const std::string& key : known)
      if (!given.contains(key)) missing.push_back(key);
    return missing;
  }

  /// The form of a text with plural forms, as a remedy.
  std::string form_of(const std::string& number) const {
    std::string form = "write {" + number + ": {";
    for (const std::string& category : categories_)
      form += (category == categories_.front() ? "" : ", ") + category + ": …";
    return form + "}}";
  }

  void check_plural(const json& given, const Names& names, const std::string& path) {
    const std::string& number = given.begin().key();
    if (std::ranges::find(names, number) == names.end())
      return list_.add_at_key(member_path(path, number), "the text has no such placeholder",
                              names.empty() ? "write a text without plural forms"
                                            : motion::did_you_mean(number, names));
    static const Names all = {"zero", "one", "two", "few", "many", "other"};
    const Names& known = categories_.empty() ? all : categories_;
    const std::string at_number = member_path(path, number);
    for (const auto& [category, words] : given.front().items()) {
      const std::string at = member_path(at_number, category);
      if (std::ranges::find(known, category) == known.end()) {
        list_.add_at_key(at, "the language has no such plural category",
                         motion::did_you_mean(category, known));
        continue;
      }
      // "One answer is missing" needs no number.
      Names needed = names;
      if (category != "other") std::erase(needed, number);
      check_words(words, names, needed, at);
    }
    for (const std::string& category : categories_.empty() ? Names{"other"} : categories_)
      if (!given.front().contains(category))
        list_.add(at_number, "has no plural form " + motion::in_quotes(category), "add it");
  }

  void check_words(const json& given, const Names& known, const Names& needed,
                   const std::string& path) {
    if (!given.is_string() || given.get_ref<const std::string&>().empty())
      return list_.add(path, "is not a text", "write a text");
    const Names names = placeholders(given);
    for (const std::string& name : names)
      if (std::ranges::find(known, name) == known.end())
        list_.add(path, "the text has no placeholder {" + name + "}",
                  known.empty() ? "omit it" : motion::did_you_mean(name, known));
    for (const std::string& name : needed)
      if (std::ranges::find(names, name) == names.end())
        list_.add(path, "the placeholder {" + name + "} is missing", "add it");
  }

  Names categories_;
  bool complete_;
  FaultList list_;
};

/// Puts texts in place of others; plural forms are replaced as a whole.
void put(const json& given, json& texts) {
  for (const auto& [key, text] : given.items()) {
    if (text.is_object() && !is_plural(text)) {
      put(text, texts[key]);
    } else {
      texts[key] = text;
    }
  }
}

const json* member_of(const json& document, const char* key) {
  const auto found = document.find(key);
  return found == document.end() ? nullptr : &*found;
}

std::vector<Fault> head_faults(const json& document, const Places& places) {
  FaultList list(places);
  const Names known = {"language", "complete_from", "direction", "questionnaire",
                       "matching", "in_matching",   "chains"};
  for (const auto& [key, value] : document.items())
    if (std::ranges::find(known, key) == known.end())
      list.add_at_key(key, "unknown key", motion::did_you_mean(key, known));
  const json* language = member_of(document, "language");
  if (language == nullptr || !language->is_string() ||
      !is_language_tag(language->get_ref<const std::string&>()))
    list.add("language", "the texts have no language", "add language: and its tag, such as sv");
  if (const json* from = member_of(document, "complete_from"))
    if (!from->is_string() || language_with(from->get_ref<const std::string&>()) == nullptr)
      list.add("complete_from", "has no built-in texts",
               motion::did_you_mean(from->is_string() ? from->get<std::string>() : "",
                                    built_in_languages()));
  if (const json* direction = member_of(document, "direction"))
    if (*direction != "ltr" && *direction != "rtl")
      list.add("direction", "is neither ltr nor rtl", "write ltr or rtl");
  return list.take();
}

}  // namespace

const std::vector<std::string>& built_in_languages() {
  static const std::vector<std::string> tags = [] {
    std::vector<std::string> names;
    for (const BuiltInLanguage& one : languages()) names.emplace_back(one.tag);
    return names;
  }();
  return tags;
}

std::string_view built_in_texts_yaml(std::string_view language) {
  const BuiltInLanguage* found = language_with(language);
  return found == nullptr ? std::string_view(embedded_texts_en) : found->yaml;
}

const json& built_in_texts(std::string_view language) {
  static const std::map<std::string, json, std::less<>> texts = [] {
    std::map<std::string, json, std::less<>> all;
    for (const BuiltInLanguage& one : languages())
      all.emplace(one.tag, reading_of(one.yaml, std::string(one.tag) + ".yaml").document);
    return all;
  }();
  const auto found = texts.find(language);
  return found == texts.end() ? texts.at(english) : found->second;
}

bool is_language_tag(std::string_view tag) {
  constexpr std::size_t longest_part = 8, longest_tag = 35;
  std::size_t part = 0, parts = 1;
  for (const unsigned char letter : tag) {
    if (letter == '-') {
      if (part == 0) return false;
      part = 0;
      ++parts;
      continue;
    }
    const bool fits = parts == 1 ? std::isalpha(letter) != 0 : std::isalnum(letter) != 0;
    if (!fits || ++part > longest_part) return false;
  }
  return part > 0 && tag.find('-') != 1 && tag.size() > 1 && tag.size() <= longest_tag;
}

std::vector<std::string> plural_categories(std::string_view language) {
  const BuiltInLanguage* found = language_with(language);
  return found == nullptr ? std::vector<std::string>() : found->categories;
}

std::vector<Fault> text_faults(const json& texts, std::string_view language, bool complete,
                               const Places& places) {
  TextsCheck check(language, complete, places);
  for (const char* section : section_names) {
    if (const json* given = member_of(texts, section)) {
      check.check_group(*given, built_in_texts(english)[section], section);
    } else if (complete) {
      check.check_group(json::object(), built_in_texts(english)[section], section);
    }
  }
  return check.take();
}

PageTexts read_texts(const std::filesystem::path& file) {
  const motion::FileReading reading = motion::bytes_of_file(file, motion::max_document_bytes);
  if (reading.bytes) return parse_texts(*reading.bytes, file.string());
  throw Error({file.string(), 0, 0}, reading.error, "name a file of texts (YAML)");
}

PageTexts parse_texts(std::string_view yaml, const std::string& file) {
  const JsonReading reading = reading_of(yaml, file);
  if (!reading.document.is_object())
    throw Error({file, 1, 1}, "is not a file of texts", "write language: … and questionnaire: …");
  std::vector<Fault> faults = head_faults(reading.document, reading.places);
  if (!faults.empty()) throw Faults(faults);
  PageTexts own;
  own.language = reading.document["language"];
  const json* from = member_of(reading.document, "complete_from");
  const std::string base = from != nullptr ? from->get<std::string>() : own.language;
  const bool is_completed = language_with(base) != nullptr;
  faults = text_faults(reading.document, own.language, !is_completed, reading.places);
  if (!faults.empty()) throw Faults(faults);
  own.texts = is_completed ? built_in_texts(base) : json{{"direction", "ltr"}};
  if (const json* direction = member_of(reading.document, "direction"))
    own.texts["direction"] = *direction;
  for (const char* section : section_names)
    if (const json* given = member_of(reading.document, section)) put(*given, own.texts[section]);
  return own;
}

}  // namespace mien::pipeline
