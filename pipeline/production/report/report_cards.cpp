#include "pipeline/production/report/report_cards.h"

#include <algorithm>

#include <fmt/format.h>

#include "motion/interpolation/interpolation_options.h"
#include "motion/measures/distance/distance.h"
#include "pipeline/base/documents/html.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film_dots.h"
#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_waveform.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/report/lint_timeline.h"
#include "pipeline/production/report/report_parts.h"
#include "pipeline/production/report/report_tables.h"
#include "pipeline/production/sheets/sheet.h"
#include "pipeline/production/synthesis/modified_motion.h"
#include "scenes/figures/figure_colour.h"

namespace mien::pipeline {

namespace {

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
                            !made.modified.empty(), made.findings,      clip.loops,
                            made.fit.has_value()};
  const std::string title = made.findings.size() == 1
                                ? "Lint: 1 finding"
                                : fmt::format("Lint: {} findings", made.findings.size());
  return errors + "<details><summary>" + title + "</summary>\n" +
         embedded_svg(as_svg(lint_timeline(linted)), "Findings over time") + "<ul>\n" + warnings +
         "</ul></details>\n";
}

std::string facts_of(const Stimulus& stimulus, const Synthesis& made) {
  const motion::Clip& clip = made.motion.clip;
  const auto [width, height] = stimulus.output.shown_size();
  std::string facts = fmt::format("{} × {}, {} frames/s, {} quality", width, height,
                                  stimulus.output.fps, name_of(stimulus.output.quality));
  if (clip.loops) {
    facts += fmt::format(", cycle {:.2f} s, stride {:.2f} m, {:.2f} m/s", clip.duration_seconds(),
                         clip.cycle_displacement.norm(),
                         clip.cycle_displacement.norm() / clip.duration_seconds());
  }
  if (is_blend(stimulus) && stimulus.weights.empty()) {
    facts += fmt::format(", interpolation method: {}",
                         motion::name_of(stimulus.interpolation.weights.method));
  }
  if (made.expected_error_m) {
    facts += fmt::format(", expected joint error {:.0f} mm", 1000.0 * *made.expected_error_m);
  }
  const double slide_mm = 1000.0 * made.planted_drift_m;
  return facts + ", planted feet slide by " +
         (slide_mm < 0.05 ? "less than 0.05 mm" : fmt::format("at most {:.1f} mm", slide_mm));
}

std::string folded(const std::string& title, const std::string& html) {
  return html.empty() ? "" : "<details><summary>" + title + "</summary>\n" + html + "</details>\n";
}

/// Where a player stands before it plays: at a frame of the film, not at the card, the cross, the
/// blank or the fade before it. Empty where the film comes first.
std::string still_of(const Output& output) {
  const PresentationFrames frames = frames_of(output.presentation, output.fps, 1'000'000);
  const int first = frames.before() + std::max(0, frames.fade_in - 1);
  return first == 0 ? "" : fmt::format("#t={:.3f}", (first + 0.5) / output.fps);
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
        "<video controls {} playsinline preload=\"metadata\" width=\"{}\" height=\"{}\" "
        "src=\"{}{}\"></video>\n",
        stimulus.sound ? "" : "loop muted", width, height, link(*plays), still_of(stimulus.output));
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

/// The waveform of a stimulus's sound, and where it comes from.
std::string sound_of_card(const Stimulus& stimulus) {
  if (!stimulus.sound || stimulus.output.video.empty()) return "";
  const StimulusSound& sound = *stimulus.sound;
  const std::string id = html_escaped(stimulus.id);
  std::string source = html_escaped(sound.file.filename().string());
  if (sound.of != stimulus.id) source += ", the sound of " + html_escaped(sound.of);
  if (sound.offset != 0.0) source += fmt::format(", offset {:g} s", sound.offset);
  return fmt::format(
      "<img loading=\"lazy\" src=\"{}\" alt=\"Waveform of the sound of {}\">\n<p>Sound: {}.</p>\n",
      html_escaped(waveform_path(stimulus.id)), id, source);
}

/// The frames of a film at a glance.
std::string contact_sheet(const std::string& id) {
  return fmt::format(
      "<a href=\"sheets/contact/{}.png\"><img loading=\"lazy\" src=\"sheets/contact/{}.png\" "
      "alt=\"Twelve frames of {}\"></a>\n",
      id, id, id);
}

std::string warnings_of_film(const Stimulus& film, const FilmWarnings& films) {
  const auto found = films.find(film.id);
  return found == films.end() ? "" : html_list("warnings", found->second);
}

