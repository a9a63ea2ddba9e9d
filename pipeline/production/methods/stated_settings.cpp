#include "pipeline/production/methods/stated_settings.h"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "motion/text/excerpt.h"
#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t most_named = 6;
constexpr std::string_view face_path = "look.face.";  // before the name of a weight

/// An option in words; {} is its value. Words without it are of options that are set or not, or of
/// one value, which follows the path after "=".
struct OptionWords {
  std::string_view path;  ///< the end of the option's
  std::string_view words;
};

constexpr OptionWords option_words[] = {
    {"output.in_place", "walking in place"},
    {"output.cycles=1", "looping motions shown once"},
    {"output.cycles", "looping motions repeated {} times"},
    {"output.scale", "images rendered at {} times the size"},
    {"output.crop", "images cropped to {} (left, top, width, height in pixels)"},
    {"output.quality", "quality {}"},
    {"output.samples", "{} samples per pixel"},
    {"output.shutter", "motion blur with a shutter angle of {}°"},
    {"output.frames=none", "no files of single frames kept"},
    {"output.frames", "single frames kept as {} files"},
    {"output.clips", "motion files written as {}"},
    {"presentation.card.text", "a card with the text {}"},
    {"presentation.card.seconds", "the card shown for {} s"},
    {"presentation.fixation.seconds", "a fixation cross for {} s"},
    {"presentation.fixation.size", "a fixation cross {} pixels in size"},
    {"presentation.blank_before", "a blank of {} s before the film"},
    {"presentation.blank_after", "a blank of {} s after the film"},
    {"presentation.fade_in", "a fade-in of {} s"},
    {"presentation.fade_out", "a fade-out of {} s"},
    {"presentation.background", "cards, cross and blanks on grey {} (sRGB, 0 black, 1 white)"},
    {"look.colours", "figures coloured by {}"},
    {"look.hands=drawn", "hands drawn with fingers, relaxed where a motion has none"},
    {"look.hands=auto", "hands with the fingers of the motion, if it has any"},
    {"look.hands=hidden", "hands drawn without fingers"},
    {"look.scene.background", "the background {}"},
    {"trail.figure.mannequin", "trails of mannequins"},
    {"figure.character", "the character of the file {}"},
    {"look.face=hidden", "faces hidden behind a plain oval"},
    {"look.face=neutral", "faces as in the file of the character"},
    {"look.face.file", "faces moved by the weights of the file {}"},
    {"look.face.take", "weights of the face of the take {}"},
    {"look.face.start", "weights of the face beginning at {} s of the film"},
    {"look.face.fps", "weights of the face at {} frames per second"},
    {"mannequin.build", "mannequins of build {} (0 slim, 1 heavy)"},
    {"mannequin.sex", "mannequins of sex {} (0 female, 1 male)"},
    {"point-light.joints", "dots on {}"},
    {"point-light.size", "dots {} pixels in diameter"},
    {"point-light.size_m", "dots {} m in diameter"},
    {"point-light.polarity", "dots {}"},
    {"point-light.contrast", "a Michelson contrast of dots and background of {}"},
    {"point-light.colour", "dots of the colour {}"},
    {"point-light.background", "dots on a background of colour {}"},
    {"point-light.lifetime", "dots with a lifetime of {} frames"},
    {"point-light.inverted", "inverted dots"},
    {"point-light.mirrored", "dots mirrored left–right"},
    {"point-light.rotated", "dots turned about the vertical by {}°"},
    {"point-light.scrambled", "dots scrambled in space"},
    {"point-light.reversed", "dots played backwards"},
    {"point-light.constant_speed", "dots at constant speed"},
    {"point-light.phase_scrambled", "dots scrambled in phase"},
    {"point-light.noise", "{} noise dots"},
    {"point-light.mask", "{} mask dots"},
    {"point-light.seed", "random seed {} of the dots"},
    {"markers.show", "markers named {}"},
    {"markers.pairs", "sticks between {}"},
    {"markers.gaps", "markers in gaps: {}"},
    {"markers.size", "markers {} pixels in diameter"},
    {"markers.size_mm", "markers {} mm in diameter"},
    {"markers.polarity", "markers {}"},
    {"markers.contrast", "a Michelson contrast of markers and background of {}"},
    {"markers.colour", "markers of the colour {}"},
    {"markers.background", "markers on a background of colour {}"},
    {"markers.lifetime", "dots on the limbs of markers with a lifetime of {} frames"},
    {"markers.inverted", "inverted markers"},
    {"markers.mirrored", "markers mirrored left–right"},
    {"markers.rotated", "markers turned about the vertical by {}°"},
    {"markers.scrambled", "markers scrambled in space"},
    {"markers.reversed", "markers played backwards"},
    {"markers.constant_speed", "markers at constant speed"},
    {"markers.phase_scrambled", "markers scrambled in phase"},
    {"markers.noise", "{} noise dots"},
    {"markers.mask", "{} mask dots"},
    {"markers.seed", "random seed {} of the dots of markers"},
    {"camera.orthographic", "an orthographic camera"},
    {"camera.fov", "a field of view of {}°"},
    {"camera.position", "the camera at {} m"},
    {"camera.target", "the camera looking at {} m"},
    {"camera.stereo.separation", "a stereo pair of eyes {} m apart"},
    {"camera.screen.distance_cm", "a screen {} cm away"},
    {"camera.screen.width_cm", "a screen {} cm wide"},
    {"camera.screen.degrees", "figures {}° of visual angle tall"},
    {"camera.figure_px", "figures {} pixels tall"},
    {"modify.paths", "path length {} (0 shortest, 1 unchanged, 2 longest)"},
    {"modify.acceleration", "acceleration {} (−1 constant speed, 0 unchanged, 1 accelerated)"},
    {"modify.acceleration_at", "acceleration at {}"},
    {"modify.hands=keep", "paths of fingers unchanged"},
    {"modify.hands=scale", "paths of fingers changed as those of the body"},
    {"modify.tempo", "tempo × {}"},
    {"modify.gravity", "gravity {} at that tempo"},
    {"modify.stiffness.head", "stiffness {} of the head"},
    {"modify.stiffness.trunk", "stiffness {} of the trunk"},
    {"modify.stiffness.arms", "stiffness {} of the arms"},
    {"modify.stiffness.left-arm", "stiffness {} of the left arm"},
    {"modify.stiffness.right-arm", "stiffness {} of the right arm"},
    {"modify.stiffness.legs", "stiffness {} of the legs"},
    {"modify.weight", "weight × {}"},
    {"modify.variation", "variation {}"},
    {"modify.gains.low", "a gain below 1 Hz of {}"},
    {"modify.gains.middle", "a gain from 1 to 12.5 Hz of {}"},
    {"modify.gains.high", "a gain above 12.5 Hz of {}"},
    {"modify.limbs", "changed timing of {} only"},
};

