#pragma once

#include "motion/interpolation/parameter_table.h"

namespace mien::pipeline {

using motion::parameter_row;
using motion::ParameterTable;
using motion::places_of_examples;

}  // namespace mien::pipeline
