#include "pipeline/study/questionnaire/experiment/turned_motions.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/documents/sha256.h"
#include "pipeline/manifest/look/look.h"
#include "pipeline/manifest/person_figure.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/study/figures/figure_message.h"
#include "pipeline/study/live/live_bundle_writer.h"
#include "scenes/figures/figure_colour.h"
#include "scenes/figures/shown_hands.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

/// Of the stimuli's people, or of its only motion.
struct TurnedPerson {
  motion::Clip clip;  ///< with the fingers that are shown
  scenes::Figure figure;
  scenes::FigureColours colours;
};

std::vector<TurnedPerson> people_of(const Stimulus& stimulus, std::vector<motion::Clip> clips) {
  std::vector<TurnedPerson> people;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    motion::Clip clip = scenes::with_shown_hands(std::move(clips[i]), stimulus.look.hands);
    if (stimulus.people.empty()) {
      people.push_back(
          {std::move(clip), shown_figure(stimulus.look), scenes::colours_of(film_role(stimulus))});
      continue;
    }
    const Person& person = stimulus.people[i];
    const std::string_view colour =
        person.colour.empty() ? scenes::person_colour(i) : std::string_view(person.colour);
    people.push_back(
        {std::move(clip), figure_of(person, stimulus.look), scenes::colours_of_hex(colour)});
  }
  return people;
}

ordered_json front_json(const Stimulus& stimulus, const std::vector<motion::Clip>& clips) {
  if (stimulus.people.empty()) return nullptr;
  const motion::Vec3 front = stage_front(stimulus, clips);
  return {front.x(), front.z()};
}

ordered_json colours_json(const scenes::FigureColours& colours) {
  ordered_json list = ordered_json::array();
  for (const auto& colour : {colours.middle, colours.left, colours.right})
    list.push_back({colour.x(), colour.y(), colour.z()});
  return list;
}

ordered_json person_json(const TurnedPerson& person, const PageFigure& figure, int file) {
  const motion::Skeleton& body = person.clip.body;
  ordered_json shown = figure_json(figure);
  shown.erase("key");  // names files of this machine
  shown["file"] = file;
  shown["colours"] = colours_json(person.colours);
  shown["body"] = body_info(body);
  shown["hands"] = motion::is_body(body) ? body_info(motion::with_fingers(body)) : ordered_json();
  return shown;
}

/// The index of a file in the list, to which it is added if it is new.
int index_in(std::vector<FigureFile>& files, FigureFile file) {
  const auto found = std::ranges::find(files, file.token, &FigureFile::token);
  const auto index = static_cast<int>(found - files.begin());
  if (found == files.end()) files.push_back(std::move(file));
  return index;
}

}  // namespace

TurnedMotions::TurnedMotions(const Manifest& manifest, std::filesystem::path folder)
    : folder_(std::move(folder)), motions_(manifest) {}

std::optional<TurnedMotion> TurnedMotions::of(const Stimulus& stimulus) {
  const bool is_alone = stimulus.people.empty();
  if (is_alone && !can_be_turned(stimulus.look.figure)) return std::nullopt;
  std::vector<motion::Clip> clips =
      is_alone ? std::vector{staged_clip(stimulus, motions_)} : placed_people(stimulus, motions_);
  if (is_alone && !motion::is_body(clips.front().body)) return std::nullopt;
  TurnedMotion turned;
  ordered_json head = {{"fps", clips.front().frames_per_second},
                       {"frames", clips.front().frame_count()},
                       {"front", front_json(stimulus, clips)},
                       {"people", ordered_json::array()}};
  std::string bytes;
  for (const TurnedPerson& person : people_of(stimulus, std::move(clips))) {
    const FigureRequest request = {.figure = person.figure,
                                   .colours = person.colours,
                                   .clip = person.clip,
                                   .film_frames = person.clip.frame_count()};
    const PageFigure figure = figures_.fitted_figure(request);
    const int file =
        figure.key.empty() ? -1 : index_in(turned.figures, file_of(figure.key, request));
    head["people"].push_back(person_json(person, figure, file));
    bytes += (figure.joints == 0 ? body_poses(person.clip) : figure.poses) + figure.face;
  }
  for (const FigureFile& file : turned.figures) head["figures"].push_back(file.token);
  turned.bytes = framed(head, bytes);
  return turned;
}

FigureFile TurnedMotions::file_of(const std::string& key, const FigureRequest& request) {
  const auto known = files_.find(key);
  if (known != files_.end()) return known->second;
  const std::string& glb = figures_.file(key, request);
  FigureFile made;
  made.sha256 = sha256_of(glb);
  made.token = "f" + made.sha256.substr(0, 14);
  made.file = folder_ / (made.token + ".glb");
  make_folder(folder_);
  write_file(made.file, glb);
  return files_.emplace(key, std::move(made)).first->second;
}

}  // namespace mien::pipeline
