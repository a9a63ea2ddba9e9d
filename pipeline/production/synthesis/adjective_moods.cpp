#include "pipeline/production/synthesis/adjective_moods.h"

#include <optional>

#include "motion/interpolation/interpolation.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/production/synthesis/slider_interface.h"
#include "pipeline/production/synthesis/wish.h"

namespace mien::pipeline {

namespace {

/// The built-in walks of a set with what is rated of them; read when it is first needed.
class RatedWalks {
 public:
  explicit RatedWalks(const std::string& set) : set_(set.substr(set.find(':') + 1)) {}

  Mood shares_of(const Mood& adjectives) {
    Stimulus stimulus = plain_stimulus(manifest_);
    stimulus.adjectives = adjectives;
    const Wish wish = wish_of(stimulus, repertoire());
    const FittedInterface fitted =
        fit_interface(wish.sliders, manifest_.interpolation, repertoire(), wish.held);
    const Eigen::VectorXd weights = motion::weights_at(fitted.interpolator, wish.settings).weights;
    Mood mood;
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      if (weights(i) > 0.0)
        mood.emplace_back(repertoire().names[static_cast<std::size_t>(i)].name, weights(i));
    }
    return mood;
  }

 private:
  const Repertoire& repertoire() {
    if (!repertoire_) {
      manifest_.examples.builtin = set_;
      manifest_.ratings.source = Ratings::Source::builtin;
      repertoire_ = load_repertoire(manifest_);
    }
    return *repertoire_;
  }

  std::string set_;
  Manifest manifest_;
  std::optional<Repertoire> repertoire_;
};

}  // namespace

WalkPath in_walks(WalkPath path) {
  RatedWalks rated(path.set);
  const auto turn = [&](Mood& mood) {
    if (is_of_adjectives(path, mood)) mood = rated.shares_of(mood);
  };
  turn(path.mood);
  for (WalkStep& step : path.script) turn(step.mood);
  for (MoodChange& change : path.moods) turn(change.mood);
  return path;
}

}  // namespace mien::pipeline
