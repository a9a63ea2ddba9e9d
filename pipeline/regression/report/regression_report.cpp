#include "pipeline/regression/report/regression_report.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/html.h"
#include "pipeline/regression/report/regression_texts.h"
#include "pipeline/regression/report/report_pictures.h"

#include "embedded/regression_css.h"

namespace mien::pipeline {

namespace {

using Json = nlohmann::ordered_json;

bool is_shown(const StimulusComparison& one) {
  return one.verdict == Verdict::differs || one.verdict == Verdict::alike;
}

std::string percents(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

/// What no cause does alone: together they do more, or less, than one by one.
std::string interaction_line(double interaction) {
  if (interaction > 0.0) return percents(interaction) + " only by several of these combined";
  return "separately they would cause " + percents(-interaction) + " more difference than combined";
}

std::vector<std::string> cause_lines(const StimulusComparison& one) {
  std::vector<std::string> lines;
  for (const Attribution& cause : one.causes) lines.push_back(cause_text(cause));
  if (std::abs(one.interaction) >= 0.01) lines.push_back(interaction_line(one.interaction));
  return lines;
}

std::string titled_list(const char* title, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  return fmt::format("<section><h3>{}</h3>\n{}</section>\n", title, html_list("reasons", lines));
}

/// The id of a stimulus's element, for links. No other element's id begins so.
std::string anchor_of(const std::string& id) { return html_escaped("stimulus-" + id); }

std::string single_picture(const char* words, const std::filesystem::path& file, int most_width) {
  if (!std::filesystem::exists(file)) return "";
  return fmt::format("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
                     words, picture_uri(file, most_width));
}

/// Pictures that cannot be overlaid: both side by side, or the only one.
std::string single_pictures(const StimulusComparison& one, const ComparedPictures* pictures) {
  constexpr int most_width = 640;
  std::vector<int> frames;
  for (const FrameComparison& frame : one.frames)
    if (!frame.same && !frame.same_size) frames.push_back(frame.frame);
  if (pictures == nullptr || frames.empty()) return "";
  const int middle = frames[frames.size() / 2];
  return fmt::format("<div class=\"lone\">\n{}{}</div>\n",
                     single_picture("before", pictures->before(one.id, middle), most_width),
                     single_picture("now", pictures->now(one.id, middle), most_width));
}

std::string card(const StimulusComparison& one, std::size_t index, bool opened,
                 const ComparedPictures* pictures) {
  std::vector<std::string> changes = one.reasons;
  if (std::string motion = motion_text(one); !motion.empty())
    changes.insert(changes.begin(), std::move(motion));
  return fmt::format(
      "<details class=\"card {0}\" id=\"{1}\"{2}{3}><summary><b>{4}</b><span class=\"pill\">{0}"
      "</span> <small>{5}</small></summary>\n<div class=\"told\">\n{6}{7}</div>{8}</details>\n",
      name_of(one.verdict), anchor_of(one.id),
      is_shown(one) ? fmt::format(" data-index=\"{}\"", index) : "", opened ? " open" : "",
      html_escaped(one.id), html_escaped(first_words(one)), titled_list("What", changes),
      titled_list("Why", cause_lines(one)), single_pictures(one, pictures));
}

std::string links_to(std::span<const std::string> ids) {
  std::string links;
  for (const std::string& id : ids)
    links += fmt::format("{}<a href=\"#{}\">{}</a>", links.empty() ? "" : ", ", anchor_of(id),
                         html_escaped(id));
  return links;
}

/// The first few; the others on request.
std::string group_links(const std::vector<std::string>& ids) {
  constexpr std::size_t few = 12;
  if (ids.size() <= few + 3) return links_to(ids);
  const std::span<const std::string> all(ids);
  return fmt::format("{}<details><summary>and {} more</summary>{}</details>",
                     links_to(all.first(few)), ids.size() - few, links_to(all.subspan(few)));
}

std::string groups_table(std::span<const CauseGroup> groups) {
  std::string rows;
  for (const CauseGroup& group : groups)
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"number\">{}</td><td>{}</td></tr>\n",
                        name_of(group.cause), html_escaped(group.root), group.ids.size(),
                        group_links(group.ids));
  return html_table({"cause", "what", "stimuli", ""}, rows);
}

/// The first few causes, for the stimuli not to lie far below; the others on request.
std::string causes_section(const std::vector<CauseGroup>& groups) {
  constexpr std::size_t few = 12;
  if (groups.empty()) return "";
  const std::string title = "<h2>Causes</h2>\n";
  if (groups.size() <= few + 3) return title + groups_table(groups);
  const std::span<const CauseGroup> all(groups);
  return fmt::format(
      "{}{}<details class=\"more\"><summary>and {} more causes</summary>{}</details>\n", title,
      groups_table(all.first(few)), groups.size() - few, groups_table(all.subspan(few)));
}

/// Stimuli with differences first, then those without.
std::vector<const StimulusComparison*> in_order(const Regression& regression) {
  std::vector<const StimulusComparison*> order;
  for (const Verdict verdict : {Verdict::differs, Verdict::appeared, Verdict::gone, Verdict::alike})
    for (const StimulusComparison& one : regression.stimuli)
      if (one.verdict == verdict) order.push_back(&one);
  return order;
}

/// JSON as an element that the page's script reads when it needs it. No text in it can end it.
std::string data_element(std::size_t index, const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; ++at)
    text.replace(at, 1, "\\u003c");
  return fmt::format("<script type=\"application/json\" id=\"data-{}\">{}</script>\n", index, text);
}

std::string left_out(const ReportPictures& chosen) {
  if (chosen.every_frame) return "";
  return fmt::format(
      "<p class=\"quiet\">For each stimulus the worst frame is shown{}; all frames are in the "
      "folder <code>frames</code> beside this page.</p>\n",
      chosen.most_width > 0 ? fmt::format(", at most {} pixels wide", chosen.most_width) : "");
}

/// What the study is held against, and how far the comparison can be trusted.
std::string grounds(const Regression& regression, const Baseline& baseline) {
  std::string text;
  if (!baseline.approvals.empty()) {
    const Approval& last = baseline.approvals.back();
    text = fmt::format("Last approved by {}, {}: “{}”. ", last.who, last.when, last.why);
  }
  text += gate_text(regression.gate) + ". " + repetitions_text(regression.repetitions) +
          unapproved_text(regression);
  return "<p class=\"quiet grounds\">" + html_escaped(text) + "</p>\n";
}

/// A page about a part of a study must not be taken for one about all of it.
std::string others_line(const Regression& regression) {
  const std::string others = not_compared_text(regression);
  return others.empty() ? "" : "<p class=\"partial\">" + html_escaped(others) + "</p>\n";
}

constexpr char no_viewers[] =
    "<p class=\"partial\">Images, motions and videos of stimuli are not shown, because the web "
    "pages of mien were not built when this report was written. ./mien in the source tree builds "
    "them.</p>\n";

constexpr char keys_help[] =
    "<p class=\"keys\"><kbd>J</kbd> <kbd>K</kbd> next and previous stimulus · <kbd>1</kbd> slider "
    "<kbd>2</kbd> blink <kbd>3</kbd> difference <kbd>4</kbd> ꟻLIP · <kbd>[</kbd> <kbd>]</kbd> key "
    "frame · <kbd>←</kbd> <kbd>→</kbd> one frame · <kbd>Space</kbd> play · <kbd>V</kbd> video · "
    "<kbd>Shift</kbd>+<kbd>←</kbd> <kbd>→</kbd> slider · <kbd>G</kbd> contrast · <kbd>A</kbd> "
    "<kbd>D</kbd> <kbd>W</kbd> <kbd>S</kbd> turn in 3-D</p>\n";

}  // namespace

