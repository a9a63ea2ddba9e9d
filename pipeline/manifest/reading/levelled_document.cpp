#include "pipeline/manifest/reading/levelled_document.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/documents/places.h"
#include "pipeline/base/reading/value_codecs.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

constexpr std::string_view weights_part = "weights.";

/// The number of digits after the decimal point of a number's shortest notation.
int decimals_of(double value) {
  const std::string text = fmt::format("{:.15f}", value);
  const double written = std::strtod(shortest(value).c_str(), nullptr);
  int decimals = 0;
  while (decimals < 15 &&
         std::strtod(fmt::format("{:.{}f}", value, decimals).c_str(), nullptr) != written)
    ++decimals;
  return decimals;
}

/// A value between the ends of a range as an exact decimal, with four digits of the difference from
/// the one before, and with as many decimals as the ends.
double rounded_level(double value, double difference, int least_decimals, bool is_whole) {
  if (is_whole) return std::round(value);
  const int digits = 3 - static_cast<int>(std::floor(std::log10(std::abs(difference))));
  const int decimals = std::clamp(std::max(digits, least_decimals), 0, 15);
  return std::strtod(fmt::format("{:.{}f}", value, decimals).c_str(), nullptr);
}

std::vector<double> range_values(double from, double to, int steps, bool is_log, bool is_whole) {
  if (from == to) throw Error("the ends are equal", "give two different numbers");
  if (is_log && !(from > 0.0 && to > 0.0))
    throw Error("equal ratios need ends above 0",
                "use spacing: linear, or begin and end above 0 and list the stimulus of 0 itself");
  if (is_whole && (from != std::round(from) || to != std::round(to)))
    throw Error("the ends are not whole numbers", "use whole numbers, or omit whole");
  const auto at = [&](int i) {
    const double share = static_cast<double>(i) / (steps - 1);
    return is_log ? from * std::pow(to / from, share) : from + (to - from) * share;
  };
  const int decimals = std::max(decimals_of(from), decimals_of(to));
  std::vector<double> values = {from};
  for (int i = 1; i < steps - 1; ++i)
    values.push_back(rounded_level(at(i), at(i) - at(i - 1), decimals, is_whole));
  values.push_back(to);
  return values;
}

/// Whole numbers as integers, which whole-number options demand.
json level_json(double value) {
  constexpr double exact = 9007199254740992.0;  // 2⁵³
  if (value == std::round(value) && std::abs(value) < exact)
    return static_cast<std::int64_t>(value);
  return value;
}

/// One part of a path: a key, or a place in an array.
struct PathPart {
  std::string key;
  std::optional<std::size_t> index;
};

/// "[1]"
bool is_index(std::string_view part) {
  constexpr std::size_t brackets = 2;
  return part.size() > brackets && part.starts_with('[') && part.ends_with(']') &&
         std::ranges::all_of(part.substr(1, part.size() - brackets),
                             [](char c) { return c >= '0' && c <= '9'; });
}

/// "modify[1].strength" as modify, 1, strength. The name of an example may hold dots.
std::vector<PathPart> parts_of(std::string_view path) {
  if (path.starts_with(weights_part))
    return {{"weights", {}}, {std::string(path.substr(weights_part.size())), {}}};
  std::vector<PathPart> parts;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find_first_of(".[", 1), path.size());
    std::string_view part = path.substr(0, end);
    path.remove_prefix(end);
    if (is_index(part)) {
      const std::string digits(part.substr(1, part.size() - 2));
      parts.push_back({"", std::strtoul(digits.c_str(), nullptr, 10)});
      continue;
    }
    if (part.starts_with('.')) part.remove_prefix(1);
    parts.push_back({std::string(part), {}});
  }
  return parts;
}

/// The value of one part; null where there is none. A figure that is given by its name alone
/// becomes a map.
json& descend(json& value, const PathPart& part) {
  if (part.index) {
    if (!value.is_array() || *part.index >= value.size())
      throw Error(fmt::format("there is no element [{}]", *part.index),
                  "count elements from 0, as in modify[1].strength");
    return value[*part.index];
  }
  if (value == part.key) value = json::object({{part.key, json::object()}});
  if (value.is_null()) value = json::object();
  if (value.is_array())
    throw Error(fmt::format("there are several values where {} is named", part.key),
                "name one of them, as in modify[1].strength");
  if (!value.is_object())
    throw Error(fmt::format("{} is not part of {}", part.key, motion::in_quotes(value.dump())),
                "name a number of the stimulus, as in modify.strength");
  return value[part.key];
}

