#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/base/drawing/plot.h"
#include "pipeline/production/sheets/sheet_parts.h"

namespace mien::pipeline {

namespace {

void draw_unrated_mark(Canvas& canvas, NameLanguage names, const Box& box) {
  const Box pill = draw_simulated_mark(canvas, {box.right(), box.y},
                                       name_in(names, "Simulated ratings", "模擬評定"), 11.0);
  canvas.text({box.right(), pill.bottom() + 14.0},
              "simulated ratings; no participants have rated the examples",
              {.size = 8.0, .colour = caution_ink, .align = Align::right});
}

std::string definition(const motion::Distance& distance) {
  const char* alignment = distance.alignment == motion::Alignment::pelvis
                              ? "horizontal position and heading removed at each time, height kept"
                              : "same starting position and heading";
  return fmt::format(
      "D: mean of |target − created| over {} times × {} joints, aligned by keytimes; {}.",
      motion::distance_times, motion::distance_joints, alignment);
}

/// Draws the distance D on a track from 0 to twice the threshold or more.
void draw_gauge(Canvas& canvas, const motion::Distance& distance, const Box& track) {
  const double threshold = motion::distance_threshold_m;
  const double limit = threshold * std::max(2.0, std::ceil(1.05 * distance.mean / threshold));
  const auto at = [&](double metres) { return track.x + track.width * metres / limit; };
  canvas.fill(track, hairline, 0.5 * track.height);
  canvas.fill(Box{track.x, track.y, at(distance.mean) - track.x, track.height}, quiet_ink, 0.0);
  canvas.line({at(threshold), track.y - 3.0}, {at(threshold), track.bottom() + 3.0},
              {.width = 1.0});
  canvas.disc({at(distance.mean), track.middle()}, 4.2, ink);
  const TextStyle small = {.size = 7.5, .colour = quiet_ink, .align = Align::centre};
  canvas.text({at(threshold), track.bottom() + 11.5}, fmt::format("threshold {:g} m", threshold),
              small);
  TextStyle left = small;
  left.align = Align::left;
  canvas.text({track.x, track.bottom() + 11.5}, "0", left);
  TextStyle right = small;
  right.align = Align::right;
  canvas.text({track.right(), track.bottom() + 11.5}, fmt::format("{:.2f} m", limit), right);
}

}  // namespace

std::string spoken_name(motion::BodyJoint joint) {
  std::string name;
  for (const char c : motion::name_of(joint)) {
    if (!name.empty() && std::isupper(static_cast<unsigned char>(c))) {
      name += ' ';
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else {
      name += c;
    }
  }
  return name;
}

void draw_heading(Canvas& canvas, Point baseline, const std::string& heading,
                  const std::string& remark) {
  const Box box = canvas.text(baseline, heading, {.size = 10.0, .bold = true});
  if (remark.empty()) return;
  canvas.text({box.right() + 7.0, baseline.y}, remark, {.size = 8.0, .colour = quiet_ink});
}

void draw_header(Canvas& canvas, const SheetContent& content, const Box& box) {
  const double mark_width = content.simulated_ratings ? 210.0 : 0.0;
  const double width = box.width - mark_width;
  canvas.text({box.x, box.y + 19.0}, content.created.id + " compared with " + content.target.id,
              {.size = 21.0, .bold = true, .max_width = width});
  canvas.text({box.x, box.y + 38.0}, "Study " + content.study,
              {.size = 10.0, .colour = quiet_ink, .max_width = width});
  if (content.simulated_ratings) draw_unrated_mark(canvas, content.names, box);
}

void draw_verdict(Canvas& canvas, const SheetContent& content, const Box& box) {
  canvas.fill(box, panel, 6.0);
  const std::string sentence = verdict(content.distance);
  const std::size_t colon = sentence.find(':') + 1;
  const double left = box.x + 14.0;
  const double room = box.width - 28.0;
  canvas.text({left, box.y + 18.0}, sentence.substr(0, colon), {.size = 10.0, .max_width = room});
  canvas.text({left, box.y + 41.0}, sentence.substr(colon + 1),
              {.size = 17.0, .bold = true, .max_width = room});
  draw_gauge(canvas, content.distance, {left, box.y + 52.0, room, 5.0});
  const TextStyle small = {.size = 8.0, .colour = quiet_ink, .max_width = room};
  canvas.text({left, box.bottom() - 26.0}, largest_distance_text(content.distance), small);
  const std::string fingertips = fingertips_text(content.target.motion, content.created.motion);
  canvas.text({left, box.bottom() - 16.0},
              fmt::format("MPJPE {:.3f} m; D_sum {:.2f} m{}", content.distance.mpjpe,
                          content.distance.sum, fingertips.empty() ? "" : "; " + fingertips),
              small);
  canvas.text({left, box.bottom() - 6.0},
              durations_text(content.target.motion, content.created.motion), small);
}

void draw_footer(Canvas& canvas, const SheetContent& content, const Box& box) {
  canvas.line({box.x, box.y}, {box.right(), box.y}, {.width = 0.7, .colour = hairline});
  const TextStyle style = {.size = 7.5, .colour = quiet_ink, .max_width = box.width};
  canvas.text({box.x, box.y + 11.0}, definition(content.distance), style);
  std::vector<std::string> facts;
  for (const auto& [name, value] : content.provenance) facts.push_back(name + " " + value);
  if (content.simulated_ratings) facts.emplace_back("simulated ratings");
  canvas.text({box.x, box.y + 22.0}, fmt::format("{}", fmt::join(facts, "  ·  ")), style);
}

}  // namespace mien::pipeline
