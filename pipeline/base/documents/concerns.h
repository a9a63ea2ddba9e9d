#pragma once

#include <concepts>
#include <type_traits>

#include "motion/text/words.h"

namespace mien::pipeline {

/// What an option affects, which determines the artifacts whose keys include it: a bitwise OR of
/// the flags below.
///
/// Each struct that a document fills is declared with one list of its options, `fields_of`:
///
///     template <class Field, MaybeConst<Output> O>
///     void fields_of(Field&& field, O& output) {
///       field("size", output.size, concerns::picture);
///       field("quality", output.quality, concerns::picture, quality_words);
///     }
///
/// All processing of options visits that list: reading (field_reader.h), writing (field_writer.h),
/// keys of artifacts (determinants.h), options of the command line (render_options.h), settings in
/// regressions (settings.h), and the test that compares the list with the schema (field_names.h).
/// In addition to plain values, a `field` accepts
///
/// - `group(key, [&](auto& inner) { … })`: a nested map of members of the same struct;
/// - `whole(key, value, concerns)`: a map that replaces the value instead of being merged into it;
/// - `each(key, vector, concerns, prototype)`: an array of maps, each merged into `prototype()`;
/// - `by(key, value, concerns, Form())`: a value with a custom notation: Form has static functions
///   `read(DocumentValue, value)`, `write(value, WritingOptions)` and, if the value has members,
///   `walk(names)`;
/// - `inside(value, concerns, Form())`: a custom notation whose members are written in the map of
///   the struct itself, among its other options.
///
namespace concerns {
enum : unsigned {
  nothing = 0,
  repertoire = 1U << 0,  ///< the examples and their ratings
  motion = 1U << 1,      ///< a stimulus's motion
  picture = 1U << 2,     ///< the frames of its film
  stored = 1U << 3,      ///< how frames are stored
  shown = 1U << 4,       ///< what a video shows in addition to the film
  files = 1U << 5,       ///< which files are written, but not their contents
  page = 1U << 6,        ///< sheets, tables and the report
  drawing = 1U << 7,     ///< rendering settings (a part of those of `picture`)

  // These do not concern artifacts, but how the option is written:
  required = 1U << 16,  ///< required by the schema, so it is always written
  alone = 1U << 17,     ///< its value may be written in place of the whole map
  unkeyed = 1U << 18,   ///< left out of artifacts' keys also where the map around it is in them

  everything = ~0U,  ///< all options, including those that affect nothing
};
}  // namespace concerns

// Defined in field_values.h.
struct DocumentValue;
struct WritingOptions;

/// Whether O is Struct or const Struct.
template <class O, class Struct>
concept MaybeConst = std::same_as<std::remove_const_t<O>, Struct>;

}  // namespace mien::pipeline
