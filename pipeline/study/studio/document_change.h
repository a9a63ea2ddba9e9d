#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

namespace mien::pipeline {

/// A member's name, or an element's index.
using DocumentStep = std::variant<std::string, std::size_t>;
using DocumentPath = std::vector<DocumentStep>;

/// "stimuli[2].adjectives.quickness"
std::string path_text(const DocumentPath& path);

/// One change of a document.
struct DocumentChange {
  enum class Kind {
    set,     ///< a value, or a member that was not there
    insert,  ///< an element before the one of that index, or behind the last
    remove   ///< a member or an element
  };

  Kind kind = Kind::set;
  DocumentPath path;
  nlohmann::ordered_json value;  ///< of a removal: none
};

/// The document after it. Throws std::out_of_range where there is no such place in it.
void apply(const DocumentChange& change, nlohmann::ordered_json& document);

/// What makes one document of another, in the order in which it is to be done; as little as
/// possible. Elements that have an `id` are matched by it. The order of members counts for
/// nothing, and numbers are compared as double precision.
std::vector<DocumentChange> changes_between(const nlohmann::ordered_json& from,
                                            const nlohmann::ordered_json& to);

/// Whether two documents say the same.
bool say_the_same(const nlohmann::ordered_json& one, const nlohmann::ordered_json& other);

}  // namespace mien::pipeline
