#include "pipeline/study/questionnaire/experiment/jatos_archive.h"

#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

ordered_json component_json(const JatosStudy& study) {
  return {{"uuid", named_uuid(study.key + "/component")},
          {"title", study.title},
          {"htmlFilePath", "index.html"},
          {"reloadable", true},
          {"active", true},
          {"comments", ""},
          {"jsonData", nullptr}};
}

/// A batch that allows all worker types of JATOS except those of Mechanical Turk.
ordered_json batch_json(const JatosStudy& study) {
  return {{"uuid", named_uuid(study.key + "/batch")},
          {"title", "Default"},
          {"active", true},
          {"maxActiveMembers", nullptr},
          {"maxTotalMembers", nullptr},
          {"maxTotalWorkers", nullptr},
          {"allowedWorkerTypes",
           {"PersonalSingle", "PersonalMultiple", "GeneralSingle", "GeneralMultiple", "Jatos"}},
          {"comments", nullptr},
          {"jsonData", nullptr}};
}

ordered_json study_json(const JatosStudy& study) {
  return {{"version", "3"},
          {"data",
           {{"uuid", named_uuid(study.key)},
            {"title", study.title},
            {"description", study.description},
            {"active", true},
            {"groupStudy", false},
            {"linearStudy", false},
            {"allowPreview", false},
            {"dirName", study.folder},
            {"comments", ""},
            {"jsonData", nullptr},
            {"endRedirectUrl", ""},
            {"studyEntryMsg", nullptr},
            {"componentList", ordered_json::array({component_json(study)})},
            {"batchList", ordered_json::array({batch_json(study)})}}}};
}

/// A text with one piece of it replaced; the piece must be there.
std::string with(std::string text, std::string_view piece, std::string_view other) {
  const std::size_t at = text.find(piece);
  if (at == text.npos)
    throw std::logic_error(fmt::format("the page has no \"{}\" to replace", piece));
  return text.replace(at, piece.size(), other);
}

}  // namespace

std::string jatos_page(std::string page, const std::string& script) {
  const std::size_t policy = page.find("<meta http-equiv=\"Content-Security-Policy\"");
  if (policy != page.npos) page.erase(policy, page.find('\n', policy) + 1 - policy);
  page = with(std::move(page), "content=\"static\"", "content=\"jatos\"");
  const std::string own = "<script src=\"" + script + "\"";
  return with(std::move(page), own, "<script src=\"jatos.js\"></script>\n" + own);
}

std::string named_uuid(const std::string& name) {
  std::string digits = hash_of("mien/" + name);
  digits[12] = '8';
  constexpr std::string_view variants = "89ab";
  digits[16] = variants[static_cast<unsigned char>(digits[16]) % variants.size()];
  for (const std::size_t place : {8U, 13U, 18U, 23U}) digits.insert(place, "-");
  return digits;
}

std::string jatos_archive(const JatosStudy& study, const ZipFiles& assets) {
  ZipFiles files;
  files[study.folder + ".jas"] = study_json(study).dump(2) + "\n";
  for (const auto& [path, bytes] : assets) files[study.folder + "/" + path] = bytes;
  return zip_of(files);
}

}  // namespace mien::pipeline
