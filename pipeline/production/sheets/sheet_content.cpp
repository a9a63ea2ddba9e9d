#include "pipeline/production/sheets/sheet_content.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>

#include "motion/measures/distance/distance.h"
#include "pipeline/base/drawing/canvas.h"
#include "pipeline/base/drawing/figure_drawing.h"
#include "pipeline/base/drawing/palette.h"
#include "pipeline/base/drawing/plot.h"
#include "pipeline/production/sheets/sheet_parts.h"
#include "pipeline/production/synthesis/modified_motion.h"
#include "pipeline/production/synthesis/parameter_label.h"
#include "pipeline/production/synthesis/synthesis.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

constexpr double page_width = 1190.55;
constexpr double gallery_margin = 36.0;
constexpr double gallery_header = 56.0;
constexpr double gallery_footer = 30.0;
constexpr double motion_height = 84.0;
constexpr double label_width = 205.0;
constexpr int gallery_pixels_wide = 3508;

double page_height(const GalleryContent& content) {
  return 2.0 * gallery_margin + gallery_header + gallery_footer +
         motion_height * static_cast<double>(content.motions.size());
}

std::vector<Figure> figures_of(const GalleryContent& content, const SheetMotion& shown) {
  std::vector<Figure> figures;
  for (int t = 0; t < motion::distance_times; ++t) {
    const double seconds = motion::corresponding_time(content.motions.front().motion, shown.motion,
                                                      t / (motion::distance_times - 1.0));
    figures.push_back(
        figure_of(shown.motion.clip.body,
                  motion::aligned_pose_at(shown.motion.clip, seconds, motion::Alignment::pelvis)));
  }
  return figures;
}

void draw_title(Canvas& canvas, const GalleryContent& content) {
  const double baseline = gallery_margin + 16.0;
  const Box title =
      canvas.text({gallery_margin, baseline}, content.title, {.size = 18.0, .bold = true});
  canvas.text({title.right() + 10.0, baseline}, content.study, {.size = 11.0, .colour = quiet_ink});
  canvas.text({gallery_margin, baseline + 17.0},
              fmt::format("{} motions at corresponding moments; D relative to the first",
                          content.motions.size()),
              {.size = 9.0, .colour = quiet_ink});
  if (!content.simulated_ratings) return;
  canvas.text({page_width - gallery_margin, baseline}, simulated_ratings_mark,
              {.size = 11.0, .colour = caution_ink, .bold = true, .align = Align::right});
}

void draw_label(Canvas& canvas, const GalleryContent& content, const SheetMotion& shown,
                const Box& row, const Colour& colour) {
  const TextStyle quiet = {.size = 8.0, .colour = quiet_ink, .max_width = label_width - 12.0};
  canvas.text({row.x, row.middle() - 12.0}, shown.id,
              {.size = 11.0, .colour = colour, .bold = true, .max_width = label_width - 12.0});
  canvas.text({row.x, row.middle() + 1.0}, shown.origin, quiet);
  std::string facts = fmt::format("{:.2f} s", shown.motion.clip.duration_seconds());
  const auto place = static_cast<std::size_t>(&shown - content.motions.data());
  if (place > 0) facts += fmt::format(", D = {:.3f} m", content.distances_m[place]);
  canvas.text({row.x, row.middle() + 13.0}, facts, quiet);
}

