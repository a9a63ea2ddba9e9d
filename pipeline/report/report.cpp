#include "pipeline/report/report.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "motion/interpolation/interpolation_options.h"
#include "motion/measures/distance.h"
#include "pipeline/report/feature_changes.h"
#include "pipeline/report/lint_timeline.h"
#include "pipeline/report/report_ratings.h"
#include "pipeline/report/report_style.h"
#include "pipeline/sheets/sheet.h"
#include "pipeline/synthesis/modified_motion.h"
#include "pipeline/synthesis/parameter_label.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

constexpr int most_weights = 6;

std::string role_name(Role role) {
  if (role == Role::target) return "target";
  return role == Role::created ? "created" : "reference";
}

std::string parameter_rows(const Stimulus& stimulus, const Synthesis& made, Motions& motions) {
  std::string rows;
  for (std::size_t i = 0; i < made.asked.size(); ++i) {
    const auto& [id, asked] = made.asked[i];
    const ParameterLabel label = label_of(id, stimulus, motions.repertoire());
    const std::string name = english_text(label) + " " + japanese_text(label);
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"bar\"><meter min=\"0\" max=\"1\" "
        "value=\"{:.3f}\"></meter></td><td>{:.2f}</td><td>{:.2f}</td></tr>\n",
        html_escaped(name), asked, asked, made.reached[i].second);
  }
  if (rows.empty()) return rows;
  return "<table><thead><tr><th>parameter</th><th></th><th>asked</th><th>reached</th></tr></"
         "thead>\n"
         "<tbody>" +
         rows + "</tbody></table>\n";
}

std::string weight_rows(const Synthesis& made, Motions& motions) {
  if (made.weights.size() == 0) return "";
  std::vector<std::pair<double, std::string>> weights;
  for (Eigen::Index i = 0; i < made.weights.size(); ++i) {
    weights.emplace_back(made.weights[i],
                         motions.repertoire().names[static_cast<std::size_t>(i)].name);
  }
  std::stable_sort(weights.begin(), weights.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string rows;
  int shown = 0;
  for (const auto& [weight, name] : weights) {
    if (weight < 0.005 || shown++ == most_weights) break;
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"bar\"><meter min=\"0\" max=\"1\" "
        "value=\"{:.3f}\"></meter></td><td>{:.2f}</td></tr>\n",
        html_escaped(name), weight, weight);
  }
  return "<table><thead><tr><th>example</th><th></th><th>weight</th></tr></thead>\n<tbody>" + rows +
         "</tbody></table>\n";
}

std::string warning_list(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return "";
  std::string list = "<ul class=\"warnings\">\n";
  for (const std::string& warning : warnings) {
    list += "<li>" + html_escaped(warning) + "</li>\n";
  }
  return list + "</ul>\n";
}

