#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/study/adaptive/film_space.h"
#include "pipeline/study/questionnaire/orders.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// The real ratings of 30 captured walks on five scales.
struct RealRatings {
  Eigen::MatrixXd places;          ///< features, one row per walk
  std::vector<RatedFilms> scales;  ///< of all walks
};

RealRatings real_ratings(const fs::path& data) {
  const Manifest manifest = load_manifest(
      fs::path(MIEN_SOURCE_DIR) / "manifests/real-walks.yaml", [&](const std::string& name) {
        return name == "MIEN_DATA" ? std::optional(data.string()) : std::nullopt;
      });
  const Repertoire repertoire = load_repertoire(manifest);
  const FilmSpace space = film_space(repertoire);
  const CsvTable table = read_csv(data / "mocap/bandai-namco-1/ratings.csv");
  std::map<std::string, std::map<std::string, std::vector<double>>> values;  // scale, walk
  const int stimulus = require_column(table, "stimulus"), scale = require_column(table, "scale"),
            value = require_column(table, "value");
  for (const auto& row : table.rows) {
    std::string name = row[static_cast<std::size_t>(stimulus)].text;
    constexpr std::string_view prefix = "dataset-1_walk_";
    if (!name.starts_with(prefix)) continue;
    values[row[static_cast<std::size_t>(scale)].text][name.substr(prefix.size())].push_back(
        number_in(table, row[static_cast<std::size_t>(value)]));
  }
  RealRatings real{.places = space.places};
  const auto walks = static_cast<Eigen::Index>(space.examples.size());
  for (const auto& [id, by_walk] : values) {
    RatedFilms films{.scale = id,
                     .places = space.places,
                     .mean = Eigen::VectorXd(walks),
                     .answers = Eigen::VectorXi(walks)};
    double squares = 0.0;
    int freedom = 0;
    for (Eigen::Index w = 0; w < walks; ++w) {
      const std::vector<double>& of = by_walk.at(space.examples[static_cast<std::size_t>(w)]);
      films.mean[w] = std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
      films.answers[w] = static_cast<int>(of.size());
      for (const double one : of) squares += std::pow(one - films.mean[w], 2);
      freedom += static_cast<int>(of.size()) - 1;
    }
    films.answer_variance = squares / freedom;
    real.scales.push_back(films);
  }
  return real;
}

std::vector<RatedFilms> rated_among(const RealRatings& real,
                                    const std::vector<std::size_t>& walks) {
  std::vector<RatedFilms> rated;
  for (const RatedFilms& all : real.scales) {
    RatedFilms some{.scale = all.scale, .answer_variance = all.answer_variance};
    const auto count = static_cast<Eigen::Index>(walks.size());
    some.places.resize(count, all.places.cols());
    some.mean.resize(count);
    some.answers.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto walk = static_cast<Eigen::Index>(walks[static_cast<std::size_t>(i)]);
      some.places.row(i) = all.places.row(walk);
      some.mean[i] = all.mean[walk];
      some.answers[i] = all.answers[walk];
    }
    rated.push_back(some);
  }
  return rated;
}

/// The error of the expected ratings of walks that are not rated, root mean square over walks and
/// scales in standard deviations of the mean ratings.
double error_at(const RealRatings& real, const std::vector<FilmCandidate>& all,
                const std::vector<std::size_t>& rated, const std::vector<std::size_t>& left_out) {
  const NextFilms known = next_films(all, rated_among(real, rated), {.films = 1, .apart = 1e-6});
  double squares = 0.0;
  for (std::size_t s = 0; s < real.scales.size(); ++s) {
    const Eigen::VectorXd& mean = real.scales[s].mean;
    const double variance = (mean.array() - mean.mean()).square().mean();
    for (const std::size_t walk : left_out) {
      const auto w = static_cast<Eigen::Index>(walk);
      squares += std::pow(known.known[s].mean[w] - mean[w], 2) / variance;
    }
  }
  return std::sqrt(squares / static_cast<double>(real.scales.size() * left_out.size()));
}

/// The walks that are chosen next among these, to learn about all; where none is rated, the first.
std::vector<std::size_t> chosen_among(const std::vector<FilmCandidate>& all,
                                      const std::vector<RatedFilms>& rated,
                                      const std::vector<std::size_t>& possible, std::size_t count) {
  NextOptions options{.films = count, .apart = 1e-6};
  options.available.resize(all.size());
  for (const std::size_t walk : possible) options.available[walk] = true;
  std::vector<std::size_t> chosen;
  for (const NextFilm& film : next_films(all, rated, options).films)
    chosen.push_back(film.candidate);
  return chosen;
}

/// The number of walks, from 4, after which the error is at most `aim`, linear between numbers.
double needed(const std::vector<double>& errors, double aim) {
  const auto found = std::ranges::find_if(errors, [&](double error) { return error <= aim; });
  const auto above = static_cast<double>(found - errors.begin());
  if (found == errors.begin() || found == errors.end()) return 4.0 + above;
  return 3.0 + above + (*(found - 1) - aim) / (*(found - 1) - *found);
}

// Ten of thirty walks are left out, and walks are rated one by one among the other twenty. The
// features of all thirty are known. The first four walks are chosen before any is rated.
TEST(RealRatings, OfWalksThatAreLeftOutAreFoundWithFewerThanRandomOnes) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "no real motion capture: name it with MIEN_DATA";
  const RealRatings real = real_ratings(*data);
  ASSERT_EQ(real.scales.size(), 5u);
  const std::vector<FilmCandidate> all = film_candidates(real.places, 30, false, 1);
  ASSERT_EQ(all.size(), 30u);
  constexpr int orders = 60;
  constexpr std::size_t most = 18;
  std::vector<double> chosen_error(most - 3), random_error(most - 3);
  for (int order = 0; order < orders; ++order) {
    const std::vector<std::size_t> walks =
        random_order(30, static_cast<std::uint64_t>(order), "real walks");
    const std::vector<std::size_t> left_out(walks.begin(), walks.begin() + 10);
    const std::vector<std::size_t> possible(walks.begin() + 10, walks.end());
    std::vector<std::size_t> chosen = chosen_among(all, {}, possible, 4);
    std::vector<std::size_t> drawn(possible.begin(), possible.begin() + 4);
    for (std::size_t count = 4; count <= most; ++count) {
      chosen_error[count - 4] += error_at(real, all, chosen, left_out) / orders;
      random_error[count - 4] += error_at(real, all, drawn, left_out) / orders;
      chosen.push_back(chosen_among(all, rated_among(real, chosen), possible, 1).front());
      drawn.push_back(possible[count]);
    }
  }
  // Beyond twelve, both have rated most of the twenty.
  double share = 0.0;
  for (std::size_t count = 7; count <= 12; ++count)
    share += needed(chosen_error, random_error[count - 4]) / static_cast<double>(count) / 6.0;
  RecordProperty("share", std::to_string(share));
  EXPECT_LE(share, 0.55) << share;
  EXPECT_LT(chosen_error[6], random_error[6]);
}

}  // namespace
}  // namespace mien::pipeline
