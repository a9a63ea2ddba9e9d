#pragma once

#include <concepts>
#include <type_traits>

#include "motion/text/words.h"

namespace mien::pipeline {

/// What an option has an influence on, and so which artifacts have it in their keys: a sum of
/// these.
///
/// Each struct that a document fills has one list of its options, `fields_of`, beside it:
///
///     template <class Field, MaybeConst<Output> O>
///     void fields_of(Field&& field, O& output) {
///       field("size", output.size, concerns::picture);
///       field("quality", output.quality, concerns::picture, quality_words);
///     }
///
/// Whatever is done with options walks that list: reading it (field_reader.h), writing it
/// (field_writer.h), keys of artifacts (determinants.h), options of the command line
/// (render_options.h), what a regression says of it (settings.h), and the test that holds the list
/// against the schema (field_names.h). Beside plain values a `field` takes
///
/// - `group(key, [&](auto& inner) { … })`: a map within the map, of members of the same struct;
/// - `whole(key, value, concerns)`: a map that replaces the value, instead of being laid over it;
/// - `each(key, vector, concerns, prototype)`: an array of maps, laid over `prototype()` each;
/// - `by(key, value, concerns, Form())`: what is written in a way of its own: Form has static
///   functions `read(Given, value)`, `write(value, Writing)` and, where it has members,
///   `walk(names)`;
/// - `inside(value, concerns, Form())`: likewise, of members that stand in the same map.
///
namespace concerns {
enum : unsigned {
  nothing = 0,
  repertoire = 1U << 0,  ///< the examples and what people thought of them
  motion = 1U << 1,      ///< a stimulus's motion
  picture = 1U << 2,     ///< the frames of its film
  stored = 1U << 3,      ///< how frames are kept
  shown = 1U << 4,       ///< what a video shows beside the film
  files = 1U << 5,       ///< which files are written, and nothing in them
  page = 1U << 6,        ///< sheets, tables and the report
  drawing = 1U << 7,     ///< how a scene is drawn: of what concerns the picture

  // No artifacts, but how it is written:
  required = 1U << 16,  ///< the schema asks for it, so it is written always
  alone = 1U << 17,     ///< as the first of its map it may stand in the map's place

  everything = ~0U,  ///< whatever it is, and be it nothing
};
}  // namespace concerns

// field_values.h, value_forms.h
struct Given;
struct Writing;

/// Whether O is a struct, or it and const.
template <class O, class Struct>
concept MaybeConst = std::same_as<std::remove_const_t<O>, Struct>;

}  // namespace mien::pipeline