/// How a motion was made, and what is remarkable about it.
std::string motion_part(const Stimulus& stimulus, Motions& motions, NameLanguage language) {
  const Synthesis& made = motions.of(stimulus.id);
  std::string part = fmt::format("<p>{}.</p>\n", html_escaped(facts_of(stimulus, made)));
  if (const std::string markers = marker_facts(stimulus, motions); !markers.empty())
    part += fmt::format("<p>Shown: {}.</p>\n", html_escaped(markers));
  if (!made.modified.empty()) {
    std::string sentence = "Modified: " + made.modified + share_text(made.modified_share);
    for (const std::string& note : made.notes) sentence += "; " + note;
    part += fmt::format("<p>{}.</p>\n", html_escaped(sentence));
  } else if (!made.notes.empty()) {
    part += fmt::format("<p>Note: {}.</p>\n",
                        html_escaped(fmt::format("{}", fmt::join(made.notes, "; "))));
  }
  return part + html_list("warnings", made.warnings) + finding_list(made) +
         parameter_table(stimulus, made, motions, language) +
         (stimulus.weights.empty() ? folded("Weights of the examples", weight_table(made, motions))
                                   : weight_table(made, motions)) +
         other_parameters(stimulus, made, motions, language);
}

/// The people of a stimulus, each with its motion.
std::string people_part(const Stimulus& stimulus, Motions& motions, NameLanguage language) {
  std::string part;
  for (std::size_t i = 0; i < stimulus.people.size(); ++i) {
    const Person& person = stimulus.people[i];
    const std::string colour =
        person.colour.empty() ? std::string(scenes::person_colour(i)) : person.colour;
    part += fmt::format("<h4 id=\"{}\"><span style=\"color:{}\">●</span> {}</h4>\n<p>{}.</p>\n",
                        html_escaped(person.motion.id), html_escaped(colour),
                        html_escaped(person.motion.id), html_escaped(person_facts(person)));
    part += motion_part(person.motion, motions, language);
  }
  return part;
}

}  // namespace

std::string stimulus_card(const Stimulus& stimulus, Motions& motions, NameLanguage language,
                          const FilmWarnings& films) {
  const std::string id = html_escaped(stimulus.id);
  std::string card =
      fmt::format("<article class=\"{}\" id=\"{}\">\n<h3>{} <small>{}</small></h3>\n",
                  name_of(stimulus.role), id, id, name_of(stimulus.role));
  card += video_of(stimulus) + sound_of_card(stimulus) + contact_sheet(id);
  card += warnings_of_film(stimulus, films);
  card += stimulus.people.empty() ? motion_part(stimulus, motions, language)
                                  : people_part(stimulus, motions, language);
  return card + "</article>\n";
}

std::string overlay_card(const Overlay& overlay, const Manifest& manifest, const Motions& motions,
                         const FilmWarnings& films) {
  const std::string id = html_escaped(overlay.film.id);
  std::string card = fmt::format("<article id=\"{}\">\n<h3>{}</h3>\n", id, id);
  card += video_of(overlay.film) + contact_sheet(id) + warnings_of_film(overlay.film, films);
  std::string legend;
  for (const auto& [role, motion] : motions_on(overlay)) {
    std::string name = html_escaped(motion);
    if (const Stimulus* stimulus = motions.stimulus(motion))
      name = fmt::format("<a href=\"{}\">{}</a>", link_to(*stimulus, manifest), name);
    legend += fmt::format("{}{} ({})", legend.empty() ? "" : ", ", name, name_of(role));
  }
  return card + "<p>" + legend + "</p>\n</article>\n";
}

std::string sheet_card(const Sheet& sheet, Motions& motions) {
  const std::string id = html_escaped(sheet.id);
  std::string alternative = fmt::format("{} motions side by side", sheet.gallery.size());
  if (!sheet.stills.empty()) {
    alternative = fmt::format("{}: a frame of each of {} stimuli", id, sheet.stills.size());
  }
  std::string caption = alternative;
  if (sheet.gallery.empty() && sheet.stills.empty()) {
    alternative = fmt::format("Comparison sheet of {} and {}", html_escaped(sheet.target),
                              html_escaped(sheet.created));
    const motion::Example& target = motions.of(sheet.target).motion;
    const motion::Example& created = motions.of(sheet.created).motion;
    const motion::Distance distance = motions.distance(sheet.target, sheet.created);
    caption = html_escaped(verdict(distance) + "; " + beside_verdict(distance, target, created));
  }
  return fmt::format(
      "<figure>\n<a href=\"sheets/{0}.pdf\"><img loading=\"lazy\" src=\"sheets/{0}.png\" "
      "alt=\"{1}\"></a>\n<figcaption>{2} (<a href=\"sheets/{0}.pdf\">PDF</a>)</figcaption>\n"
      "</figure>\n",
      id, alternative, caption);
}

}  // namespace mien::pipeline
