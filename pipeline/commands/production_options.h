#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/production/production.h"

namespace CLI {
class App;
}

namespace mien::pipeline {

/// What `run` and `plan` take on the command line.
struct ProductionArguments {
  std::string manifest;
  std::string out = "out";
  std::vector<std::string> only;
  std::string quality;  ///< empty: as the manifest says
  int jobs = 0;         ///< 0: one a processor
  bool json = false;
};

void add_production_options(CLI::App& command, ProductionArguments& arguments);

int jobs_of(const ProductionArguments& arguments);
ProductionOptions options_of(const ProductionArguments& arguments);

/// out/<study>
std::filesystem::path folder_of(const ProductionArguments& arguments, const Manifest& manifest);

}  // namespace mien::pipeline