void multiply_others(json& weights, const std::string& name, double level) {
  if (!(level >= 0.0 && level <= 1.0))
    throw Error(fmt::format("the weight {} is not from 0 to 1", shortest(level)),
                "use weights from 0 to 1; the other examples share the rest");
  double sum = 0.0;
  for (const auto& [other, weight] : weights.items())
    if (other != name && weight.is_number()) sum += weight.get<double>();
  if (!(sum > 0.0))
    throw Error("no other example has a weight",
                "add weights of the other examples, which share what is left of 1");
  for (auto& [other, weight] : weights.items())
    if (other != name && weight.is_number()) weight = weight.get<double>() / sum * (1.0 - level);
}

/// Sets the number at a path of a stimulus.
void set_level(json& stimulus, const std::string& path, double level) {
  json* value = &stimulus;
  for (const PathPart& part : parts_of(path)) value = &descend(*value, part);
  if (!value->is_null())
    throw Error(fmt::format("{} is also given", path), "omit it, or name another number");
  *value = level_json(level);
  if (path.starts_with(weights_part))
    multiply_others(stimulus["weights"], path.substr(weights_part.size()), level);
}

/// `levels:` of a stimulus, if its values have the types that the schema demands.
struct StatedLevels {
  std::string factor, of;
  json values;
};

bool are_numbers(const json& values) {
  return std::ranges::all_of(values, [](const json& value) { return value.is_number(); });
}

/// Whether a value is a number that the schema permits as an end of a range.
bool is_end(const json* value) {
  constexpr double most = 1e9;
  return value != nullptr && value->is_number() && std::abs(value->get<double>()) <= most;
}

bool is_range(const json& values) {
  const json* steps = member(values, "steps");
  const json* from = member(values, "from");
  const json* to = member(values, "to");
  return steps != nullptr && steps->is_number_integer() && *steps >= 2 && *steps <= most_levels &&
         is_end(from) && is_end(to);
}

std::optional<StatedLevels> stated_levels(const json& stimulus) {
  const json* levels = member(stimulus, "levels");
  if (levels == nullptr || !stimulus.contains("id") || !stimulus["id"].is_string())
    return std::nullopt;
  StatedLevels stated;
  assign(member(*levels, "factor"), stated.factor);
  assign(member(*levels, "of"), stated.of);
  const json* values = member(*levels, "values");
  if (stated.factor.empty() || stated.of.empty() || values == nullptr) return std::nullopt;
  const bool is_list = values->is_array() && !values->empty() && values->size() <= most_levels &&
                       are_numbers(*values);
  if (!is_list && !is_range(*values)) return std::nullopt;
  stated.values = *values;
  return stated;
}

/// The stimulus at one of its levels.
json stimulus_at(const json& stimulus, const StatedLevels& stated, double level) {
  json made = stimulus;
  set_level(made, stated.of, level);
  if (stated.of != "factors." + stated.factor) set_level(made, "factors." + stated.factor, level);
  made["id"] = made["id"].get<std::string>() + "-" + shortest(level);
  made["levels"]["values"] = json::array({level_json(level)});
  return made;
}

/// Where the levels of a stimulus are stated: each value of a list, otherwise the range.
std::string level_place(const std::string& values_path, const json& values, std::size_t index) {
  return values.is_array() ? element_path(values_path, index) : values_path;
}

/// Whether a path is that of a value or of one of its parts.
bool is_within(std::string_view path, std::string_view value) {
  return path.starts_with(value) &&
         (path.size() == value.size() || path[value.size()] == '.' || path[value.size()] == '[');
}

/// Copies the places of a value and of its parts, under another path.
void copy_places(const std::map<std::string, Place>& from, const std::string& old_path,
                 const std::string& new_path, std::map<std::string, Place>& to) {
  for (auto place = from.lower_bound(old_path);
       place != from.end() && place->first.starts_with(old_path); ++place)
    if (is_within(place->first, old_path))
      to[new_path + place->first.substr(old_path.size())] = place->second;
}

/// Builds the new document and its places.
class Levelling {
 public:
  explicit Levelling(JsonReading reading) : old_(std::move(reading)) {}

  LevelledDocument levelled() {
    keep_other_places(old_.places.values, places_.values);
    keep_other_places(old_.places.keys, places_.keys);
    for (std::size_t i = 0; i < old_stimuli().size(); ++i) add(i);
    result_.reading.document = std::move(old_.document);
    result_.reading.document["stimuli"] = std::move(stimuli_);
    result_.reading.places = std::move(places_);
    result_.reading.renamed = std::move(old_.renamed);
    return std::move(result_);
  }

 private:
  const json& old_stimuli() const { return old_.document["stimuli"]; }

  static void keep_other_places(const std::map<std::string, Place>& old,
                                std::map<std::string, Place>& kept) {
    for (const auto& [path, place] : old)
      if (!path.starts_with("stimuli[")) kept[path] = place;
  }

