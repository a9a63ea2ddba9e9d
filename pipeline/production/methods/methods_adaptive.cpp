#include <fmt/format.h>

#include "pipeline/manifest/adaptive_plan.h"
#include "pipeline/production/methods/methods_parts.h"

namespace mien::pipeline {

namespace {

/// "strength of sad from 0 to 1.5", "head-flexion from -10° to 30°", "paths from 0.5 to 1.5"
std::vector<std::string> limits_texts(const RecipeSpace& recipe) {
  std::vector<std::string> texts;
  for (const auto& [name, limits] : dimensions_of(recipe)) {
    const std::size_t index = texts.size();
    const bool is_strength = index < recipe.emotions.size();
    const bool is_rotation = !is_strength && index < recipe.emotions.size() + recipe.posture.size();
    const char* unit = is_rotation ? "°" : "";
    texts.push_back(fmt::format("{}{} from {:g}{} to {:g}{}", is_strength ? "strength of " : "",
                                name, limits[0], unit, limits[1], unit));
  }
  return texts;
}

std::string starts_text(MotionSpace::Kind kind) {
  if (kind == MotionSpace::Kind::weights)
    return "Chains started at random points of the ranges, 0.01 to 1";
  if (kind == MotionSpace::Kind::recipe) return "Chains started at random points of the ranges";
  return "The ranges were those of the examples, and chains started at random blends of three "
         "examples";
}

std::string dimensions_text(const Manifest& manifest) {
  const MotionSpace& space = manifest.adaptive->space;
  const std::vector<std::string> names = dimension_names(manifest);
  switch (space.kind) {
    case MotionSpace::Kind::groups:
      return "groups of rated adjective pairs (" + listed(names) + ")";
    case MotionSpace::Kind::scales:
      return "rated adjective pairs (" + listed(names) + ")";
    case MotionSpace::Kind::features:
      return "motion features (" + listed(names) + ")";
    case MotionSpace::Kind::weights:
      return "relative weights of the examples (" + listed(names) + ")";
    case MotionSpace::Kind::recipe:
      return "modifications of the example " + space.recipe.of + " (" +
             listed(limits_texts(space.recipe)) + ")";
    case MotionSpace::Kind::components:
      break;
  }
  return fmt::format("the first {} of the examples' standardised motion features",
                     space.components == 1
                         ? "principal component"
                         : fmt::format("{} principal components", space.components));
}

void describe_until(MethodsText& out, const ChainEnd& end, const char* what) {
  out.say(fmt::format(
      "The chains of a word ended once the potential scale reduction factor{} of their second "
      "halves was at most {:g} in every dimension, but not before {} {}, and at the latest after "
      "{}",
      out.cite({"gelman1992"}), end.r_hat, end.at_least, what, end.at_most));
}

void describe_gibbs(MethodsText& out, const Adaptive& adaptive) {
  out.say(fmt::format(
      "Motions were led towards words by Gibbs sampling with people{}: in each trial, one "
      "dimension "
      "of a chain's point was free, and participants set it with a slider without labels, whose "
      "start and direction were random, to what looked most like the word, while the motion "
      "followed",
      out.cite({"harrison2020"})));
  if (adaptive.until) {
    out.say("Each sweep freed every dimension once, in random order");
    return describe_until(out, *adaptive.until, "sweeps");
  }
  out.say(fmt::format(
      "Each sweep freed every dimension once, in random order, and a chain had {}",
      adaptive.iterations == 1 ? "one sweep" : fmt::format("{} sweeps", adaptive.iterations)));
}

void describe_mcmc(MethodsText& out, const Adaptive& adaptive) {
  out.say(fmt::format(
      "Motions were led towards words by Markov chain Monte Carlo with people{}: in each trial, "
      "participants chose which of two motions looked more like the word, that of a chain's point "
      "or "
      "a proposal near it, drawn from a normal distribution with a standard deviation of {:g} % of "
      "the range of each dimension and reflected at its ends",
      out.cite({"sanborn2008"}), 100.0 * adaptive.deviation));
  if (adaptive.until) return describe_until(out, *adaptive.until, "choices");
  out.say(fmt::format("A chain had {} choices", adaptive.iterations));
}

void describe_chains(MethodsText& out, const Adaptive& adaptive) {
  const std::string chains =
      adaptive.chains == 1 ? "one chain" : fmt::format("{} chains", adaptive.chains);
  const std::string were =
      adaptive.chains == 1 ? "was one chain" : fmt::format("were {} chains", adaptive.chains);
  if (!adaptive.across_participants) {
    out.say(fmt::format("Each participant had {} for every word", chains));
  } else if (adaptive.people_per_step == 1) {
    out.say(fmt::format(
        "For every word there {}, whose steps were answered by the participants in turn", were));
  } else {
    out.say(fmt::format(
        "For every word there {}; each step was answered by {} participants, and the {} of their "
        "answers was the next value",
        were, adaptive.people_per_step, word_of(step_aggregate_words, adaptive.aggregate)));
  }
}

}  // namespace

void describe_adaptive(MethodsText& out) {
  if (!out.manifest.adaptive) return;
  const Adaptive& adaptive = *out.manifest.adaptive;
  adaptive.method == ChainMethod::gibbs ? describe_gibbs(out, adaptive)
                                        : describe_mcmc(out, adaptive);
  std::vector<std::string> words;
  for (const auto& [id, shown] : adaptive.words) words.push_back("\"" + shown.text + "\"");
  out.say(fmt::format("The {} {}, the dimensions {}", words.size() == 1 ? "word was" : "words were",
                      listed(words), dimensions_text(out.manifest)));
  describe_chains(out, adaptive);
  out.say(starts_text(adaptive.space.kind));
  const std::size_t trials = adaptive.across_participants
                                 ? static_cast<std::size_t>(adaptive.trials_per_participant)
                                 : adaptive.words.size() *
                                       static_cast<std::size_t>(adaptive.chains) *
                                       static_cast<std::size_t>(chain_steps(out.manifest));
  out.say(fmt::format("The planned number of participants was {}, with {}{} each",
                      adaptive.participants, adaptive.across_participants ? "up to " : "",
                      count_of(trials, "trial", "trials")));
  if (adaptive.language.offered.size() > 1)
    out.say(fmt::format("The pages were in {} languages ({}), as the browser preferred",
                        adaptive.language.offered.size(), listed(adaptive.language.offered)));
  if (adaptive.practice > 0)
    out.say(fmt::format("{} practice {} came first", adaptive.practice,
                        adaptive.practice == 1 ? "trial" : "trials"));
  if (adaptive.attention_every > 0)
    out.say(fmt::format(
        "About every {} trials, an attention check asked participants to {}; {} who failed more "
        "than {}",
        adaptive.attention_every,
        adaptive.method == ChainMethod::gibbs ? "move the slider to one end"
                                              : "choose a certain figure",
        adaptive.across_participants ? "others took the place of those"
                                     : "the analysis leaves out those",
        count_of(static_cast<std::size_t>(adaptive.max_failed_checks), "check", "checks")));
}

}  // namespace mien::pipeline
