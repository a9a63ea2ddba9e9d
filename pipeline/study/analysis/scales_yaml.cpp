#include "pipeline/study/analysis/scales_yaml.h"

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

namespace {

/// JSON strings are YAML strings. UTF-8 stays as it is.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

/// A YAML key, unquoted where that is unambiguous.
std::string key_of(const std::string& id) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto plain = [&](char c) { return letter(c) || c == '-' || c == '_'; };
  const bool word = !id.empty() && letter(id.front()) && std::ranges::all_of(id, plain);
  const bool reserved = id == "null" || id == "true" || id == "false" || id == "yes" ||
                        id == "no" || id == "on" || id == "off" || id == "y" || id == "n";
  return word && !reserved ? id : quoted(id);
}

std::string range_of(double least, double most) {
  return fmt::format("[{}, {}]", shortest(least), shortest(most));
}

std::string fields_of(const Scale& scale, const Scale& usual) {
  std::string text = fmt::format("low: {}, high: {}", quoted(scale.low), quoted(scale.high));
  if (!scale.japanese_low.empty() || !scale.japanese_high.empty())
    text += fmt::format(", ja: [{}, {}]", quoted(scale.japanese_low), quoted(scale.japanese_high));
  if (scale.least != usual.least || scale.most != usual.most)
    text += ", range: " + range_of(scale.least, scale.most);
  if (!scale.loadings.empty()) {
    text += ", loadings: {";
    for (size_t i = 0; i < scale.loadings.size(); ++i)
      text += fmt::format("{}{}: {}", i > 0 ? ", " : "", scale.loadings[i].first,
                          shortest(scale.loadings[i].second));
    text += "}";
  }
  return text;
}

std::string group_text(const ScaleGroup& group) {
  std::string text = fmt::format("  {}:\n", key_of(group.id));
  if (!group.japanese.empty()) text += fmt::format("    ja: {}\n", quoted(group.japanese));
  text += "    scales:\n";
  for (const std::string& scale : group.scales) text += fmt::format("      - {}\n", key_of(scale));
  return text;
}

std::string list_of(const std::vector<std::string>& words) { return nlohmann::json(words).dump(); }

std::string language_text(const Language& language) {
  std::string text = fmt::format("  {}:\n", key_of(language.name));
  // The first of them is the name itself.
  if (language.called.size() > 1)
    text += fmt::format("    called: {}\n",
                        list_of({language.called.begin() + 1, language.called.end()}));
  for (const auto& [grade, name] :
       {std::pair(Grade::strengthened, "strengthened"), std::pair(Grade::softened, "softened"),
        std::pair(Grade::negated, "negated")}) {
    std::vector<std::string> words;
    for (const auto& [word, own] : language.grades)
      if (own == grade) words.push_back(word);
    if (!words.empty()) text += fmt::format("    {}: {}\n", name, list_of(words));
  }
  return text == fmt::format("  {}:\n", key_of(language.name))
             ? fmt::format("  {}: {{}}\n", key_of(language.name))
             : text;
}

/// Words of all languages for one end of a scale; empty when there are none.
std::string end_text(const Lexicon& lexicon, const WordMeaning& meaning) {
  std::string text;
  for (const Language& language : lexicon.languages) {
    std::vector<std::string> words;
    for (const auto& [word, own] : language.words)
      if (own == meaning) words.push_back(word);
    if (!words.empty())
      text += fmt::format("      {}: {}\n", key_of(language.name), list_of(words));
  }
  return text;
}

std::string lexicon_text(const ScaleSet& set) {
  std::string text;
  if (!set.lexicon.languages.empty()) text += "languages:\n";
  for (const Language& language : set.lexicon.languages) text += language_text(language);
  std::string words;
  for (const Scale& scale : set.scales) {
    const std::string low = end_text(set.lexicon, {scale.id, -1});
    const std::string high = end_text(set.lexicon, {scale.id, 1});
    if (low.empty() && high.empty()) continue;
    words += fmt::format("  {}:\n", key_of(scale.id));
    if (!low.empty()) words += "    low:\n" + low;
    if (!high.empty()) words += "    high:\n" + high;
  }
  return words.empty() ? text : text + "words:\n" + words;
}

}  // namespace

std::string to_yaml(const ScaleSet& set, const std::string& head,
                    const std::map<std::string, std::string>& remarks) {
  std::string text;
  std::istringstream lines(head);
  for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
  if (!set.name.empty()) text += fmt::format("name: {}\n", quoted(set.name));
  const Scale& usual = set.scales.front();
  text += "range: " + range_of(usual.least, usual.most) + "\nscales:\n";
  for (const Scale& scale : set.scales) {
    text += fmt::format("  {}: {{{}}}", key_of(scale.id), fields_of(scale, usual));
    if (const auto remark = remarks.find(scale.id); remark != remarks.end())
      text += "  # " + remark->second;
    text += '\n';
  }
  if (!set.groups.empty()) text += "groups:\n";
  for (const ScaleGroup& group : set.groups) text += group_text(group);
  return text + lexicon_text(set);
}

std::string clusters_yaml(const Analysis& analysis, const ScaleSet& scales) {
  ScaleSet set = scales;
  set.groups.clear();
  for (const ScaleCluster& cluster : analysis.clusters) {
    ScaleGroup group{cluster.name, cluster.japanese, {}};
    for (const int row : cluster.members)
      group.scales.push_back(analysis.impressions.scales[static_cast<size_t>(row)]);
    set.groups.push_back(group);
  }
  std::map<std::string, std::string> remarks;
  for (const Scale& scale : scales.scales) remarks[scale.id] = "no answers";
  for (const Quantity& q : analysis.quantities) {
    remarks[q.scale] = q.neutral && q.disputed ? "removed: neutral, disagreement"
                       : q.neutral             ? "removed: neutral"
                                               : "removed: disagreement";
    if (q.retained()) remarks.erase(q.scale);
  }
  std::string head = "Scales of a rating study and the clusters derived from its answers.";
  if (analysis.impressions.simulated) head += "\nThe ratings are simulated.";
  if (analysis.none_retained)
    head += "\nThe thresholds removed all scales; all of them were clustered.";
  return to_yaml(set, head, remarks);
}

std::string adjective_pairs_yaml() {
  return to_yaml(
      builtin_scales(),
      "The 41 built-in adjective pairs of mien and the four clusters of the first experiment. Copy "
      "this\nfile to rename, remove or regroup pairs. The Japanese translation is that of mien.");
}

}  // namespace mien::pipeline