void draw_rows(Canvas& canvas, const GalleryContent& content) {
  std::vector<std::vector<Figure>> rows;
  FigureExtent extent;
  for (const SheetMotion& shown : content.motions) {
    rows.push_back(figures_of(content, shown));
    for (const Figure& figure : rows.back()) extent.include(figure);
  }
  const double column = (page_width - 2.0 * gallery_margin - label_width) / motion::distance_times;
  const double scale = std::min((column - 6.0) / (extent.right - extent.left),
                                (motion_height - 12.0) / (extent.top - extent.bottom));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Box row = {gallery_margin,
                     gallery_margin + gallery_header + motion_height * static_cast<double>(r),
                     page_width - 2.0 * gallery_margin, motion_height};
    const MotionColours& colours = content.colours[r];
    const double ground = row.bottom() - 5.0 + scale * extent.bottom;
    canvas.line({row.x + label_width, ground}, {row.right(), ground},
                {.width = 0.7, .colour = hairline});
    draw_label(canvas, content, content.motions[r], row, colours.line);
    for (std::size_t t = 0; t < rows[r].size(); ++t) {
      const double pelvis = row.x + label_width + column * (static_cast<double>(t) + 0.5) -
                            0.5 * scale * (extent.left + extent.right);
      draw_figure(canvas, rows[r][t], {colours}, {scale, {pelvis, ground}});
    }
  }
}

std::string drawn(Canvas& canvas, const GalleryContent& content) {
  draw_title(canvas, content);
  draw_rows(canvas, content);
  std::string facts = "lighter limbs: left side";
  for (const auto& [name, value] : content.provenance) facts += "  ·  " + name + " " + value;
  canvas.text({gallery_margin, page_height(content) - gallery_margin}, facts,
              {.size = 8.0, .colour = quiet_ink});
  return canvas.finish();
}

SheetMotion sheet_motion(const std::string& name, Motions& motions) {
  const Synthesis& synthesis = motions.of(name);
  SheetMotion result{name, origin_of(name, motions), synthesis.motion, {}};
  if (!synthesis.modified.empty()) {
    result.origin =
        synthesis.modified + share_text(synthesis.modified_share) + ", of " + result.origin;
  }
  for (Eigen::Index i = 0; i < synthesis.weights.size(); ++i) {
    const std::string& example = motions.repertoire().names[static_cast<std::size_t>(i)].name;
    if (synthesis.weights[i] > 0.0) result.weights.emplace_back(example, synthesis.weights[i]);
  }
  return result;
}

std::optional<double> value_of(const NamedValues& values, const std::string& name) {
  for (const auto& [parameter, value] : values) {
    if (parameter == name) return value;
  }
  return std::nullopt;
}

/// Requested and held values of a motion, and the values reached.
struct Values {
  NamedValues requested;
  NamedValues held;
  NamedValues reached;  ///< of the requested parameters
  NamedValues rated;    ///< every rated parameter, of a blend of rated examples
  bool are_features = false;

  std::optional<double> reached_of(const std::string& id, bool is_feature) const {
    if (is_feature != are_features) return is_feature ? std::nullopt : value_of(rated, id);
    const auto own = value_of(reached, id);
    return own || is_feature ? own : value_of(rated, id);
  }
  SheetValue of(const std::string& id, bool is_feature) const {
    return {is_feature == are_features ? value_of(requested, id) : std::nullopt,
            is_feature ? std::nullopt : value_of(held, id), reached_of(id, is_feature)};
  }
};

/// What is shown as captured has nothing to do with the examples, of which there may be none.
Values values_of(const std::string& name, Motions& motions) {
  const Synthesis& made = motions.of(name);
  const Stimulus* stimulus = motions.stimulus(name);
  const bool is_blend = made.weights.size() > 0;
  return {made.requested, made.held, made.modified.empty() ? made.reached : NamedValues(),
          is_blend ? rated_values(made, motions.repertoire()) : NamedValues(),
          stimulus != nullptr && !stimulus->features.empty()};
}

/// Parameters that either motion requests, the target's first, then those held, then all
/// others with a value.
class ParameterList {
 public:
  ParameterList(const Values& target, const Values& created, const ScaleSet& scales)
      : target_(target), created_(created), scales_(scales) {
    add(target.requested, target.are_features);
    add(created.requested, created.are_features);
    add(target.held, false);
    add(created.held, false);
    add(target.rated, false);
    add(created.rated, false);
  }

