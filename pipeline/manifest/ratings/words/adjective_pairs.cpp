#include "pipeline/manifest/ratings/words/adjective_pairs.h"

#include <algorithm>

namespace mien::pipeline {

namespace {

using enum Primary;
using enum TranslationConfidence;

constexpr std::nullopt_t none = std::nullopt;

constexpr std::array<AdjectivePair, 41> pairs = {{
    {1, "slow-fast", "slow", "fast", "遅い", "速い", high, quickness, quickness},
    {2, "mild-violent", "mild", "violent", "穏やかな", "激しい", high, activeness, largeness},
    {3, "hard-soft", "hard", "soft", "硬い", "柔らかい", high, none, none},
    {4, "dull-quick", "dull", "quick", "のろい", "素早い", medium, quickness, quickness},
    {5, "quiet-noisy", "quiet", "noisy", "静かな", "騒がしい", high, activeness, largeness},
    {6, "angular-circular", "angular", "circular", "角ばった", "丸みのある", medium, none, none},
    {7, "blunt-sharp", "blunt", "sharp", "鈍い", "鋭い", high, quickness, largeness},
    {8, "dormant-brisk", "dormant", "brisk", "不活発な", "活発な", medium, activeness, activeness},
    {9, "edgy-round", "edgy", "round", "とがった", "丸い", low, none, largeness},
    {10, "weak-strong", "weak", "strong", "弱い", "強い", high, clearness, none},
    {11, "unpleasant-pleasant", "unpleasant", "pleasant", "不快な", "快い", high, activeness,
     activeness},
    {12, "inelastic-elastic", "inelastic", "elastic", "弾力のない", "弾力のある", high, none, none},
    {13, "dirty-clean", "dirty", "clean", "汚い", "きれいな", high, clearness, none},
    {14, "sad-happy", "sad", "happy", "悲しい", "嬉しい", high, activeness, activeness},
    {15, "bumpy-smooth", "bumpy", "smooth", "でこぼこした", "滑らかな", high, none, clearness},
    {16, "uncool-cool", "uncool", "cool", "かっこ悪い", "かっこいい", high, clearness, clearness},
    {17, "dark-bright", "dark", "bright", "暗い", "明るい", high, activeness, activeness},
    {18, "thin-thick", "thin", "thick", "細い", "太い", low, none, none},
    {19, "ugly-cute", "ugly", "cute", "かわいくない", "かわいい", medium, clearness, clearness},
    {20, "simple-gaudy", "simple", "gaudy", "地味な", "派手な", high, activeness, activeness},
    {21, "coarse-fine", "coarse", "fine", "粗い", "細かい", high, none, none},
    {22, "old-young", "old", "young", "年老いた", "若々しい", high, clearness, activeness},
    {23, "heavy-light", "heavy", "light", "重い", "軽い", high, activeness, activeness},
    {24, "strained-relaxed", "strained", "relaxed", "緊張した", "くつろいだ", medium, none, none},
    {25, "unstable-stable", "unstable", "stable", "不安定な", "安定した", high, clearness,
     clearness},
    {26, "small-large", "small", "large", "小さい", "大きい", high, largeness, largeness},
    {27, "unafraid-afraid", "unafraid", "afraid", "恐れのない", "怖がった", medium, none, none},
    {28, "artificial-natural", "artificial", "natural", "人工的な", "自然な", high, clearness,
     clearness},
    {29, "closed-open", "closed", "open", "閉鎖的な", "開放的な", high, largeness, activeness},
    {30, "adult-childish", "adult", "childish", "大人っぽい", "子供っぽい", high, none, largeness},
    {31, "vague-distinct", "vague", "distinct", "曖昧な", "はっきりした", high, clearness, none},
    {32, "narrow-broad", "narrow", "broad", "狭い", "広い", medium, largeness, none},
    {33, "ugly-beautiful", "ugly", "beautiful", "醜い", "美しい", high, none, clearness},
    {34, "poor-rich", "poor", "rich", "貧弱な", "豊かな", medium, clearness, activeness},
    {35, "tight-free", "tight", "free", "窮屈な", "自由な", medium, largeness, none},
    {36, "dim-sharp", "dim", "sharp", "ぼんやりした", "しゃきっとした", low, none, activeness},
    {37, "drab-clear", "drab", "clear", "くすんだ", "澄んだ", low, clearness, clearness},
    {38, "gloomy-cheerful", "gloomy", "cheerful", "陰気な", "陽気な", high, largeness, activeness},
    {39, "lonely-bustling", "lonely", "bustling", "寂しい", "にぎやかな", high, none, activeness},
    {40, "calm-excited", "calm", "excited", "落ち着いた", "興奮した", high, activeness, largeness},
    {41, "narrow-wide", "narrow", "wide", "幅の狭い", "幅の広い", medium, none, largeness},
}};

struct PrimaryNames {
  std::string_view english;
  std::string_view japanese;
};

constexpr std::array<PrimaryNames, primary_count> primary_names = {{
    {"quickness", "速さ"},
    {"clearness", "明瞭さ"},
    {"activeness", "活発さ"},
    {"largeness", "大きさ"},
}};

}  // namespace

std::span<const AdjectivePair> adjective_pairs() { return pairs; }

const AdjectivePair* find_adjective_pair(std::string_view key) {
  const auto found = std::ranges::find(pairs, key, &AdjectivePair::key);
  return found == pairs.end() ? nullptr : &*found;
}

std::string_view name_of(Primary primary) {
  return primary_names[static_cast<size_t>(primary)].english;
}

std::string_view japanese_name_of(Primary primary) {
  return primary_names[static_cast<size_t>(primary)].japanese;
}

}  // namespace mien::pipeline
