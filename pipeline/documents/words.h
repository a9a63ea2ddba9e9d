#pragma once

#include <initializer_list>
#include <utility>

namespace mien::pipeline {

/// Words of a document and what they mean.
template <class Enum>
using Words = std::initializer_list<std::pair<const char*, Enum>>;

}  // namespace mien::pipeline
