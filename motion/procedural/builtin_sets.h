#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/procedural/walk_style.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// A walk that comes with the program.
struct NamedStyle {
  std::string name;
  WalkStyle style;
};

/// Names of the built-in sets.
std::vector<std::string_view> builtin_set_names();

/// The styles of a built-in set of walks, in its fixed order. An unknown name throws mien::Error
/// that lists the known ones.
///
/// "walks-10": normal, brisk, slow, happy, sad, angry, proud, afraid, tired, relaxed.
/// "walks-27": nine emotions from around the circumplex of affect, each fast, at its own speed and
/// slow: "happy-fast", "happy-normal", "happy-slow", …
std::vector<NamedStyle> builtin_styles(std::string_view name);

/// Names of the examples of a built-in set. Throws as above.
std::vector<std::string> builtin_example_names(std::string_view name);

/// Makes one example of a built-in set.
struct ExampleMaker {
  std::string name;
  std::function<Example()> make;  ///< named; several may be called at the same time
};

/// Makers of the examples of a built-in set, in its fixed order. Throws as above.
std::vector<ExampleMaker> builtin_example_makers(std::string_view name,
                                                 double frames_per_second = 30.0);

/// A built-in set without its examples: its name and properties.
ExampleSet empty_example_set(std::string_view name);

/// The set's walks, made by the parametric walker on the standard body; marked as simulated.
///
/// "actors" is not for blending: a woman of 1.65 m and a man of 1.80 m ("woman-walk-sad",
/// "man-knock-neutral", …), each walking neutrally and in ten acted emotions, knocking on a door
/// neutrally and in two, and standing in three poses.
ExampleSet builtin_examples(std::string_view name, double frames_per_second = 30.0);

}  // namespace mien::motion
