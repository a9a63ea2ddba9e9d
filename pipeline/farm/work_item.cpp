#include "pipeline/farm/work_item.h"

#include <regex>

#include "motion/error.h"
#include "motion/text/excerpt.h"

namespace mien::pipeline {

std::string chunk_item(const std::string& task, int chunk, int chunks) {
  return task + "[" + std::to_string(chunk) + "/" + std::to_string(chunks) + "]";
}

WorkItem work_item(const std::string& text) {
  static const std::regex form(R"(([^\s\[\]]+)(\[([1-9]\d{0,6})/([1-9]\d{0,6})\])?)");
  std::smatch parts;
  if (std::regex_match(text, parts, form)) {
    if (!parts[2].matched) return {parts[1], 0, 0};
    WorkItem item{parts[1], std::stoi(parts[3]), std::stoi(parts[4])};
    if (item.chunk <= item.chunks) return item;
    throw Error(motion::in_quotes(text) + ": of " + parts[4].str() +
                    " parts there is none with the number " + parts[3].str(),
                "they are " + chunk_item(item.task, 1, item.chunks) + " to " +
                    chunk_item(item.task, item.chunks, item.chunks));
  }
  throw Error(motion::in_quotes(text) + " is not a work item",
              "write a task listed by mien plan, such as film:walk, or a chunk of a film's frames, "
              "such as film:walk[3/12]");
}

}  // namespace mien::pipeline
