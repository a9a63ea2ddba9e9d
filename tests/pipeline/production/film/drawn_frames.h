#pragma once

#include <map>
#include <stop_token>
#include <vector>

#include "pipeline/production/film/film.h"

namespace mien::test {

/// By their frames.
using Pictures = std::map<int, render::Image8>;

/// Frames of a shot as a display shows them; nothing is kept.
inline Pictures drawn_frames(const scenes::Shot& shot, const std::vector<int>& frames,
                             const pipeline::FilmSettings& how) {
  Pictures pictures;
  pipeline::draw_frames(
      shot, frames, how, nullptr,
      [&](int frame, const render::Image8& picture) { pictures[frame] = picture; },
      std::stop_token{}, [](double) {});
  return pictures;
}

}  // namespace mien::test