/// A vector drawing as part of the page. Pictures of their own, since glyphs of drawings in one
/// page would share their names.
std::string drawing(const Plot& plot, const std::string& alternative) {
  std::string encoded;
  for (const char c : as_svg(plot)) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                          std::string_view(" .,-_:;/=()").find(c) != std::string_view::npos;
    if (is_plain) {
      encoded += c;
    } else {
      encoded += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return fmt::format("<img loading=\"lazy\" src=\"data:image/svg+xml,{}\" alt=\"{}\">\n", encoded,
                     html_escaped(alternative));
}

/// Errors openly, warnings folded away with the picture of all over time.
std::string finding_list(const Synthesis& made) {
  const motion::Clip& clip = made.motion.clip;
  std::string errors, warnings;
  for (const motion::Finding& f : made.findings) {
    const bool is_error = f.severity == motion::Severity::error;
    (is_error ? errors : warnings) +=
        fmt::format("<li><b>{}</b> {:.2f}–{:.2f} s: {}</li>\n", html_escaped(f.check),
                    f.first / clip.frames_per_second, f.last / clip.frames_per_second,
                    html_escaped(f.sentence));
  }
  if (made.findings.empty()) return "";
  if (!errors.empty()) errors = "<ul class=\"errors\">\n" + errors + "</ul>\n";
  const LintedMotion linted{made.motion.name,       clip.frame_count(), clip.frames_per_second,
                            !made.modified.empty(), made.findings,      clip.loops};
  const std::string title = made.findings.size() == 1
                                ? "Lint: 1 finding"
                                : fmt::format("Lint: {} findings", made.findings.size());
  return errors + "<details><summary>" + title + "</summary>\n" +
         drawing(lint_timeline(linted), "Findings over time") + "<ul>\n" + warnings +
         "</ul></details>\n";
}

std::string facts_of(const Stimulus& stimulus, const Synthesis& made) {
  const motion::Clip& clip = made.motion.clip;
  const auto [width, height] = stimulus.output.shown_size();
  std::string facts = fmt::format("{} × {}, {} frames/s", width, height, stimulus.output.fps);
  if (clip.loops) {
    facts += fmt::format(", cycle {:.2f} s, stride {:.2f} m, {:.2f} m/s", clip.duration_seconds(),
                         clip.cycle_displacement.norm(),
                         clip.cycle_displacement.norm() / clip.duration_seconds());
  }
  if (!stimulus.clip && stimulus.weights.empty()) {
    facts +=
        fmt::format(", {} interpolation", motion::name_of(stimulus.interpolation.weights.method));
  }
  if (made.expected_error_m) {
    facts += fmt::format(", joints expected within {:.0f} mm", 1000.0 * *made.expected_error_m);
  }
  return facts +
         fmt::format(", planted feet move {:.1f} mm at most", 1000.0 * made.planted_drift_m);
}

/// Kinds that browsers play in a <video>, the best known first.
constexpr render::VideoKind playable[] = {render::VideoKind::mp4, render::VideoKind::webm,
                                          render::VideoKind::webm_av1};

/// The video that a browser can show, if any, and links to all when there are several.
std::string video_of(const Stimulus& stimulus) {
  const std::vector<render::VideoKind>& kinds = stimulus.output.video;
  const auto [width, height] = stimulus.output.shown_size();
  const auto link = [&](render::VideoKind kind) {
    return "videos/" + html_escaped(render::with_ending(stimulus.id, kind).string());
  };
  const auto is_made = [&](render::VideoKind kind) {
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
  };
  std::string html;
  const auto plays = std::find_if(std::begin(playable), std::end(playable), is_made);
  const auto moves = std::find_if(kinds.begin(), kinds.end(), [](render::VideoKind kind) {
    return render::traits_of(kind).picture;
  });
  if (plays != std::end(playable)) {
    html = fmt::format(
        "<video controls loop muted playsinline preload=\"metadata\" width=\"{}\" height=\"{}\" "
        "src=\"{}\"></video>\n",
        width, height, link(*plays));
  } else if (moves != kinds.end()) {
    html = fmt::format("<img loading=\"lazy\" width=\"{}\" height=\"{}\" src=\"{}\" alt=\"{}\">\n",
                       width, height, link(*moves), html_escaped(stimulus.id));
  }
  if (kinds.size() < 2 && !html.empty()) return html;
  std::string links;
  for (const render::VideoKind kind : kinds) {
    links += fmt::format("{}<a href=\"{}\">{}</a>", links.empty() ? "" : ", ", link(kind),
                         render::traits_of(kind).name);
  }
  return links.empty() ? html : html + "<p>" + links + "</p>\n";
}

/// The frames of a film at a glance.
std::string contact_sheet(const std::string& id) {
  return fmt::format(
      "<a href=\"sheets/contact/{}.png\"><img loading=\"lazy\" src=\"sheets/contact/{}.png\" "
      "alt=\"Twelve frames of {}\"></a>\n",
      id, id, id);
}

std::string overlay_card(const Overlay& overlay, const Manifest& manifest) {
  const std::string id = html_escaped(overlay.film.id);
  std::string card = fmt::format("<article id=\"{}\">\n<h3>{}</h3>\n", id, id);
  card += video_of(overlay.film) + contact_sheet(id);
  std::string legend;
  for (const auto& [role, motion] : motions_on(overlay)) {
    std::string name = html_escaped(motion);
    if (find_stimulus(manifest, motion)) name = fmt::format("<a href=\"#{}\">{}</a>", name, name);
    legend += fmt::format("{}{} ({})", legend.empty() ? "" : ", ", name, role_name(role));
  }
  return card + "<p>" + legend + "</p>\n</article>\n";
}

std::string stimulus_card(const Stimulus& stimulus, Motions& motions) {
  const Synthesis& made = motions.of(stimulus.id);
  const std::string id = html_escaped(stimulus.id);
  std::string card =
      fmt::format("<article class=\"{}\" id=\"{}\">\n<h3>{} <small>{}</small></h3>\n",
                  role_name(stimulus.role), id, id, role_name(stimulus.role));
  card += video_of(stimulus) + contact_sheet(id);
  card += fmt::format("<p>{}.</p>\n", html_escaped(facts_of(stimulus, made)));
  if (!made.modified.empty()) {
    std::string sentence = "Modified: " + made.modified + share_text(made.modified_share);
    for (const std::string& note : made.notes) sentence += "; " + note;
    card += fmt::format("<p>{}.</p>\n", html_escaped(sentence));
  }
  return card + warning_list(made.warnings) + finding_list(made) +
         parameter_rows(stimulus, made, motions) + weight_rows(made, motions) + "</article>\n";
}

std::string sheet_card(const Sheet& sheet, Motions& motions) {
  const std::string id = html_escaped(sheet.id);
  std::string alternative = fmt::format("{} motions side by side", sheet.gallery.size());
  if (!sheet.stills.empty()) {
    alternative = fmt::format("{}: a picture of each of {} stimuli", id, sheet.stills.size());
  }
  std::string caption = alternative;
  if (sheet.gallery.empty() && sheet.stills.empty()) {
    alternative = fmt::format("Comparison sheet of {} and {}", html_escaped(sheet.target),
                              html_escaped(sheet.created));
    caption = html_escaped(verdict(
        motion::distance(motions.of(sheet.target).motion, motions.of(sheet.created).motion)));
  }
  return fmt::format(
      "<figure>\n<a href=\"sheets/{0}.pdf\"><img loading=\"lazy\" src=\"sheets/{0}.png\" "
      "alt=\"{1}\"></a>\n<figcaption>{2} (<a href=\"sheets/{0}.pdf\">PDF</a>)</figcaption>\n"
      "</figure>\n",
      id, alternative, caption);
}

std::string distance_table(const Manifest& manifest, Motions& motions) {
  std::string rows;
  for (const Sheet& sheet : manifest.sheets) {
    for (const auto& [target, created] : pairs_on(sheet)) {
      const motion::Distance d =
          motion::distance(motions.of(target).motion, motions.of(created).motion);
      rows += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{}</td><td>{:.4f}</td><td>{:.3f}</td><td>{:.4f}</td>"
          "<td>{}</td></tr>\n",
          html_escaped(target), html_escaped(created), d.mean, d.sum, d.mpjpe,
          d.matches() ? "yes" : "no");
    }
  }
  return "<table><thead><tr><th>target</th><th>created</th><th>D (m)</th><th>sum (m)</th>"
         "<th>MPJPE (m)</th><th>D &lt; 0.06 m</th></tr></thead>\n<tbody>" +
         rows + "</tbody></table>\n";
}