std::string text_of(const OrderedJson& value) {
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_string()) return motion::printable(value.get<std::string>());
  if (value.is_number_float()) return shortest(value.get<double>());
  if (!value.is_array()) return value.dump();
  if (value.empty()) return "nothing";
  Names parts;
  for (const OrderedJson& one : value) parts.push_back(text_of(one));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// "look.camera.depth_of_field.focus" → "camera depth of field focus".
std::string name_of_option(std::string_view path) {
  const std::size_t dot = path.find('.');
  std::string name(dot == std::string_view::npos ? path : path.substr(dot + 1));
  std::ranges::replace(name, '.', ' ');
  std::ranges::replace(name, '_', ' ');
  return name;
}

/// Pairs as a list of names: "LASI–RASI".
OrderedJson joined_pairs(const OrderedJson& pairs) {
  OrderedJson names = OrderedJson::array();
  for (const OrderedJson& pair : pairs) names.push_back(text_of(pair[0]) + "–" + text_of(pair[1]));
  return names;
}

/// Points of a curve as a list of names: "1.4 at 0.5".
OrderedJson joined_points(const OrderedJson& points) {
  OrderedJson names = OrderedJson::array();
  for (const OrderedJson& point : points)
    names.push_back(text_of(point[1]) + " at " + text_of(point[0]));
  return names;
}

