#include "pipeline/manifest/reading/recipes.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pipeline/commands/line/installed_manifests.h"
#include "pipeline/commands/line/production_options.h"
#include "pipeline/commands/study/study.h"
#include "pipeline/study/recipes/recipe_table.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct RecipesOptions {
  std::vector<std::string> manifests;
  std::string recipes;
  std::string out;
};

void use_recipes(const std::string& source, Manifest& manifest) {
  if (source.empty()) return;
  manifest.recipes.name = source;
  manifest.recipes.file = builtin_recipes_text(source).empty() ? fs::absolute(source) : fs::path();
}

void show(const std::vector<RecipeResult>& results, const Console& console) {
  console.out << fmt::format("{:15} {:24} {:30} {:>5} {:>5} {:>5} {:>7} {:>7} {:>7}  {}\n",
                             "emotion", "neutral", "acted", "right", "wrong", "of", "right %",
                             "D before", "D after", "new errors");
  for (const RecipeResult& r : results) {
    if (!r.is_compared() && r.errors.empty()) continue;
    const std::string errors = fmt::format("{}", fmt::join(r.errors, ", "));
    if (!r.is_compared()) {
      console.out << fmt::format("{:15} {:24} {:74}  {}\n", r.emotion, r.neutral, "–", errors);
      continue;
    }
    console.out << fmt::format("{:15} {:24} {:30} {:5} {:5} {:5} {:7.0f} {:8.3f} {:7.3f}  {}{}\n",
                               r.emotion, r.neutral, r.acted, r.right, r.wrong, r.changed,
                               100.0 * r.share_right(), *r.neutral_distance_m,
                               *r.modified_distance_m, r.is_nearer() ? "" : "farther ", errors);
  }
}

void show(const std::vector<EmotionSummary>& summaries, const Console& console) {
  console.out << fmt::format("\n{:15} {:>8} {:>8} {:>12} {:>7} {:>12} {:>8}\n", "emotion",
                             "right %", "wrong %", ">= 75 % right", "nearer", "acted versions",
                             "faulty");
  for (const EmotionSummary& s : summaries) {
    const auto percent = [&](int count) {
      return s.changed == 0 ? std::string("–") : fmt::format("{:.0f}", 100.0 * count / s.changed);
    };
    console.out << fmt::format("{:15} {:>8} {:>8} {:13} {:7} {:14} {:>8}\n", s.emotion,
                               percent(s.right), percent(s.wrong), s.mostly_right, s.nearer,
                               s.comparisons, fmt::format("{}/{}", s.faulty, s.motions));
  }
}

int compare(const RecipesOptions& options, const Console& console) {
  std::vector<RecipeResult> results;
  for (const std::string& name : options.manifests) {
    Manifest manifest = load_with_warnings(resolve_manifest(name, console), {}, console);
    use_recipes(options.recipes, manifest);
    for (RecipeResult& result : recipe_results(manifest)) results.push_back(std::move(result));
  }
  const std::vector<EmotionSummary> summaries = emotion_summaries(results);
  show(results, console);
  show(summaries, console);
  if (options.out.empty()) return exit_done;
  const std::vector<WrittenTable> tables = {recipe_results_table(results),
                                            emotion_summaries_table(summaries)};
  write_tables(options.out, tables);
  for (const WrittenTable& table : tables)
    console.out << '\n' << (fs::path(options.out) / table.form.path).string();
  console.out << '\n';
  return exit_done;
}

}  // namespace

Command study_recipes_command() {
  const auto options = std::make_shared<RecipesOptions>();
  return {
      .name = "recipes",
      .summary = "Compare the recipes of emotions with acted emotions",
      .options = all_of(
          argument("manifests", &options->manifests,
                   "Manifests with neutral motions (role: reference) and acted versions of them "
                   "(factors: {neutral: ID, emotion: NAME})"),
          option(
              "--recipes", &options->recipes,
              "builtin, builtin@0.2 or builtin@0.3 (those of mien 0.2 or 0.3), fig29, or a file of "
              "recipes (default: those of each manifest)"),
          option("-o,--output", &options->out,
                 "Folder for recipe-results.csv and recipe-summary.csv")),
      .notes =
          "Every recipe is applied to every neutral motion. right: motion features that the actor "
          "changed measurably and the recipe changes in the same direction; wrong: in the opposite "
          "direction; D: distance from the acted motion, in metres, before and after the change; "
          "new errors: of the lint, which the neutral motion lacks. Motions without an acted "
          "version are listed only if they have new errors. Nothing is rendered.\n\n"
          "Examples:\n"
          "  mien study recipes real-emotions real-styles real-gestures acted-emotions\n"
          "  mien study recipes real-emotions --recipes my.recipes.yaml -o results",
      .run = [options](const Console& console) { return compare(*options, console); }};
}

}  // namespace mien::pipeline