/// Of comparisons with a reference: how many features went the target's way.
std::string feature_agreement(const Manifest& manifest, Motions& motions) {
  std::string rows;
  for (const Sheet& sheet : manifest.sheets) {
    const std::vector<motion::FeatureChange> changes = feature_changes(sheet, motions);
    const auto moved =
        std::count_if(changes.begin(), changes.end(),
                      [](const motion::FeatureChange& change) { return change.moved(); });
    const auto agree =
        std::count_if(changes.begin(), changes.end(),
                      [](const motion::FeatureChange& change) { return change.agrees(); });
    if (moved == 0) continue;
    rows += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        html_escaped(sheet.target), html_escaped(sheet.created), moved, agree);
  }
  if (rows.empty()) return rows;
  return "<table><thead><tr><th>target</th><th>created</th><th>features that the target moved "
         "from the reference</th><th>moved the same way</th></tr></thead>\n<tbody>" +
         rows + "</tbody></table>\n";
}

bool rests_on_simulated_ratings(const Manifest& manifest, Motions& motions) {
  const bool any = std::any_of(manifest.stimuli.begin(), manifest.stimuli.end(),
                               [](const Stimulus& s) { return !s.adjectives.empty(); });
  return any && motions.repertoire().simulated_ratings;
}

/// What the films of a study have in common because it asks for that.
std::string alike(const Equalize& equalize) {
  std::vector<std::string> what;
  if (equalize.duration) what.emplace_back("length (as the shortest)");
  if (equalize.size) {
    what.emplace_back(
        "height of the standing figure in pixels (as the smallest: "
        "<a href=\"metrics/sizes.csv\">sizes.csv</a>)");
  }
  if (equalize.luminance) {
    what.emplace_back(
        "mean luminance (by exposure: <a href=\"metrics/exposure.csv\">exposure.csv</a>)");
  }
  return what.empty()
             ? ""
             : fmt::format("<p>Made alike in all stimuli: {}.</p>\n", fmt::join(what, ", "));
}

