#pragma once

#include <atomic>
#include <filesystem>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "pipeline/study/page/served_page.h"
#include "pipeline/study/server/http_message.h"
#include "pipeline/study/server/rate_limit.h"
#include "pipeline/study/studio/manifest_file.h"
#include "pipeline/study/studio/studio_draft.h"
#include "pipeline/study/studio/studio_jobs.h"
#include "pipeline/study/studio/studio_motions.h"

namespace mien::pipeline {

/// File name of the walker's page, if the studio has one.
inline constexpr char walker_page[] = "walk.html";

/// Handles the requests to the studio, whose link is secret:
///
///     GET  /<link>/                the page and its files
///     GET  /<link>/walk.html       the walker's page, if the live core is compiled for browsers
///     GET  /<link>/studio.json     the manifest and the available options (studio_options)
///     POST /<link>/choices         {"document"}: its examples and sliders
///     POST /<link>/motion          {"document", "show", "against"}: a motion (studio_motions.h)
///     POST /<link>/figure          {"document", "show", "key"}: the figure of a motion as GLB
///     POST /<link>/places          folders of captures, and characters (studio_places.h)
///     POST /<link>/save            {"document", "text", "version"}: saves (manifest_file.h)
///     POST /<link>/reload          reads the manifest file again
///     POST /<link>/jobs            {"document", "kind", "stimulus", "seconds", "quality"}:
///                                  starts rendering a still or a video
///     GET  /<link>/jobs/<n>        status of a job
///     POST /<link>/jobs/<n>/cancel cancels the running job, regardless of <n>
///     GET  /<link>/jobs/<n>/result the still or video
///
/// Request bodies are JSON. For an invalid document, the response has status 422 and the body
/// {"error": "faults", "faults": [{"path", "wrong", "remedy"}]}. File names in documents are
/// checked (DraftReader). Thread-safe.
class StudioService {
 public:
  /// `file` must outlive this object. `page`: the files served to browsers. `out`: folder for
  /// stills and videos. `threads`: number of rendering threads.
  StudioService(ManifestFile& file, std::map<std::string, ServedFile> page,
                const std::filesystem::path& out, int threads);

  /// The secret part of the link.
  const std::string& link() const { return link_; }

  /// Sets the port of the server, against which requests are checked. Before that, all are refused.
  void set_port(int port) { port_ = port; }

  HttpResponse answer(const HttpRequest& request);

 private:
  using Body = nlohmann::ordered_json;

  HttpResponse unknown(const HttpRequest& request);
  HttpResponse read(const HttpRequest& request);
  HttpResponse take(const HttpRequest& request);
  HttpResponse answer_post(const std::string& what, const Body& body);
  Body document_in(const Body& body) const;
  HttpResponse studio_json();
  HttpResponse motion(const Body& body);
  HttpResponse figure(const Body& body);
  HttpResponse save(const Body& body);
  HttpResponse begin_job(const Body& body);
  HttpResponse job(const HttpRequest& request);

  ManifestFile& file_;
  std::map<std::string, ServedFile> page_;
  DraftReader reader_;
  StudioMotions motions_;
  StudioJobs jobs_;
  std::string link_;
  std::atomic<int> port_ = 0;
  RateLimit wrong_rate_{{.burst = 60, .per_second = 0.5}};
};

}  // namespace mien::pipeline
