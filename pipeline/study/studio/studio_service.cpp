#include "pipeline/study/studio/studio_service.h"

#include <optional>
#include <utility>

#include "motion/error.h"
#include "motion/modify/posture.h"
#include "motion/text/as_number.h"
#include "motion/text/json_depth.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/look/set_file.h"
#include "pipeline/manifest/reading/recipes.h"
#include "pipeline/study/server/session_store.h"
#include "pipeline/study/studio/studio_guard.h"
#include "pipeline/study/studio/studio_places.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

/// Thrown for a body that the studio's page cannot have sent.
struct MalformedBody {};

HttpResponse faults_answer(const std::vector<Fault>& faults) {
  return http_value({{"error", "faults"}, {"faults", faults_json(faults)}}, 422);
}

ordered_json state_json(const ManifestState& state) {
  return {{"text", state.text}, {"version", state.version}, {"document", state.document}};
}

template <class Value>
Value member(const ordered_json& body, const char* name) {
  if (!body.is_object() || !body.contains(name)) throw MalformedBody{};
  try {
    return body[name].get<Value>();
  } catch (const nlohmann::json::exception&) {
    throw MalformedBody{};
  }
}

template <class Value>
Value member_or(const ordered_json& body, const char* name, Value usual) {
  return body.is_object() && body.contains(name) && !body[name].is_null()
             ? member<Value>(body, name)
             : usual;
}

std::optional<Quality> quality_in(const ordered_json& body) {
  const std::string name = member_or<std::string>(body, "quality", "");
  if (name.empty()) return std::nullopt;
  const auto quality = meaning_of(quality_words, name);
  return quality ? quality : throw MalformedBody{};
}

/// The built-in sets of examples, as the schema lists them.
ordered_json example_sets() {
  const auto set = nlohmann::json::json_pointer("/properties/examples/properties/set/oneOf");
  ordered_json sets = ordered_json::array();
  const nlohmann::json& schema = manifest_schema();
  for (const auto& branch : schema.at(set)) {
    if (!branch.contains("enum")) continue;
    for (const auto& name : branch["enum"]) sets.push_back(name.get<std::string>());
  }
  return sets;
}

ordered_json recipes_of(const ManifestFile& file) {
  const ManifestState state = file.state();
  const ManifestReading reading = parse_manifest(state.text, file.file(), file.environment());
  const RecipesSource& source = reading.manifest.recipes;
  ordered_json recipes = ordered_json::array();
  for (const Recipe& recipe : read_recipes(source.name, source.file).recipes)
    recipes.push_back({{"name", recipe.name}, {"ja", recipe.japanese}, {"note", recipe.note}});
  return recipes;
}

ordered_json posture() {
  ordered_json units = ordered_json::array();
  for (const motion::PostureUnitName& unit : motion::posture_units())
    units.push_back({{"name", unit.name}, {"note", unit.description}});
  return units;
}

/// The members of a step of a modification, from the schema.
ordered_json modification() {
  return ordered_json::parse(manifest_schema_text())
      .at("definitions")
      .at("modification")
      .at("properties");
}

/// The options of a page beside examples and sliders: "sets" of examples, "recipes" (of the
/// manifest, and what they do), "posture" (units and what they turn), "scenes", "cameras", "hands",
/// "figures" and, of these, "bodies", which have a surface.
ordered_json studio_options(const ManifestFile& file) {
  return {{"sets", example_sets()},
          {"recipes", recipes_of(file)},
          {"posture", posture()},
          {"modification", modification()},
          {"scenes", set_names()},
          {"cameras", {"three-quarter", "front", "side", "follow", "orbit"}},
          {"hands", {"auto", "drawn", "hidden"}},
          {"figures", scenes::figure_names<scenes::Figure>()},
          {"bodies", scenes::figure_names<scenes::BodyFigure>()}};
}

}  // namespace

StudioService::StudioService(ManifestFile& file, std::map<std::string, ServedFile> page,
                             const std::filesystem::path& out, int threads)
    : file_(file),
      page_(std::move(page)),
      reader_(file.file(), file.environment()),
      motions_(reader_),
      jobs_(out, threads),
      link_(random_link()) {}

HttpResponse StudioService::answer(const HttpRequest& request) {
  if (std::optional<HttpResponse> refusal = cross_site_refusal(request, port_)) return *refusal;
  if (request.path.size() < 2 || !same_secret(request.path[0], link_)) return unknown(request);
  if (request.method == "GET" || request.method == "HEAD") return read(request);
  if (request.method == "POST") return take(request);
  return http_method_not_allowed("GET, HEAD, POST");
}

/// Many requests for unknown links suggest guessing, and are limited.
HttpResponse StudioService::unknown(const HttpRequest& request) {
  if (!wrong_rate_.allows(request.address)) return http_too_many_requests();
  return http_refusal(404, "unknown", "page not found", "use the link as printed");
}

HttpResponse StudioService::read(const HttpRequest& request) {
  if (request.path[1] == "jobs") return job(request);
  if (request.path.size() > 2) return unknown(request);
  const std::string& name = request.path[1];
  if (name == "studio.json") return studio_json();
  const auto file = page_.find(name.empty() ? "index.html" : name);
  if (file == page_.end()) return unknown(request);
  return {.type = file->second.type,
          .body = file->second.bytes,
          .webassembly = file->second.webassembly};
}

