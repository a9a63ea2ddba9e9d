#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "motion/error.h"
#include "motion/modify/posture.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/adaptive_plan.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/reading/recipes.h"

namespace mien::pipeline {

namespace {

using Kind = MotionSpace::Kind;
using Names = std::vector<std::string>;

/// Bounds of the work that an experiment asks of one participant and of all.
constexpr double max_trials = 2000;
constexpr double max_steps = 1e6;

/// Checks an adaptive experiment against the rest of its manifest.
class AdaptiveExperimentCheck {
 public:
  explicit AdaptiveExperimentCheck(const Manifest& manifest)
      : manifest_(manifest), adaptive_(*manifest.adaptive), list_(manifest.places) {}

  std::vector<Fault> faults() {
    if (manifest_.questionnaire || manifest_.matching)
      list_.add("adaptive",
                manifest_.questionnaire ? "there is also a questionnaire"
                                        : "there is also a matching experiment",
                "a manifest has one of them; use separate manifests");
    check_kinds();
    check_words();
    check_examples();
    check_dimensions();
    check_settings();
    check_until();
    check_attention();
    if (dimension_count(manifest_) > 0) check_length();
    check_demographics();
    return list_.take();
  }

 private:
  static std::string at(const char* key) { return member_path("adaptive", key); }

  void check_kinds() {
    std::vector<std::string> given;
    for (const auto& [word, kind] : space_words)
      if (manifest_.places.values.contains(member_path(at("space"), std::string(word))))
        given.emplace_back(word);
    if (given.size() == 1) return;
    list_.add(at("space"),
              given.empty()
                  ? "no dimensions"
                  : fmt::format("dimensions of several kinds: {}", fmt::join(given, ", ")),
              "name one of groups, scales, features, weights, components and recipe");
  }

  void check_words() {
    std::set<std::string> taken;
    for (const auto& [id, shown] : adaptive_.words) {
      std::string lower = id;
      for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      if (!taken.insert(lower).second)
        list_.add(at("words"), fmt::format("{} appears twice", id),
                  "name it once; ids that differ in capitals alone count as the same");
      if (id == "practice" || id == "check")
        list_.add(at("words"), fmt::format("{} is the name of other trials", id),
                  "use another id: {id: word}");
    }
  }

  void check_examples() {
    if (!manifest_.places.values.contains("examples"))
      return list_.add("adaptive", "there are no examples of which motions could be made",
                       "add examples: {set: builtin:walks-10, ratings: builtin}, or your own");
    const bool needs_ratings =
        adaptive_.space.kind == Kind::groups || adaptive_.space.kind == Kind::scales;
    if (needs_ratings && manifest_.ratings.source == Ratings::Source::none)
      list_.add(at("space"), "the examples have no ratings",
                "add ratings to the examples, or use features, weights or components");
  }

  void check_dimensions() {
    const MotionSpace& space = adaptive_.space;
    if (space.kind == Kind::recipe) return check_recipe(space.recipe);
    const std::string key(word_of(space_words, space.kind));
    const std::string path = member_path(at("space"), key);
    const std::vector<std::string> known = known_dimensions(manifest_, space.kind);
    if (space.kind == Kind::groups && known.empty())
      list_.add(path, "the study's scales have no groups", "name scales: {scales: […]}");
    std::set<std::string> taken;
    for (std::size_t i = 0; i < space.names.size(); ++i)
      if (!taken.insert(space.names[i]).second)
        list_.add(element_path(path, i), space.names[i] + " appears twice", "name it once");
    // Examples of a missing folder are not known.
    if (!known.empty())
      for (std::size_t i = 0; i < space.names.size(); ++i)
        list_.check_known_name(element_path(path, i), space.names[i], noun_of(space.kind), known);
    if (space.kind == Kind::weights && space.names.size() == 1)
      list_.add(path, "the weight of a single example changes nothing",
                "name two examples or more");
  }

  void check_recipe(const RecipeSpace& recipe) {
    const std::string path = member_path(at("space"), "recipe");
    const Names examples = known_dimensions(manifest_, Kind::weights);
    if (!examples.empty())
      list_.check_known_name(member_path(path, "of"), recipe.of, "example", examples);
    for (const auto& [name, limits] : recipe.posture)
      if (!motion::posture_unit(name))
        list_.add_at_key(member_path(member_path(path, "posture"), name),
                         "unknown rotation " + motion::in_quotes(name),
                         motion::did_you_mean(name, rotation_names()));
    if (dimensions_of(recipe).empty())
      list_.add(path, "no dimensions", "name emotions, posture, paths, acceleration or tempo");
    check_emotions(recipe, member_path(path, "emotions"));
    std::set<std::string> taken;
    for (const auto& [name, limits] : dimensions_of(recipe)) {
      if (limits[0] >= limits[1])
        list_.add(place_of_dimension(recipe, path, name), "the limits do not ascend",
                  "give the least value first, then the greatest");
      if (!taken.insert(name).second)
        list_.add(path, fmt::format("two dimensions are named {}", name),
                  "give the recipe another name");
    }
  }

