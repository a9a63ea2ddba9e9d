#pragma once

#include <string>

#include "render/parts/loaded_part.h"

namespace mien::render {

/// A function of the C library that a part is linked to, of the same name. `Part` has static
/// functions name() and purpose(), which are told to loaded_part. Throws as that.
template <class Part, class Function>
Function* library_function(const char* function) {
  static const std::string name = Part::name(), purpose = Part::purpose();
  static void* const part = loaded_part(name, purpose);
  return reinterpret_cast<Function*>(function_of_part(part, function, name, purpose));
}

}  // namespace mien::render

/// Defines a function of a C library that mien is not linked to: it loads the part that is when it
/// is first called, and calls the library's own. Names and signatures are the library's; the
/// compiler holds them to its headers. A function that is missing is missing when mien is linked.
#define MIEN_LIBRARY_CALL(Part, result, name, parameters, arguments)                        \
  result name parameters {                                                                  \
    static const auto own = mien::render::library_function<Part, result parameters>(#name); \
    return own arguments;                                                                   \
  }
