#include "pipeline/regression/report/regression_texts.h"

#include <algorithm>
#include <span>

#include <fmt/ranges.h>

#include "motion/measures/differences/difference_sentence.h"
#include "pipeline/base/documents/html.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t most_names = 6;

std::string names_text(const std::vector<std::string>& ids) {
  const auto named = std::span(ids).first(std::min(ids.size(), most_names));
  std::string text = fmt::to_string(fmt::join(named, ", "));
  if (ids.size() > most_names) text += fmt::format(" and {} more", ids.size() - most_names);
  return text;
}

/// The share of a cause as text. Noise of the renderer makes a hundredth or so less than nothing,
/// or more than all.
std::string percent(double share) {
  constexpr double noise = 0.02;
  if (share < 0.0 && share > -noise) share = 0.0;
  if (share > 1.0 && share < 1.0 + noise) share = 1.0;
  return fmt::format("{:.0f} %", 100.0 * share);
}

/// The one that looks most different.
const FrameComparison* worst_of(const std::vector<FrameComparison>& frames) {
  const auto worst = std::ranges::max_element(
      frames, {}, [](const FrameComparison& frame) { return frame.perceived.mean; });
  return worst == frames.end() ? nullptr : &*worst;
}

bool is_reported(const StimulusComparison& one) { return one.verdict != Verdict::same; }

}  // namespace

std::string cause_text(const Attribution& cause) {
  return fmt::format("{}{}: {} ({})", cause.share ? percent(*cause.share) + " " : "",
                     name_of(cause.cause), cause.root, cause.evidence);
}

std::string gate_text(const Gate& gate) {
  if (gate.id.empty()) return "No stimulus available for a planted defect";
  const auto told = [](const std::string& defect, bool caught) {
    return defect.empty() ? std::string()
                          : defect + (caught ? " was detected" : " was NOT detected");
  };
  return fmt::format("Planted defect in a copy of {}: {}; {}", gate.id,
                     told(gate.motion_defect, gate.motion_caught),
                     told(gate.picture_defect, gate.picture_caught));
}

std::string repetitions_text(const Repetitions& repetitions) {
  if (repetitions.times < 2) return "";
  if (repetitions.differing == 0)
    return fmt::format("made {} times: bit-identical\n", repetitions.times);
  return fmt::format(
      "made {} times: {} motions and frames differ between repetitions, by at most {:.0f} of 255\n",
      repetitions.times, repetitions.differing, 255.0 * repetitions.largest);
}

namespace {

/// The text escaped for XML 1.0.
std::string xml(const std::string& text) { return html_escaped(text); }

std::string details_of(const StimulusComparison& one) {
  std::string text;
  if (const std::string motion = motion_text(one); !motion.empty()) text += motion + "\n";
  for (const std::string& reason : one.reasons) text += reason + "\n";
  for (const Attribution& cause : one.causes) text += "because of " + cause_text(cause) + "\n";
  return text;
}

/// "|" parts the cells of a table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

std::string summary_text(const Regression& regression) {
  std::string text;
  for (const auto& [word, verdict] : verdict_words) {
    const int count = regression.count(verdict);
    if (count == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count,
                        verdict == Verdict::differs && count != 1 ? "differ" : std::string(word));
  }
  if (text.empty()) text = "no stimuli";
  for (const auto& [wider, ids] : regression.wider)
    text += fmt::format("; limit wider than approved: {} ({})", wider, names_text(ids));
  return regression.gate.holds() ? text : text + "; A PLANTED DEFECT WAS NOT SEEN";
}

std::string first_words(const StimulusComparison& one) {
  if (std::string motion = motion_text(one); !motion.empty()) return motion;
  if (!one.reasons.empty()) return one.reasons.front();
  const bool is_good = one.verdict == Verdict::same || one.verdict == Verdict::alike;
  return is_good ? "within tolerance or noise" : std::string(name_of(one.verdict));
}

std::string not_compared_text(const Regression& regression) {
  const std::size_t count = regression.not_compared.size();
  if (count == 0) return "";
  return fmt::format("NOT COMPARED (excluded by --only): {} of {}: {}\n", count,
                     count + regression.stimuli.size(), names_text(regression.not_compared));
}

std::string unapproved_text(const Regression& regression) {
  const std::size_t count = regression.without_videos.size();
  if (count == 0) return "";
  return fmt::format("no videos were approved for {}; their videos are not compared\n",
                     names_text(regression.without_videos));
}

std::string group_text(const CauseGroup& group) {
  return fmt::format("{} ({}): {} {}: {}", group.root, name_of(group.cause), group.ids.size(),
                     group.ids.size() == 1 ? "stimulus" : "stimuli", names_text(group.ids));
}

std::string motion_text(const StimulusComparison& comparison) {
  return comparison.motion ? motion::largest_change(*comparison.motion) : "";
}

std::string shares_text(const std::vector<BodyShare>& shares) {
  constexpr std::size_t most_parts = 5;
  constexpr const char* nothing_moved = "without motion (camera, light, noise)";
  std::string text;
  const auto add = [&](double share, const std::string& what) {
    if (share >= 0.005)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", percent(share), what);
  };
  double others = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (shares[i].part.empty()) continue;
    if (i < most_parts)
      add(shares[i].share, shares[i].part);
    else
      others += shares[i].share;
  }
  add(others, "other parts");
  if (!shares.empty() && shares.back().part.empty()) add(shares.back().share, nothing_moved);
  return text;
}

