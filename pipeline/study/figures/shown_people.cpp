#include "pipeline/study/figures/shown_people.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "pipeline/manifest/look/look.h"
#include "pipeline/manifest/person_figure.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/study/figures/figure_message.h"
#include "pipeline/study/live/live_bundle_writer.h"
#include "scenes/figures/shown_hands.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

ordered_json colours_json(const scenes::FigureColours& colours) {
  ordered_json list = ordered_json::array();
  for (const auto& colour : {colours.middle, colours.left, colours.right})
    list.push_back({colour.x(), colour.y(), colour.z()});
  return list;
}

ordered_json person_json(const ShownPerson& person, const PageFigure& figure, int file) {
  const motion::Skeleton& body = person.clip.body;
  ordered_json shown = figure_json(figure);
  shown.erase("key");
  shown["file"] = file;
  shown["colours"] = colours_json(person.colours);
  shown["body"] = body_info(body);
  shown["hands"] = motion::is_body(body) ? body_info(motion::with_fingers(body)) : ordered_json();
  return shown;
}

/// The index of a figure's file, which is made if it is new; -1 if it has none.
int file_of(const PageFigure& figure, const FigureRequest& request, PageFigures& figures,
            PeopleMessage& message) {
  if (figure.key.empty()) return -1;
  const auto known = std::ranges::find(message.keys, figure.key);
  const auto index = static_cast<int>(known - message.keys.begin());
  if (known == message.keys.end()) {
    message.keys.push_back(figure.key);
    message.files.push_back(figures.file(figure.key, request));
  }
  return index;
}

ShownPerson person_of(const Stimulus& stimulus, std::size_t index, motion::Clip clip) {
  const Person& person = stimulus.people[index];
  const std::string_view colour =
      person.colour.empty() ? scenes::person_colour(index) : std::string_view(person.colour);
  return {scenes::with_shown_hands(std::move(clip), person.hands.value_or(stimulus.look.hands)),
          figure_of(person, stimulus.look), scenes::colours_of_hex(colour)};
}

}  // namespace

ShownPeople shown_people(const Stimulus& stimulus, FinishedMotions& motions) {
  ShownPeople shown;
  if (stimulus.people.empty()) {
    shown.people.push_back(
        {scenes::with_shown_hands(staged_clip(stimulus, motions), stimulus.look.hands),
         shown_figure(stimulus.look), scenes::colours_of(film_role(stimulus))});
    return shown;
  }
  std::vector<motion::Clip> clips = placed_people(stimulus, motions);
  shown.front = stage_front(stimulus, clips);
  for (std::size_t i = 0; i < clips.size(); ++i)
    shown.people.push_back(person_of(stimulus, i, std::move(clips[i])));
  return shown;
}

PeopleMessage people_message(const ShownPeople& shown, PageFigures& figures) {
  const motion::Clip& first = shown.people.front().clip;
  PeopleMessage message;
  message.head = {
      {"fps", first.frames_per_second},
      {"frames", first.frame_count()},
      {"front", shown.front ? ordered_json({shown.front->x(), shown.front->z()}) : ordered_json()},
      {"people", ordered_json::array()}};
  for (const ShownPerson& person : shown.people) {
    const FigureRequest request = {.figure = person.figure,
                                   .colours = person.colours,
                                   .clip = person.clip,
                                   .film_frames = person.clip.frame_count()};
    const PageFigure figure = figures.fitted_figure(request);
    const int file = file_of(figure, request, figures, message);
    message.head["people"].push_back(person_json(person, figure, file));
    message.bytes += (figure.joints == 0 ? body_poses(person.clip) : figure.poses) + figure.face;
  }
  return message;
}

}  // namespace mien::pipeline
