#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/study/adaptive/next_films.h"

namespace mien::pipeline {

/// The parameters that distinguish films, and their values at the examples.
struct FilmSpace {
  std::vector<std::string> parameters;
  std::vector<std::string> examples;  ///< names
  Eigen::MatrixXd places;             ///< one row per example
};

/// The space of these motion features, or, if none are named, of their four groups. Throws Error
/// for a feature that the examples do not have.
FilmSpace film_space(const Repertoire& repertoire, std::vector<std::string> features = {});

/// The rated films of a study.
struct RatedStudy {
  std::vector<RatedFilms> scales;     ///< those with answers, in the order of `asked`
  std::vector<std::string> left_out;  ///< sentences on answers that are not used
  bool simulated = false;
  int answers_per_film = 1;  ///< median, at least 1
};

/// Averages the answers about the stimuli that are unmodified blends of the examples, on the scales
/// `asked`. Answers about other stimuli are omitted and listed in `left_out`. The variance of an
/// answer is pooled within films; it is 0 if all values are means. Throws Error if no answer
/// remains.
RatedStudy rated_study(const Manifest& manifest, const Repertoire& repertoire,
                       const FilmSpace& space, const std::vector<Answers>& rounds,
                       const std::vector<std::string>& asked);

/// Places of the films of earlier rounds ("round2-01") about which there are no answers, one row
/// each.
Eigen::MatrixXd unanswered_rounds(const Manifest& manifest, const Repertoire& repertoire,
                                  const FilmSpace& space, const std::vector<Answers>& rounds);

/// The manifest of the next round: that of the study so far, with the films as further stimuli,
/// "round2-01", "round2-02" …, and with a questionnaire about these alone. They are numbered by the
/// first round, from `from` on, whose names are free. `name`: of the study.
Manifest next_round(const Manifest& manifest, const FilmSpace& space,
                    const std::vector<FilmCandidate>& candidates, const NextFilms& next,
                    const std::string& name, int from = 2);

/// "walks-1" for "walks": a study's name in its first round. A name that is numbered is counted on,
/// as by name_of_next_round.
std::string name_of_first_round(const std::string& study);

/// "closed-loop-3" after "closed-loop-2", and "walks-2" after "walks".
std::string name_of_next_round(const std::string& study);

}  // namespace mien::pipeline
