#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mien::pipeline {

/// Mean ratings of films on one scale. All members have one entry or row per film.
struct RatedFilms {
  std::string scale;       ///< id
  Eigen::MatrixXd places;  ///< parameters of the films
  Eigen::VectorXd mean;    ///< in points of the scale
  Eigen::VectorXi answers;
  double answer_variance = 0.0;  ///< of one answer about the mean of its film, in points²
  std::vector<std::string> ids;  ///< of the stimuli
  std::vector<int> rounds;       ///< in which the films were rated, from 1
};

/// A film that can be made: weights of the examples (≥ 0, sum 1) and the parameters of the blend.
struct FilmCandidate {
  Eigen::VectorXd weights;
  Eigen::RowVectorXd place;
};

/// The examples by themselves, in their order, then distinct random blends of two or three of them
/// (of two, if there are two), whose weights are uniform on the simplex and rounded to 0.01, until
/// there are `count` candidates. The place of a blend is the weighted mean of the examples' places
/// (one row each), so that no candidate is beyond what the examples allow. With `blends` false,
/// the examples alone. A pure function of its arguments.
std::vector<FilmCandidate> film_candidates(const Eigen::MatrixXd& examples, std::size_t count,
                                           bool blends, std::uint64_t seed);

/// What the next films are for.
struct FilmAim {
  /// Empty: films after which ratings are known best everywhere. Otherwise films that are likely to
  /// be rated highest (or lowest) on this scale.
  std::string scale;
  bool highest = true;
};

struct NextOptions {
  std::size_t films = 12;
  FilmAim aim;
  int answers = 12;  ///< expected number of answers to each film
  /// Least difference from films that are rated or chosen: root mean square over the parameters, in
  /// standard deviations of the candidates. Greater than 0.
  double apart = 0.3;
  /// Which candidates can be chosen; empty: all. What is learned counts at all of them, so that
  /// films of which nobody is asked, such as those of a later test of predictions, matter, too.
  std::vector<bool> available = {};
  /// Parameters of films that are planned but not rated yet, one row each: neither they nor films
  /// that are not `apart` from them are chosen.
  Eigen::MatrixXd planned = {};
};

/// A film to rate next, with what its ratings are expected to be before it is rated.
struct NextFilm {
  std::size_t candidate = 0;
  std::vector<double> mean, deviation;  ///< by scale; deviation: standard deviation of the estimate
  /// Of the aim: share of what is unknown that the film's ratings would remove (mean over scales),
  /// or the expected improvement over the best so far, in points.
  double gain = 0.0;
};

/// Expected mean ratings of all candidates on one scale, before the next films are rated.
struct ScaleKnowledge {
  Eigen::VectorXd mean, deviation;
};

struct NextFilms {
  std::vector<NextFilm> films;  ///< in the order in which they are chosen
  /// By scale (none where nothing is rated): root mean square, over all candidates, of the standard
  /// deviation of the expected rating, now and, as expected, once the films are rated; in points.
  std::vector<double> known_now, known_then;
  std::vector<ScaleKnowledge> known;  ///< by scale
};

/// Chooses films to rate next. On each scale, ratings are a Gaussian process of the parameters
/// (gaussian_process.h), which are standardised over the candidates.
///
/// To learn, films are chosen one after the other, each the one whose answers would lower the
/// variance of the expected ratings most, summed over all candidates (Cohn 1996, active learning)
/// and, as shares of the scale's present sum, over the scales. For the highest or lowest ratings,
/// each film has the greatest expected improvement (Jones, Schonlau and Welch 1998) over the best
/// expected rating of the films rated or chosen so far. After each choice its answers are taken to
/// be as expected (Ginsbourger et al. 2010, kriging believer), and films that are not
/// `apart` from it are left out, as are those that are not from a film that is rated on every
/// scale. Of equal candidates the first is chosen.
///
/// Without any rated scale, the first films are chosen to learn, by their parameters alone: on a
/// scale of which nothing is known but what is usual (usual_parameters) where the mean of all
/// ratings is as uncertain as films differ, and answers to one film have twice the variance of the
/// films' means (our choice). `gain` then refers to this scale, and there are no means.
///
/// Throws Error if fewer than three films are rated on a scale, if no available candidate is apart
/// from the rated films, or if the scale of the aim has no ratings.
NextFilms next_films(const std::vector<FilmCandidate>& candidates,
                     const std::vector<RatedFilms>& rated, const NextOptions& options);

}  // namespace mien::pipeline