bool is_of_maps(const OrderedJson& value) {
  return value.is_array() &&
         std::ranges::any_of(value, [](const OrderedJson& one) { return one.is_structured(); });
}

void each_option(const std::string& path, const OrderedJson& value,
                 const std::function<void(const std::string&, const OrderedJson&)>& visit) {
  if (value.is_null()) return;
  if (value.is_object()) {
    for (const auto& [key, one] : value.items()) {
      // What is named and has no options is as set as what has some.
      const bool is_bare = one.is_null() || (one.is_object() && one.empty());
      each_option(path + "." + key, is_bare ? OrderedJson(true) : one, visit);
    }
  } else if (path.ends_with("markers.pairs")) {
    visit(path, joined_pairs(value));
  } else if (path.ends_with("modify.tempo") && value.is_array()) {
    visit(path, joined_points(value));
  } else if (is_of_maps(value)) {
    for (std::size_t i = 0; i < value.size(); ++i)
      each_option(path + "." + std::to_string(i + 1), value[i], visit);
  } else {
    visit(path, value);
  }
}

}  // namespace

std::string words_of_option(std::string_view path, const OrderedJson& value) {
  const std::string text = text_of(value);
  const std::string_view posture = "modify.posture.";
  if (path.starts_with(posture)) return fmt::format("{} {}°", path.substr(posture.size()), text);
  for (const auto& [stated, words] : option_words) {
    const std::size_t equals = stated.find('=');
    const std::string_view end = stated.substr(0, equals);
    const bool is_of_value = equals != std::string_view::npos;
    if (is_of_value && stated.substr(equals + 1) != text) continue;
    const bool is_it = path == end || (path.ends_with(end) && path.size() > end.size() &&
                                       path[path.size() - end.size() - 1] == '.');
    if (!is_it) continue;
    if (is_of_value) return std::string(words);
    const std::size_t placeholder = words.find("{}");
    if (placeholder != std::string_view::npos)
      return fmt::format("{}{}{}", words.substr(0, placeholder), text,
                         words.substr(placeholder + 2));
    if (value == true) return std::string(words);
  }
  if (path.starts_with(face_path))
    return fmt::format("the face's {} at a weight of {}", path.substr(face_path.size()), text);
  return fmt::format("{}: {}", name_of_option(path), text);
}

void StatedSettings::add(const std::string& path, const OrderedJson& value, const std::string& of) {
  each_option(path, value, [&](const std::string& option, const OrderedJson& one) {
    const std::string words = words_of_option(option, one);
    const auto found = std::ranges::find(settings_, words, &std::pair<std::string, Names>::first);
    if (found == settings_.end()) {
      settings_.push_back({words, {of}});
    } else {
      add_once(found->second, of);
    }
  });
}

std::string StatedSettings::text(const Names& everybody) const {
  std::vector<std::pair<Names, Names>> groups;  // who, words
  for (const auto& [words, who] : settings_) {
    const auto found = std::ranges::find(groups, who, &std::pair<Names, Names>::first);
    if (found == groups.end()) {
      groups.push_back({who, {words}});
    } else {
      found->second.push_back(words);
    }
  }
  Names parts;
  for (const auto& [who, words] : groups) {
    std::string part = listed(words);
    const auto has_it = [&said_of = who](const std::string& one) {
      return std::ranges::find(said_of, one) != said_of.end();
    };
    if (!std::ranges::all_of(everybody, has_it)) {
      part += who.size() <= most_named ? " (" + listed(who) + ")"
                                       : fmt::format(" ({} of {})", who.size(), everybody.size());
    }
    parts.push_back(part);
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace mien::pipeline
