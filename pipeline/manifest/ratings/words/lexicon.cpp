#include "pipeline/manifest/ratings/words/lexicon.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <glib.h>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/reading/yaml_json.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

/// The text in NFKC, case folded; unchanged where it is not UTF-8.
std::string unified(std::string_view text) {
  struct Free {
    void operator()(gchar* string) const { g_free(string); }
  };
  using GString = std::unique_ptr<gchar, Free>;
  const auto length = static_cast<gssize>(text.size());
  const GString normal(g_utf8_normalize(text.data(), length, G_NORMALIZE_NFKC));
  if (!normal) return std::string(text);
  const GString lower(g_utf8_casefold(normal.get(), -1));
  return lower.get();
}

bool is_left_out(char c) { return c == '"' || c == '\\'; }

class LexiconReader {
 public:
  LexiconReader(const json& document, const std::vector<std::string>& scales, const Places& places,
                std::vector<Fault>& faults)
      : document_(document), scales_(scales), places_(places), faults_(faults) {}

  Lexicon read() {
    if (document_.contains("languages")) {
      for (const std::string& name : written_order(document_["languages"], "languages", places_)) {
        add_language(name, document_["languages"][name]);
      }
    }
    if (document_.contains("words")) {
      for (const std::string& scale : written_order(document_["words"], "words", places_)) {
        add_scale(scale, document_["words"][scale]);
      }
    }
    return std::move(lexicon_);
  }

 private:
  void add_fault(const std::string& path, std::string wrong, std::string remedy) {
    faults_.push_back({place_of(places_, path), path, std::move(wrong), std::move(remedy)});
  }

  void add_language(const std::string& name, const json& given) {
    const std::string path = member_path("languages", name);
    Language language;
    language.name = name;
    language.called.push_back(folded(name));
    for (const auto& called : given.value("called", json::array())) {
      language.called.push_back(folded(called.get<std::string>()));
    }
    for (const std::string& called : language.called) {
      const Language* other = find_language(lexicon_, called);
      if (other == nullptr) continue;
      add_fault(path,
                fmt::format("{} is also named {}", motion::in_quotes(other->name),
                            motion::in_quotes(called)),
                "name each language once");
    }
    add_grades(given, "strengthened", Grade::strengthened, language);
    add_grades(given, "softened", Grade::softened, language);
    add_grades(given, "negated", Grade::negated, language);
    lexicon_.languages.push_back(std::move(language));
  }

  void add_grades(const json& given, const char* member, Grade grade, Language& language) {
    if (!given.contains(member)) return;
    const std::string path = member_path(member_path("languages", language.name), member);
    for (std::size_t i = 0; i < given[member].size(); ++i) {
      const std::string word = folded(given[member][i].get<std::string>());
      if (language.grades.emplace(word, grade).first->second == grade) continue;
      add_fault(element_path(path, i),
                fmt::format("{} has a second meaning", motion::in_quotes(word)),
                "remove one of them");
    }
  }

  void add_scale(const std::string& scale, const json& ends) {
    const std::string path = member_path("words", scale);
    if (std::find(scales_.begin(), scales_.end(), scale) == scales_.end()) {
      faults_.push_back({key_place_of(places_, path), path,
                         fmt::format("unknown scale {}", motion::in_quotes(scale)),
                         motion::did_you_mean(scale, scales_)});
      return;
    }
    for (const auto& [end, direction] : {std::pair{"low", -1}, std::pair{"high", 1}}) {
      if (!ends.contains(end)) continue;
      for (const auto& [name, words] : ends[end].items()) {
        add_words(member_path(member_path(path, end), name), name, words, {scale, direction});
      }
    }
  }

  void add_words(const std::string& path, const std::string& name, const json& words,
                 const WordMeaning& meaning) {
    const auto language = std::find_if(lexicon_.languages.begin(), lexicon_.languages.end(),
                                       [&](const Language& one) { return one.name == name; });
    if (language == lexicon_.languages.end()) {
      faults_.push_back({key_place_of(places_, path), path,
                         fmt::format("unknown language {}", motion::in_quotes(name)),
                         "describe it under languages"});
      return;
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string word = folded(words[i].get<std::string>());
      const auto [entry, is_new] = language->words.emplace(word, meaning);
      if (language->grades.contains(word) || !(entry->second == meaning)) {
        add_fault(element_path(path, i),
                  fmt::format("{} has a second meaning", motion::in_quotes(word)),
                  "remove one of them, or the word altogether if it is ambiguous");
      }
    }
  }

  const json& document_;
  const std::vector<std::string>& scales_;
  const Places& places_;
  std::vector<Fault>& faults_;
  Lexicon lexicon_;
};

}  // namespace

std::string folded(std::string_view text) {
  std::string result;
  for (const char c : unified(text)) {
    if (is_left_out(c)) continue;
    const bool is_space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!is_space) {
      result += c;
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  if (result.ends_with(' ')) result.pop_back();
  return result;
}

const Language* find_language(const Lexicon& lexicon, std::string_view called) {
  const std::string name = folded(called);
  for (const Language& language : lexicon.languages) {
    if (std::find(language.called.begin(), language.called.end(), name) != language.called.end()) {
      return &language;
    }
  }
  return nullptr;
}

Lexicon lexicon_from(const json& document, const std::vector<std::string>& scales,
                     const Places& places, std::vector<Fault>& faults) {
  return LexiconReader(document, scales, places, faults).read();
}

}  // namespace mien::pipeline
