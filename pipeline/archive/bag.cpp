#include "pipeline/archive/bag.h"

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

/// A value of bag-info.txt is one line.
std::string as_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace

std::string bagit_text() {
  return "BagIt-Version: 1.0\n"
         "Tag-File-Character-Encoding: UTF-8\n";
}

std::string bag_info_text(const StudyContents& contents, const std::vector<PayloadFile>& payload) {
  std::uint64_t bytes = 0;
  for (const PayloadFile& file : payload) bytes += file.size;
  return fmt::format(
      "Bag-Software-Agent: mien {}\n"
      "External-Description: Human motion stimuli, made by: {}\n"
      "External-Identifier: {}\n"
      "Payload-Oxum: {}.{}\n",
      contents.program, as_line(contents.command), as_line(contents.study), bytes, payload.size());
}

std::string bag_manifest_line(const std::string& sha256, const std::string& path) {
  std::string line = sha256 + "  ";
  for (const char c : path) {
    if (c == '\n') {
      line += "%0A";
    } else if (c == '\r') {
      line += "%0D";
    } else if (c == '%') {
      line += "%25";
    } else {
      line += c;
    }
  }
  return line + "\n";
}

}  // namespace mien::pipeline