  /// Poses of recipes need files, which pages for participants do not have.
  void check_emotions(const RecipeSpace& recipe, const std::string& path) {
    if (recipe.emotions.empty()) return;
    RecipeBook book;
    try {
      book = read_recipes(manifest_.recipes.name, manifest_.recipes.file);
    } catch (const Error&) {
      return;  // reported where the stimuli's modifications are resolved
    }
    for (const auto& [name, limits] : recipe.emotions) {
      const Recipe* found = book.find(name);
      if (found == nullptr)
        list_.add_at_key(member_path(path, name),
                         "there is no recipe for " + motion::in_quotes(name),
                         motion::did_you_mean(name, book.names()));
      else if (found->edit.pose)
        list_.add_at_key(member_path(path, name), "its recipe contains a pose",
                         "use a recipe without a pose");
    }
  }

  static Names rotation_names() {
    Names names;
    for (const motion::PostureUnitName& unit : motion::posture_units())
      names.emplace_back(unit.name);
    return names;
  }

  static std::string place_of_dimension(const RecipeSpace& recipe, const std::string& path,
                                        const std::string& name) {
    for (const auto& [key, limits] :
         {std::pair("emotions", &recipe.emotions), std::pair("posture", &recipe.posture)})
      if (std::ranges::find(*limits, name, &NamedLimits::value_type::first) != limits->end())
        return member_path(member_path(path, key), name);
    return member_path(path, name);
  }

  static const char* noun_of(Kind kind) {
    if (kind == Kind::groups) return "group";
    if (kind == Kind::scales) return "scale";
    return kind == Kind::features ? "feature" : "example";
  }

  /// What is given although it has no effect.
  void refuse_unused(const char* key, bool is_used, const char* wrong, const char* remedy) {
    if (!is_used && manifest_.places.values.contains(at(key))) list_.add(at(key), wrong, remedy);
  }

  void check_settings() {
    const bool is_across = adaptive_.across_participants;
    const bool is_gibbs = adaptive_.method == ChainMethod::gibbs;
    constexpr char own_chains[] = "has no effect, because each participant has chains of their own";
    constexpr char go_across[] = "add across_participants: true, or remove it";
    refuse_unused("trials_per_participant", is_across, own_chains, go_across);
    refuse_unused("answer_within_s", is_across, own_chains, go_across);
    refuse_unused("people_per_step", is_across, own_chains, go_across);
    refuse_unused("deviation", !is_gibbs, "has no effect in Gibbs sampling", "remove it");
    refuse_unused("aggregate", adaptive_.people_per_step > 1,
                  "has no effect, because one person answers each step",
                  "add people_per_step, or remove it");
    if (!is_gibbs && adaptive_.people_per_step > 1)
      list_.add(at("people_per_step"), "choices of several people cannot be combined",
                "remove it, or use method: gibbs");
    if (adaptive_.people_per_step > 1 && adaptive_.people_per_step > adaptive_.participants)
      list_.add(at("people_per_step"), "is more than the number of participants",
                "plan for more participants, or for fewer people per step");
  }

  void check_until() {
    if (!adaptive_.until) return;
    if (manifest_.places.values.contains(at("iterations")))
      list_.add(at("iterations"), "the length of the chains is stated in `until` as well",
                "remove one of them");
    if (!adaptive_.across_participants)
      list_.add(at("until"), "needs chains that a server follows",
                "add across_participants: true, or use iterations");
    if (adaptive_.chains < 2)
      list_.add(at("until"), "R̂ compares the chains of a word, and there is one",
                "use two chains or more, or iterations");
    if (adaptive_.until->at_least > adaptive_.until->at_most)
      list_.add(member_path(at("until"), "at_most"),
                fmt::format("is less than at_least, {}", adaptive_.until->at_least),
                "use a greater number");
  }

  void check_attention() {
    if (adaptive_.attention_every == 0 &&
        manifest_.places.values.contains(member_path(at("attention"), "max_failed_checks")))
      list_.add(member_path(at("attention"), "max_failed_checks"),
                "has no effect without attention checks", "add every, or remove it");
  }

  void check_length() {
    const double steps = chain_steps(manifest_);
    const double chains = static_cast<double>(adaptive_.words.size()) * adaptive_.chains;
    if (!adaptive_.across_participants && steps * chains > max_trials)
      list_.add(
          at(length_key()),
          fmt::format("each participant would have {:.0f} trials; at most {:.0f} are possible",
                      steps * chains, max_trials),
          "use fewer iterations, chains or words, or across_participants: true");
    const double people =
        adaptive_.across_participants ? adaptive_.people_per_step : adaptive_.participants;
    const double answers = steps * chains * people;
    if (answers > max_steps)
      list_.add(
          at(length_key()),
          fmt::format("{:.0f} answers are needed; at most {:.0f} are possible", answers, max_steps),
          "use fewer iterations, chains, words or people");
  }

  const char* length_key() const { return adaptive_.until ? "until" : "iterations"; }

  void check_demographics() {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < adaptive_.demographics.size(); ++i)
      check_question_id(member_path(element_path(at("demographics"), i), "id"),
                        adaptive_.demographics[i].id, taken, list_);
  }

  const Manifest& manifest_;
  const Adaptive& adaptive_;
  FaultList list_;
};

}  // namespace

std::vector<Fault> check_adaptive(const Manifest& manifest) {
  return manifest.adaptive ? AdaptiveExperimentCheck(manifest).faults() : std::vector<Fault>();
}

}  // namespace mien::pipeline
