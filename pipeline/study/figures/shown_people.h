#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/math/geometry.h"
#include "motion/skeleton/clip.h"
#include "pipeline/manifest/stimulus.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/study/figures/page_figures.h"
#include "scenes/figures/figure.h"
#include "scenes/figures/figure_colour.h"

namespace mien::pipeline {

/// One of a stimulus's people, or its only motion, as in its film.
struct ShownPerson {
  motion::Clip clip;  ///< where it is on the stage, with the fingers that are shown
  scenes::Figure figure;
  scenes::FigureColours colours;
};

/// The people of a film.
struct ShownPeople {
  std::vector<ShownPerson> people;
  /// The horizontal direction from which several people are seen by the front camera (stage_front).
  std::optional<motion::Vec3> front;
};

/// Returns the people of a stimulus's film. Throws Error.
ShownPeople shown_people(const Stimulus& stimulus, FinishedMotions& motions);

/// People for a page (pipeline/study/page/src/figure/people.ts).
struct PeopleMessage {
  /// "fps", "frames", "front" (x, z; null for one person) and "people": of each "body" and "hands"
  /// (body_info; null for other than human bodies), "colours" of the middle, the left and the right
  /// (linear Rec. 709), "file" (an index of `files`; -1: a stick figure), and figure_json without
  /// the key.
  nlohmann::ordered_json head;
  /// For each person: the world-space poses of the joints (PageFigure::poses), of the body's if the
  /// figure has no others, and the weights of the face.
  std::string bytes;
  std::vector<std::string> files;  ///< contents of the GLB files of figures, each once
  std::vector<std::string> keys;   ///< keys of these files (PageFigure::key)
};

/// The message of at least one person. Throws Error as PageFigures.
PeopleMessage people_message(const ShownPeople& shown, PageFigures& figures);

}  // namespace mien::pipeline