std::string plain_text(const Regression& regression) {
  std::string text;
  for (const CauseGroup& group : regression.groups) text += group_text(group) + "\n";
  for (const StimulusComparison& one : regression.stimuli) {
    if (!is_reported(one)) continue;
    text += fmt::format("\n{:<9} {}\n", name_of(one.verdict), one.id);
    if (const std::string motion = motion_text(one); !motion.empty()) text += "  " + motion + "\n";
    for (const std::string& reason : one.reasons) text += "  " + reason + "\n";
    if (const FrameComparison* worst = worst_of(one.frames); worst && !worst->shares.empty())
      text += fmt::format("  frame {}: {}\n", worst->frame, shares_text(worst->shares));
    for (const Attribution& cause : one.causes) text += "  because of " + cause_text(cause) + "\n";
  }
  text += fmt::format("{}{}: {}\n", text.empty() ? "" : "\n", regression.study,
                      summary_text(regression));
  text += not_compared_text(regression);
  return text + gate_text(regression.gate) + "\n" + repetitions_text(regression.repetitions) +
         unapproved_text(regression);
}

std::string markdown_text(const Regression& regression) {
  std::string text = fmt::format("## {} {}\n\n{}\n", regression.passes() ? "✅" : "❌",
                                 regression.study, summary_text(regression));
  if (const std::string others = not_compared_text(regression); !others.empty())
    text += "\n" + others;
  if (!regression.groups.empty()) text += "\n| cause | what | stimuli |\n|---|---|---|\n";
  for (const CauseGroup& group : regression.groups)
    text += fmt::format("| {} | {} | {}: {} |\n", name_of(group.cause), cell(group.root),
                        group.ids.size(), cell(names_text(group.ids)));
  const bool any = std::ranges::any_of(regression.stimuli, is_reported);
  if (any) text += "\n| stimulus | verdict | why |\n|---|---|---|\n";
  for (const StimulusComparison& one : regression.stimuli) {
    if (!is_reported(one)) continue;
    std::string why = cell(motion_text(one));
    for (const std::string& reason : one.reasons) why += (why.empty() ? "" : "<br>") + cell(reason);
    text += fmt::format("| {} | {} | {} |\n", cell(one.id), name_of(one.verdict), why);
  }
  text += "\n" + gate_text(regression.gate) + "\n";
  if (const std::string lacking = unapproved_text(regression); !lacking.empty())
    text += "\n" + lacking;
  return text;
}

std::string junit_text(const Regression& regression) {
  const int failures = regression.count(Verdict::differs) + regression.count(Verdict::appeared) +
                       regression.count(Verdict::gone) + int{!regression.gate.holds()};
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\">\n",
      xml(regression.study), regression.stimuli.size() + regression.not_compared.size() + 1,
      failures, regression.not_compared.size());
  for (const StimulusComparison& one : regression.stimuli) {
    text +=
        fmt::format("  <testcase classname=\"{}\" name=\"{}\"", xml(regression.study), xml(one.id));
    const bool is_good = one.verdict == Verdict::same || one.verdict == Verdict::alike;
    text += is_good ? "/>\n"
                    : fmt::format("><failure message=\"{}\">{}</failure></testcase>\n",
                                  xml(first_words(one)), xml(details_of(one)));
  }
  for (const std::string& id : regression.not_compared)
    text += fmt::format(
        "  <testcase classname=\"{}\" name=\"{}\"><skipped message=\"not compared (excluded by "
        "--only)\"/></testcase>\n",
        xml(regression.study), xml(id));
  text += fmt::format("  <testcase classname=\"{}\" name=\"(planted defects are detected)\"",
                      xml(regression.study));
  text += regression.gate.holds() ? "/>\n"
                                  : fmt::format("><failure message=\"{}\"/></testcase>\n",
                                                xml(gate_text(regression.gate)));
  return text + "</testsuite>\n";
}

}  // namespace mien::pipeline
