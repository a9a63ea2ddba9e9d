// What faults do to a study that two processes make, and what they must not do.
//
//   mien_faults [--kills N] [--share X] [--seed S] [--only WORD]
//
// Kills, pauses, damages, swaps, forges, fills disks and sets clocks, at random; holds each study
// against one that was made undisturbed. Prints a table, and on standard error every defect that
// was found; ends with 1 when there was one. --share multiplies the numbers of all faults but the
// kills;
// --only takes the trials whose name has the word.

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iostream>
#include <string>

#include "faults/damage_trials.h"
#include "faults/disk_trials.h"
#include "faults/kills.h"

namespace {

using namespace mien::test;

struct Arguments {
  int kills = 200;
  double share = 1.0;
  std::uint64_t seed = 1;
  std::string only;
};

struct NamedTrial {
  std::string name;
  std::function<Figures(Trial&)> figures;
};

Arguments read_arguments(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    const std::string value = argv[i + 1];
    if (option == "--kills") arguments.kills = std::stoi(value);
    if (option == "--share") arguments.share = std::stod(value);
    if (option == "--seed") arguments.seed = std::stoull(value);
    if (option == "--only") arguments.only = value;
  }
  return arguments;
}

std::vector<NamedTrial> trials_for(const Arguments& arguments) {
  const auto some = [&](int count) {
    return std::max(1, static_cast<int>(count * arguments.share));
  };
  return {{"kills", [=](Trial& trial) { return random_kills(trial, arguments.kills); }},
          {"duplicates", [n = some(20)](Trial& trial) { return duplicated_workers(trial, n); }},
          {"pauses", [n = some(30)](Trial& trial) { return paused_workers(trial, n, false); }},
          {"silences", [n = some(3)](Trial& trial) { return paused_workers(trial, n, true); }},
          {"damages", [n = some(200)](Trial& trial) { return damaged_files(trial, n); }},
          {"workings", [n = some(60)](Trial& trial) { return damaged_work(trial, n); }},
          {"clocks", [n = some(20)](Trial& trial) { return set_clocks(trial, n); }},
          {"full", [n = some(30)](Trial& trial) { return full_disks(trial, n); }},
          {"while", [n = some(15)](Trial& trial) { return disks_full_for_a_while(trial, n); }},
          {"read-only", [n = some(20)](Trial& trial) { return read_only_stores(trial, n); }}};
}

void tell(const Figures& figures) {
  if (!figures.skipped.empty()) {
    std::printf("| %s | skipped: %s | | | |\n", figures.fault.c_str(), figures.skipped.c_str());
  } else {
    std::printf("| %s | %d | %d | %zu | %.0f |\n", figures.fault.c_str(), figures.faults,
                figures.studies, figures.complaints.size(), figures.seconds);
  }
  std::fflush(stdout);
  for (const std::string& complaint : figures.complaints) std::cerr << complaint << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = read_arguments(argc, argv);
  Trial trial(arguments.seed);
  std::printf("An undisturbed run takes %.1f s and leaves %zu files. Seed: %llu.\n\n",
              trial.duration(), trial.undisturbed().size(),
              static_cast<unsigned long long>(arguments.seed));
  std::printf("| fault | faults | studies compared | defects | seconds |\n|---|---|---|---|---|\n");
  bool is_sound = true;
  for (const NamedTrial& named : trials_for(arguments)) {
    if (named.name.find(arguments.only) == std::string::npos) continue;
    const double begin = seconds_now();
    Figures figures = named.figures(trial);
    figures.seconds = seconds_now() - begin;
    tell(figures);
    is_sound = is_sound && figures.complaints.empty();
  }
  return is_sound ? 0 : 1;
}