std::string footer(const Manifest& manifest) {
  return fmt::format(
      "<footer><p>mien {} · seed {} · manifest {} · numbers in <a href=\"metrics/\">metrics/</a> · "
      "hashes of all inputs and artifacts in <a href=\"provenance.json\">provenance.json</a></p>"
      "</footer>\n",
      program_version(), manifest.seed, html_escaped(manifest.file.filename().string()));
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string report(const Manifest& manifest, Motions& motions) {
  const std::string study = html_escaped(manifest.study);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{} · mien</title>\n<style>\n{}</style>\n</head>\n<body>\n<header><h1>{}</h1>\n",
      study, report_style, study);
  if (rests_on_simulated_ratings(manifest, motions)) {
    page +=
        "<p class=\"simulated\"><strong>Simulated ratings.</strong> No person has rated the "
        "example motions: what is shown for an adjective is what made-up raters would say.</p>\n";
  }
  page += "</header>\n<main>\n";
  if (blends_examples(manifest)) page += warning_list(motions.repertoire().warnings);
  page += "<section><h2>Stimuli</h2>\n" + alike(manifest.equalize) + "<div class=\"cards\">\n";
  for (const Stimulus& stimulus : manifest.stimuli) page += stimulus_card(stimulus, motions);
  page += "</div></section>\n";
  if (!manifest.overlays.empty()) {
    page += "<section><h2>Overlays</h2>\n<div class=\"cards\">\n";
    for (const Overlay& overlay : manifest.overlays) page += overlay_card(overlay, manifest);
    page += "</div></section>\n";
  }
  std::string stills;
  std::string comparisons;
  for (const Sheet& sheet : manifest.sheets) {
    (sheet.stills.empty() ? comparisons : stills) += sheet_card(sheet, motions);
  }
  if (!stills.empty()) page += "<section><h2>Pictures</h2>\n" + stills + "</section>\n";
  if (!comparisons.empty()) {
    page += "<section><h2>Comparisons</h2>\n" + distance_table(manifest, motions) +
            feature_agreement(manifest, motions) + comparisons + "</section>\n";
  }
  if (blends_examples(manifest)) page += ratings_section(manifest, motions.repertoire());
  return page + "</main>\n" + footer(manifest) + "</body>\n</html>\n";
}

}  // namespace mien::pipeline
