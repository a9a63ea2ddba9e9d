#include "pipeline/regression/report/regression_texts.h"

#include <algorithm>

#include <fmt/format.h>

#include "motion/measures/difference_sentence.h"
#include "pipeline/documents/html.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t most_names = 6;

std::string names_text(const std::vector<std::string>& ids) {
  std::string text;
  for (std::size_t i = 0; i < std::min(ids.size(), most_names); ++i)
    text += (i == 0 ? "" : ", ") + ids[i];
  if (ids.size() > most_names) text += fmt::format(" and {} more", ids.size() - most_names);
  return text;
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

std::string cause_text(const Attribution& cause) {
  return fmt::format("{}{}: {} ({})", cause.share ? percent(*cause.share) + " " : "",
                     name_of(cause.cause), cause.root, cause.evidence);
}

/// The one that looks most different.
const FrameComparison* worst_of(const std::vector<FrameComparison>& frames) {
  const auto worst = std::ranges::max_element(
      frames, {}, [](const FrameComparison& frame) { return frame.perceived.mean; });
  return worst == frames.end() ? nullptr : &*worst;
}

bool is_told(const StimulusComparison& one) { return one.verdict != Verdict::same; }

}  // namespace

std::string gate_text(const Gate& gate) {
  if (gate.id.empty()) return "no stimulus to plant a defect in";
  const auto told = [](const std::string& defect, bool caught) {
    return defect.empty() ? std::string() : defect + (caught ? " was seen" : " was NOT seen");
  };
  return fmt::format("planted in a copy of {}: {}; {}", gate.id,
                     told(gate.motion_defect, gate.motion_caught),
                     told(gate.picture_defect, gate.picture_caught));
}

std::string repetitions_text(const Repetitions& repetitions) {
  if (repetitions.times < 2) return "";
  if (repetitions.differing == 0)
    return fmt::format("made {} times: not a bit differs\n", repetitions.times);
  return fmt::format(
      "made {} times: {} motions and frames came out otherwise, by {:.0f} of 255 at "
      "most\n",
      repetitions.times, repetitions.differing, 255.0 * repetitions.largest);
}