std::string regression_report(const Regression& regression, const ComparedStudy& study,
                              const std::string& script, ReportVideos videos) {
  const std::vector<const StimulusComparison*> order = in_order(regression);
  ReportPictures chosen;
  if (study.pictures) chosen = fitting_pictures(regression, *study.pictures);
  std::string cards;
  std::string data;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const StimulusComparison& one = *order[i];
    const bool has_room = i < most_with_every_frame;
    cards += card(one, i, i == 0, has_room ? study.pictures : nullptr);
    if (!is_shown(one) || script.empty()) continue;
    Json entry = {{"frames", Json::array()}};
    if (study.pictures) entry["frames"] = frames_json(one, *study.pictures, chosen);
    if (one.motion) entry["motion"] = motion_json(one, study);
    if (Json both = videos.of(one.id, study.baseline); !both.is_null()) entry["videos"] = both;
    data += data_element(i, entry);
  }
  const std::string told = script.empty() ? no_viewers : left_out(chosen) + keys_help;
  const std::string body = fmt::format(
      "<h1>{}</h1>\n<p class=\"verdict {}\">{}</p>\n{}{}{}{}{}{}<script>\n{}</script>\n",
      html_escaped(regression.study), regression.passes() ? "holds" : "fails",
      html_escaped(summary_text(regression)), others_line(regression),
      grounds(regression, study.baseline), causes_section(regression.groups),
      order.empty() ? "" : "<h2>Stimuli</h2>\n" + told, cards, data, script);
  return html_page(regression.study + ": regression", embedded_regression_css, body);
}

}  // namespace mien::pipeline
