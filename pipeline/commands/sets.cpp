#include <memory>
#include <string>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/commands/line/console.h"
#include "pipeline/manifest/look/set_file.h"

namespace mien::pipeline {

namespace {

int show_set(const std::string& name, const Console& console) {
  if (name.empty()) {
    for (const std::string& each : set_names()) console.out << each << '\n';
    return exit_done;
  }
  const std::string_view text = builtin_set_text(name);
  if (text.empty())
    throw Error("there is no set " + motion::in_quotes(name),
                motion::did_you_mean(name, set_names()));
  console.out << text;
  return exit_done;
}

}  // namespace

Command sets_command() {
  const auto name = std::make_shared<std::string>();
  return {.name = "sets",
          .summary = "List the built-in sets, or print one as a starting point",
          .options = {argument("name", name.get(), "Set to print").optional()},
          .notes =
              "Examples:\n  mien sets studio > my.set.yaml\n"
              "  mien render walk.bvh --scene my.set.yaml",
          .run = [name](const Console& console) { return show_set(*name, console); }};
}

}  // namespace mien::pipeline
