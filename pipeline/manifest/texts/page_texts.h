#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/places.h"

namespace mien::pipeline {

/// The texts of the pages that participants see, in one language: "direction" ("ltr" or "rtl"),
/// and the sections "questionnaire", "matching", "in_matching" and "chains", as in
/// study/page/texts/en.yaml. That file says which keys and placeholders there are.
struct PageTexts {
  std::string language;  ///< BCP 47 tag: "de", "pt-BR"
  nlohmann::json texts;

  friend bool operator==(const PageTexts&, const PageTexts&) = default;
};

/// The languages with built-in texts, English first.
const std::vector<std::string>& built_in_languages();

/// The built-in texts of a language; those of English if there are none.
const nlohmann::json& built_in_texts(std::string_view language);

/// The YAML of a built-in language, as the file was at build time.
std::string_view built_in_texts_yaml(std::string_view language);

/// Whether this may be a language's tag (BCP 47): letters and digits in parts joined by hyphens.
bool is_language_tag(std::string_view tag);

/// The plural categories (Unicode CLDR) that texts of a built-in language distinguish: "one" and
/// "other" in English. Empty for other languages.
std::vector<std::string> plural_categories(std::string_view language);

/// Faults of texts in a language: keys that English does not have, texts that are empty or of
/// another form, unknown and missing placeholders, and unknown and missing plural forms. If they
/// must be `complete`, keys that are missing are faults, too.
std::vector<Fault> text_faults(const nlohmann::json& texts, std::string_view language,
                               bool complete, const Places& places);

/// Reads a file of a study's own texts:
///
///     language: sv
///     complete_from: en     # a built-in language, for texts that are not here
///     direction: ltr        # or rtl; that of complete_from if absent
///     questionnaire: {rate: Hur ser den här rörelsen ut?}
///
/// Where complete_from is absent, texts of a built-in language complete it, and a file of another
/// language must have all texts. Throws Faults that list its faults, and Error if it cannot be
/// read.
PageTexts read_texts(const std::filesystem::path& file);
PageTexts parse_texts(std::string_view yaml, const std::string& file);

}  // namespace mien::pipeline