HttpResponse StudioService::take(const HttpRequest& request) {
  const bool is_cancel =
      request.path.size() == 4 && request.path[1] == "jobs" && request.path[3] == "cancel";
  if (request.path.size() != 2 && !is_cancel) return unknown(request);
  if (!is_json(request))
    return http_refusal(415, "type", "this is not JSON", "send Content-Type: application/json");
  const bool is_deep = motion::is_nested_deeper(request.body, motion::max_json_depth);
  const Body body =
      is_deep ? Body(Body::value_t::discarded) : Body::parse(request.body, nullptr, false);
  if (body.is_discarded())
    return http_refusal(400, "malformed", "this is not JSON", "load the page again");
  try {
    if (!is_cancel) return answer_post(request.path[1], body);
    jobs_.cancel();
    return http_value({{"cancelled", true}});
  } catch (const MalformedBody&) {
    return http_refusal(400, "malformed", "this is not an expected request", "load the page again");
  } catch (const DraftFaults& faults) {
    return faults_answer(faults.list());
  } catch (const Faults& faults) {
    return faults_answer(faults.list());
  } catch (const Error& error) {
    return faults_answer({{{}, "", error.what(), ""}});
  } catch (const WriteFailure& failure) {
    return http_refusal(507, "full", failure.what(), "save it again in a while");
  }
}

/// The document of a request, after the check of its file names, without which none is used.
StudioService::Body StudioService::document_in(const Body& body) const {
  Body document = member<Body>(body, "document");
  if (!document.is_object()) throw MalformedBody{};
  reader_.check_files(document, file_.state().document);
  return document;
}

HttpResponse StudioService::answer_post(const std::string& what, const Body& body) {
  if (what == "motion") return motion(body);
  if (what == "choices") return http_value(motions_.choices(document_in(body)));
  if (what == "figure") return figure(body);
  if (what == "places")
    return http_value(StudioPlaces(file_.file(), file_.state().document).listing());
  if (what == "save") return save(body);
  if (what == "reload") return http_value(state_json(file_.reload()));
  if (what == "jobs") return begin_job(body);
  return http_refusal(404, "unknown", "page not found", "load the page again");
}

HttpResponse StudioService::studio_json() {
  const ManifestState state = file_.state();
  Body studio = {{"file", file_.file().filename().string()},
                 {"place", std::filesystem::absolute(file_.file()).string()},
                 {"is_on_disk", file_.is_on_disk()},
                 {"manifest", state_json(state)},
                 {"walker", page_.contains(walker_page)},
                 {"job", jobs_.last()},
                 {"words", studio_options(file_)}};
  return http_value(studio);
}

HttpResponse StudioService::motion(const Body& body) {
  return {.type = "application/octet-stream",
          .body = motions_.motion(document_in(body), member<std::string>(body, "show"),
                                  member_or<std::string>(body, "against", ""))};
}

HttpResponse StudioService::figure(const Body& body) {
  std::string file = motions_.figure(document_in(body), member<std::string>(body, "show"),
                                     member<std::string>(body, "key"));
  if (file.empty())
    return http_refusal(404, "unknown", "there is no such figure", "ask for the motion again");
  return {.type = "model/gltf-binary", .body = std::move(file)};
}

HttpResponse StudioService::save(const Body& body) {
  const SaveResult result = file_.save(member<std::string>(body, "text"), document_in(body),
                                       member<std::string>(body, "version"));
  Body status = state_json(result.state);
  if (result.outcome != SaveResult::Outcome::elsewhere) {
    status["saved"] = result.outcome == SaveResult::Outcome::saved;
    return http_value(status);
  }
  return http_value(
      {{"error", "elsewhere"},
       {"wrong", file_.file().filename().string() + " has been changed since it was opened"},
       {"remedy",
        "reload it and lose the changes made here, or overwrite it with the changes made here"},
       {"manifest", status}},
      409);
}

HttpResponse StudioService::begin_job(const Body& body) {
  const std::string kind = member<std::string>(body, "kind"),
                    id = member<std::string>(body, "stimulus");
  if (kind != "still" && kind != "video") throw MalformedBody{};
  Manifest manifest = reader_.read(document_excerpt(document_in(body), {id}));
  if (find_stimulus(manifest, id) == nullptr) throw MalformedBody{};
  const std::optional<int> number =
      jobs_.begin({.kind = kind == "still" ? StudioJob::Kind::still : StudioJob::Kind::video,
                   .manifest = std::move(manifest),
                   .stimulus = id,
                   .seconds = member_or<double>(body, "seconds", 0.0),
                   .quality = quality_in(body)});
  if (!number)
    return http_refusal(409, "busy", "another still or video is being rendered",
                        "wait for it, or stop it");
  return http_value(jobs_.status(*number));
}

HttpResponse StudioService::job(const HttpRequest& request) {
  const std::optional<int> number =
      request.path.size() > 2 ? motion::as_number<int>(request.path[2]) : std::nullopt;
  if (!number) return unknown(request);
  if (request.path.size() == 3) {
    const Body status = jobs_.status(*number);
    return status.is_null() ? unknown(request) : http_value(status);
  }
  const bool is_result = request.path.size() == 4 && request.path[3] == "result";
  const auto made = is_result ? jobs_.result(*number) : std::nullopt;
  if (!made) return unknown(request);
  return http_file(request, *made, made->extension() == ".png" ? "image/png" : "video/mp4");
}

}  // namespace mien::pipeline
