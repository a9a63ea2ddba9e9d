#include "pipeline/production/archive/bag.h"

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

std::string element(const char* label, const std::string& value) {
  return value.empty() ? "" : fmt::format("{}: {}\n", label, as_line(value));
}

}  // namespace

std::string bagit_text() {
  return "BagIt-Version: 1.0\n"
         "Tag-File-Character-Encoding: UTF-8\n";
}

std::string bag_info_text(const StudyContents& contents, const std::vector<PayloadFile>& payload,
                          const BagInfo& info) {
  std::uint64_t bytes = 0;
  for (const PayloadFile& file : payload) bytes += file.size;
  const std::string made_by = "Human motion stimuli, made by: " + contents.command;
  return element("Bag-Software-Agent", "mien " + contents.program) +
         element("Contact-Email", info.contact_email) + element("Contact-Name", info.contact_name) +
         element("External-Description", info.description.empty() ? made_by : info.description) +
         element("External-Identifier", contents.study) + element("License", info.license) +
         element("Payload-Oxum", fmt::format("{}.{}", bytes, payload.size())) +
         element("Source-Organization", info.organization);
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
