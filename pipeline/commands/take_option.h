#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "motion/formats/motion_file.h"

namespace mien::pipeline {

/// `--take`: which motion of a file that holds several.
inline void add_take_option(CLI::App& command, std::string& take) {
  command.add_option("--take", take,
                     "Of a glTF file with several motions: which (mien motion info lists them)");
}

/// The motion of a file; the first of several where no take is named.
inline motion::Recording read_take(const std::string& file, const std::string& take) {
  return motion::read_motion(file, take.empty() ? std::nullopt : std::optional(take));
}

}  // namespace mien::pipeline
