#include "scenes/character/face_control.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "motion/text/as_number.h"

namespace mien::scenes {

namespace {

/// "exp7" for "exp007", "exp_7" and "expression7": coefficients of SMPL-X.
std::optional<std::string> expression_name(std::string_view plain) {
  for (const std::string_view word : {"expression", "exp"}) {
    if (!plain.starts_with(word)) continue;
    std::string_view digits = plain.substr(word.size());
    if (digits.starts_with('_')) digits.remove_prefix(1);
    const std::optional<int> number = motion::as_number<int>(digits);
    if (number && *number >= 0) return "exp" + std::to_string(*number);
  }
  return std::nullopt;
}

/// Without regard to case, to how the side is written, and to zeros before the number of a
/// coefficient.
std::string plain_face_name(std::string_view name) {
  std::string plain;
  for (const char c : name) plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (plain.ends_with("_l")) return plain.substr(0, plain.size() - 2) + "left";
  if (plain.ends_with("_r")) return plain.substr(0, plain.size() - 2) + "right";
  return expression_name(plain).value_or(plain);
}

std::string_view after_last_point(std::string_view name) {
  const std::size_t point = name.rfind('.');
  return point == std::string_view::npos ? name : name.substr(point + 1);
}

}  // namespace

std::vector<std::string> face_names(const FaceControls& face) {
  std::vector<std::string> names;
  for (const FaceControl& control : face.controls) {
    if (!control.is_angle && std::ranges::find(names, control.name) == names.end())
      names.push_back(control.name);
  }
  return names;
}

const FaceControl* control_named(const FaceControls& face, std::string_view name) {
  const auto exact = std::ranges::find(face.controls, name, &FaceControl::name);
  if (exact != face.controls.end()) return &*exact;
  const std::string plain = plain_face_name(name);
  for (const bool is_whole : {true, false}) {
    for (const FaceControl& control : face.controls) {
      const std::string_view own =
          is_whole ? std::string_view(control.name) : after_last_point(control.name);
      if (plain_face_name(own) == plain) return &control;
    }
  }
  return nullptr;
}

}  // namespace mien::scenes