namespace {

/// As XML 1.0 takes it.
std::string xml(const std::string& text) { return html_escaped(text); }

std::string details_of(const StimulusComparison& one) {
  std::string text;
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

nlohmann::ordered_json as_json(const FrameComparison& frame) {
  nlohmann::ordered_json json = {{"frame", frame.frame}, {"same", frame.same}};
  if (frame.same || !frame.same_size) {
    json["same_size"] = frame.same_size;
    return json;
  }
  json["largest"] = frame.difference.largest;
  json["rms"] = frame.difference.rms;
  json["openimageio"] = {{"largest", frame.second_voice.largest}, {"rms", frame.second_voice.rms}};
  json["flip_mean"] = frame.perceived.mean;
  json["flip_max"] = frame.perceived.largest;
  json["ssim"] = frame.similarity;
  json["noise"] = {{"tests", frame.noise.tests},           {"outside", frame.noise.outside},
                   {"largest_t", frame.noise.largest_t},   {"least_p", frame.noise.least_p},
                   {"together_p", frame.noise.together_p}, {"is_bias", frame.noise.is_bias}};
  nlohmann::ordered_json shares = nlohmann::ordered_json::object();
  for (const BodyShare& share : frame.shares)
    shares[share.part.empty() ? "unexplained" : share.part] = share.share;
  if (!frame.shares.empty()) json["explained_by"] = shares;
  return json;
}

nlohmann::ordered_json as_json(const motion::MotionDifference& motion) {
  nlohmann::ordered_json joints = nlohmann::ordered_json::object();
  for (const motion::JointDifference& joint : motion.joints) {
    joints[joint.part] = {{"most_m", motion::peak_of(joint.point_m).value},
                          {"most_turn_rad", motion::peak_of(joint.turn_radians).value},
                          {"does_it_itself", joint.differs_itself()}};
  }
  nlohmann::ordered_json json = {{"mpjpe_m", motion.errors.mpjpe},
                                 {"pa_mpjpe_m", motion.errors.pa_mpjpe}};
  if (motion.body) json["d_m"] = motion.body->d_m;
  json["joints"] = joints;
  return json;
}

nlohmann::ordered_json as_json(const StimulusComparison& one) {
  nlohmann::ordered_json json = {{"id", one.id}, {"verdict", name_of(one.verdict)}};
  if (!one.reasons.empty()) json["reasons"] = one.reasons;
  nlohmann::ordered_json causes = nlohmann::ordered_json::array();
  for (const Attribution& cause : one.causes) {
    nlohmann::ordered_json entry = {
        {"cause", name_of(cause.cause)}, {"root", cause.root}, {"evidence", cause.evidence}};
    if (cause.share) entry["share"] = *cause.share;
    causes.push_back(std::move(entry));
  }
  if (!one.causes.empty()) {
    json["causes"] = causes;
    json["interaction"] = one.interaction;
  }
  for (const SettingChange& change : one.settings)
    json["settings"][change.path] = {{"before", change.before}, {"now", change.now}};
  for (const ValueChange& change : one.weights)
    json["weights"][change.name] = {change.before, change.now};
  for (const ValueChange& change : one.parameters)
    json["parameters"][change.name] = {change.before, change.now};
  if (one.motion) json["motion"] = as_json(*one.motion);
  for (const FrameComparison& frame : one.frames) json["frames"].push_back(as_json(frame));
  json["frames_reused"] = one.frames_reused;
  for (const VideoChange& video : one.videos) json["videos"][video.format] = video.what;
  return json;
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
  for (const auto& [wider, ids] : regression.wider)
    text += fmt::format("; limit wider than approved: {} ({})", wider, names_text(ids));
  return fmt::format(
      "{}; {}", text.empty() ? "no stimuli" : text,
      regression.gate.holds() ? "the gate holds" : "THE GATE FAILS: a planted defect was not seen");
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
  if (!shares.empty() && shares.back().part.empty()) add(shares.back().share, "unexplained");
  return text;
}

std::string plain_text(const Regression& regression) {
  std::string text;
  for (const CauseGroup& group : regression.groups) text += group_text(group) + "\n";
  for (const StimulusComparison& one : regression.stimuli) {
    if (!is_told(one)) continue;
    text += fmt::format("\n{:<9} {}\n", name_of(one.verdict), one.id);
    for (const std::string& reason : one.reasons) text += "  " + reason + "\n";
    if (const std::string motion = motion_text(one); !motion.empty()) text += "  " + motion + "\n";
    if (const FrameComparison* worst = worst_of(one.frames); worst && !worst->shares.empty())
      text += fmt::format("  frame {}: {}\n", worst->frame, shares_text(worst->shares));
    for (const Attribution& cause : one.causes) text += "  because of " + cause_text(cause) + "\n";
  }
  text += fmt::format("{}{}: {}\n", text.empty() ? "" : "\n", regression.study,
                      summary_text(regression));
  return text + gate_text(regression.gate) + "\n" + repetitions_text(regression.repetitions);
}

std::string markdown_text(const Regression& regression) {
  std::string text = fmt::format("## {} {}\n\n{}\n", regression.passes() ? "✅" : "❌",
                                 regression.study, summary_text(regression));
  if (!regression.groups.empty()) text += "\n| cause | what | stimuli |\n|---|---|---|\n";
  for (const CauseGroup& group : regression.groups)
    text += fmt::format("| {} | {} | {}: {} |\n", name_of(group.cause), cell(group.root),
                        group.ids.size(), cell(names_text(group.ids)));
  const bool any = std::ranges::any_of(regression.stimuli, is_told);
  if (any) text += "\n| stimulus | verdict | why |\n|---|---|---|\n";
  for (const StimulusComparison& one : regression.stimuli) {
    if (!is_told(one)) continue;
    std::string why;
    for (const std::string& reason : one.reasons) why += (why.empty() ? "" : "<br>") + cell(reason);
    text += fmt::format("| {} | {} | {} |\n", cell(one.id), name_of(one.verdict), why);
  }
  return text + "\n" + gate_text(regression.gate) + "\n";
}

std::string junit_text(const Regression& regression) {
  const int failures = regression.count(Verdict::differs) + regression.count(Verdict::appeared) +
                       regression.count(Verdict::gone) + int{!regression.gate.holds()};
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n",
      xml(regression.study), regression.stimuli.size() + 1, failures);
  for (const StimulusComparison& one : regression.stimuli) {
    text +=
        fmt::format("  <testcase classname=\"{}\" name=\"{}\"", xml(regression.study), xml(one.id));
    const bool is_good = one.verdict == Verdict::same || one.verdict == Verdict::alike;
    text += is_good ? "/>\n"
                    : fmt::format("><failure message=\"{}\">{}</failure></testcase>\n",
                                  xml(one.reasons.empty() ? std::string(name_of(one.verdict))
                                                          : one.reasons.front()),
                                  xml(details_of(one)));
  }
  text += fmt::format("  <testcase classname=\"{}\" name=\"(planted defects are seen)\"",
                      xml(regression.study));
  text += regression.gate.holds() ? "/>\n"
                                  : fmt::format("><failure message=\"{}\"/></testcase>\n",
                                                xml(gate_text(regression.gate)));
  return text + "</testsuite>\n";
}

nlohmann::ordered_json as_json(const Regression& regression) {
  nlohmann::ordered_json counts = nlohmann::ordered_json::object();
  for (const auto& [word, verdict] : verdict_words) counts[word] = regression.count(verdict);
  nlohmann::ordered_json groups = nlohmann::ordered_json::array();
  for (const CauseGroup& group : regression.groups) {
    groups.push_back({{"cause", name_of(group.cause)},
                      {"root", group.root},
                      {"differs", group.differs},
                      {"stimuli", group.ids}});
  }
  nlohmann::ordered_json stimuli = nlohmann::ordered_json::array();
  for (const StimulusComparison& one : regression.stimuli) stimuli.push_back(as_json(one));
  return {{"study", regression.study},
          {"passes", regression.passes()},
          {"counts", counts},
          {"groups", groups},
          {"gate", {{"holds", regression.gate.holds()}, {"what", gate_text(regression.gate)}}},
          {"repetitions",
           {{"times", regression.repetitions.times},
            {"differing", regression.repetitions.differing},
            {"largest", regression.repetitions.largest}}},
          {"wider_limits", regression.wider},
          {"audited", regression.audited},
          {"stimuli", stimuli}};
}

}  // namespace mien::pipeline
