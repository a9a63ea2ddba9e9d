#pragma once

#include <exception>
#include <string>

namespace mien::pipeline {

/// What a failure says to people: its own words, or that the memory does not suffice and what
/// helps.
std::string failure_text(const std::exception& failure);

}  // namespace mien::pipeline