  std::vector<SheetParameter> take() { return std::move(parameters_); }

 private:
  void add(const NamedValues& values, bool are_features) {
    for (const auto& [id, value] : values) {
      if (!known_.emplace(id, are_features).second) continue;
      parameters_.push_back({are_features ? feature_label(id) : rating_label(id, scales_),
                             target_.of(id, are_features), created_.of(id, are_features)});
    }
  }

  const Values& target_;
  const Values& created_;
  const ScaleSet& scales_;
  std::set<std::pair<std::string, bool>> known_;
  std::vector<SheetParameter> parameters_;
};

/// Whether a number on the sheet comes from ratings.
bool rests_on_ratings(const Values& values) {
  return !values.rated.empty() || (!values.requested.empty() && !values.are_features);
}

/// Examples are what motions are made from: references.
MotionColours colours_of(const Stimulus* stimulus) {
  if (stimulus == nullptr || stimulus->role == Role::reference) return reference_colours;
  return stimulus->role == Role::target ? target_colours : created_colours;
}

}  // namespace

std::string origin_of(const std::string& name, const Motions& motions) {
  const Stimulus* stimulus = motions.stimulus(name);
  if (stimulus == nullptr) return "example";
  if (stimulus->clip) return "as captured";
  if (stimulus->walk) return "along a path";
  if (!stimulus->features.empty()) return "from features";
  if (!stimulus->adjectives.empty()) return "from adjectives";
  return stimulus->weights.size() == 1 ? stimulus->weights.front().first : "from weights";
}

std::vector<std::pair<std::string, std::string>> provenance_of(const Manifest& manifest) {
  return {{"mien", std::string(program_version())},
          {"seed", std::to_string(manifest.seed)},
          {"manifest", manifest.file.filename().string()}};
}

SheetContent sheet_content(const Sheet& sheet, const Manifest& manifest, Motions& motions) {
  SheetContent content;
  content.study = manifest.study;
  content.target = sheet_motion(sheet.target, motions);
  content.created = sheet_motion(sheet.created, motions);
  if (!sheet.reference.empty()) {
    content.reference = sheet_motion(sheet.reference, motions);
  }
  content.names = name_language(manifest);
  content.distance = motions.distance(sheet.target, sheet.created);
  const Values target = values_of(sheet.target, motions);
  const Values created = values_of(sheet.created, motions);
  if (!target.requested.empty() || !created.requested.empty() || rests_on_ratings(target) ||
      rests_on_ratings(created)) {
    const Repertoire& repertoire = motions.repertoire();
    content.parameters = ParameterList(target, created, repertoire.scales).take();
    content.simulated_ratings =
        repertoire.simulated_ratings && (rests_on_ratings(target) || rests_on_ratings(created));
  }
  content.provenance = provenance_of(manifest);
  return content;
}

GalleryContent gallery_content(const Sheet& sheet, const Manifest& manifest, Motions& motions) {
  GalleryContent content{manifest.study, sheet.id, {}, {}, {}, false, provenance_of(manifest)};
  for (const std::string& name : sheet.gallery) {
    content.motions.push_back(sheet_motion(name, motions));
    content.distances_m.push_back(motions.distance(sheet.gallery.front(), name).mean);
    const Stimulus* stimulus = motions.stimulus(name);
    content.colours.push_back(colours_of(stimulus));
    const bool is_rated = stimulus != nullptr && !stimulus->adjectives.empty();
    content.simulated_ratings |= is_rated && motions.repertoire().simulated_ratings;
  }
  return content;
}

std::string gallery_as_pdf(const GalleryContent& content) {
  return drawn(*Canvas::pdf(page_width, page_height(content), content.title), content);
}

std::string gallery_as_png(const GalleryContent& content) {
  return drawn(*Canvas::png(page_width, page_height(content), gallery_pixels_wide), content);
}

}  // namespace mien::pipeline
