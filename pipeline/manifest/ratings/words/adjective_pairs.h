#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace mien::pipeline {

/// The four primary impressions of walking in the adjective paper: the clusters of adjective pairs.
enum class Primary { quickness, clearness, activeness, largeness };

inline constexpr int primary_count = 4;

/// The confidence in our Japanese translation of a pair; the wording of the printed questionnaire
/// is unknown.
enum class TranslationConfidence { high, medium, low };

/// A bipolar scale of the questionnaire. Its key is also its id in manifests and tables.
struct AdjectivePair {
  int id;                ///< 1 … 41, the order of Table 1 of the adjective paper
  std::string_view key;  ///< "low-high", unique: "sad-happy"
  std::string_view low;  ///< English adjective at parameter 0
  std::string_view high;
  std::string_view ja_low;  ///< Japanese, UTF-8, our translation
  std::string_view ja_high;
  TranslationConfidence confidence;
  std::optional<Primary> table_2;  ///< cluster in Table 2 (first experiment, 27 pairs kept)
  std::optional<Primary> table_3;  ///< cluster in Table 3 (second experiment, 29 pairs kept)
};

/// Returns all 41 pairs, in the order of their ids.
std::span<const AdjectivePair> adjective_pairs();

/// Returns the pair with that key, or nullptr.
const AdjectivePair* find_adjective_pair(std::string_view key);

/// Returns "quickness", "clearness", "activeness" or "largeness".
std::string_view name_of(Primary primary);

/// Returns 速さ, 明瞭さ, 活発さ or 大きさ.
std::string_view japanese_name_of(Primary primary);

}  // namespace mien::pipeline
