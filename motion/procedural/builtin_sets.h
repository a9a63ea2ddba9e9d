#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/procedural/walk_style.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

/// A built-in walk style.
struct NamedStyle {
  std::string name;
  WalkStyle style;
};

/// Names of the built-in sets.
std::vector<std::string_view> builtin_set_names();

/// The styles of a built-in set of walks, in its fixed order. For any name but "walks-10" and
/// "walks-27" it throws mien::Error.
///
/// "walks-10": normal, brisk, slow, happy, sad, angry, proud, afraid, tired, relaxed. "walks-27":
/// nine emotions around the circumplex of affect, each fast, at its natural speed and slow:
/// "happy-fast", "happy-normal", "happy-slow", …
std::vector<NamedStyle> builtin_styles(std::string_view name);

/// Names of the examples of a built-in set, in its fixed order. Throws mien::Error for an unknown
/// set.
std::vector<std::string> builtin_example_names(std::string_view name);

/// A named function that makes one example of a built-in set.
struct ExampleMaker {
  std::string name;
  std::function<Example()> make;  ///< thread-safe; the example has the same name
};

/// Makers of the examples of a built-in set, in its fixed order. Throws mien::Error for an unknown
/// set.
std::vector<ExampleMaker> builtin_example_makers(std::string_view name,
                                                 double frames_per_second = 30.0);

/// A built-in set with its name and properties, but without examples.
ExampleSet empty_example_set(std::string_view name);

/// The examples of a built-in set, synthesized and marked as simulated. Those of "walks-10" and
/// "walks-27" have the standard body. Throws mien::Error for an unknown set.
///
/// "actors" is not blendable and has two bodies: a woman of 1.65 m and a man of 1.80 m
/// ("woman-walk-sad", "man-knock-neutral", …), each walking neutrally and in ten acted emotions,
/// knocking on a door neutrally and in two emotions, and standing in three poses.
ExampleSet builtin_examples(std::string_view name, double frames_per_second = 30.0);

}  // namespace mien::motion