  void add_fault(const std::string& path, const Error& error) {
    result_.faults.push_back({place_of(old_.places, path), path, error.what(), ""});
  }

  /// The stimuli of all levels; none if one of them cannot be made.
  std::vector<json> stimuli_at(const std::string& path, const json& stimulus,
                               const StatedLevels& stated) {
    std::vector<double> values;
    try {
      values = level_values(stated.values);
    } catch (const Error& error) {
      add_fault(member_path(path, "values"), error);
      return {};
    }
    if (stimuli_.size() + values.size() > most_stimuli) {
      add_fault(path,
                Error(fmt::format("with all levels there are more than {} stimuli", most_stimuli),
                      "use fewer levels"));
      return {};
    }
    std::vector<json> made;
    try {
      for (const double value : values) made.push_back(stimulus_at(stimulus, stated, value));
    } catch (const Error& error) {
      add_fault(member_path(path, "of"), error);
      return {};
    }
    return made;
  }

  void add(std::size_t old_index) {
    const json& stimulus = old_stimuli()[old_index];
    const std::optional<StatedLevels> stated = stated_levels(stimulus);
    const std::string levels = member_path(element_path("stimuli", old_index), "levels");
    if (!stated) return add_stimulus(old_index, stimulus);
    std::vector<json> made = stimuli_at(levels, stimulus, *stated);
    if (made.empty()) return add_stimulus(old_index, stimulus);
    for (std::size_t i = 0; i < made.size(); ++i) {
      add_stimulus(old_index, std::move(made[i]));
      const std::string place = level_place(member_path(levels, "values"), stated->values, i);
      set_place(stated->of, member_path(levels, "of"), place);
      set_place("factors." + stated->factor, member_path(levels, "factor"), place);
    }
  }

  std::string new_path() const { return element_path("stimuli", stimuli_.size() - 1); }

  void add_stimulus(std::size_t old_index, json stimulus) {
    stimuli_.push_back(std::move(stimulus));
    result_.origins.push_back(old_index);
    const std::string old_path = element_path("stimuli", old_index);
    copy_places(old_.places.values, old_path, new_path(), places_.values);
    copy_places(old_.places.keys, old_path, new_path(), places_.keys);
  }

  /// A value of the stimulus added last stands where its level is stated, its key where the path
  /// or the factor is.
  void set_place(const std::string& path, const std::string& key_at, const std::string& value_at) {
    places_.keys[member_path(new_path(), path)] = place_of(old_.places, key_at);
    places_.values[member_path(new_path(), path)] = place_of(old_.places, value_at);
  }

  JsonReading old_;
  LevelledDocument result_;
  json stimuli_ = json::array();
  Places places_;
};

}  // namespace

std::vector<double> level_values(const json& values) {
  std::vector<double> levels;
  if (values.is_array()) {
    for (const json& value : values) levels.push_back(value.get<double>());
  } else {
    const bool is_whole = values.value("whole", json(false)) == true;
    levels = range_values(values["from"], values["to"], values["steps"],
                          values.value("spacing", json("linear")) == "log", is_whole);
  }
  std::vector<double> sorted = levels;
  std::ranges::sort(sorted);
  if (const auto same = std::ranges::adjacent_find(sorted); same != sorted.end())
    throw Error(fmt::format("the level {} occurs twice", shortest(*same)),
                values.is_array() ? "name it once" : "use fewer steps");
  return levels;
}

std::vector<Fault> with_written_paths(std::vector<Fault> faults,
                                      const std::vector<std::size_t>& origins) {
  if (origins.empty()) return faults;
  constexpr std::string_view stimuli = "stimuli[";
  std::set<std::tuple<std::string, int, int>> reported;
  const auto is_repeated = [&](Fault& fault) {
    if (!fault.path.starts_with(stimuli)) return false;
    const std::size_t made = std::strtoul(fault.path.c_str() + stimuli.size(), nullptr, 10);
    if (made >= origins.size()) return false;
    const std::string part = fault.path.substr(fault.path.find(']') + 1);
    fault.path = element_path("stimuli", origins[made]) + part;
    return !reported.emplace(fault.path, fault.place.line, fault.place.column).second;
  };
  std::erase_if(faults, is_repeated);
  return in_reading_order(std::move(faults));
}

LevelledDocument with_all_levels(JsonReading reading) {
  const json* stimuli = member(reading.document, "stimuli");
  const auto has_levels = [](const json& stimulus) { return stated_levels(stimulus).has_value(); };
  if (stimuli == nullptr || !stimuli->is_array() || std::ranges::none_of(*stimuli, has_levels))
    return {std::move(reading), {}, {}};
  return Levelling(std::move(reading)).levelled();
}

}  // namespace mien::pipeline
