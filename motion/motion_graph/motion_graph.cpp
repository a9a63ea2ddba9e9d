#include "motion/motion_graph/motion_graph.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include "motion/error.h"
#include "motion/gait/contact.h"
#include "motion/motion_graph/distance_minima.h"
#include "motion/motion_graph/graph_edges.h"
#include "motion/motion_graph/transition_checks.h"

namespace mien::motion {

namespace {

constexpr double hopeless_m = 1.0;  // beyond this nothing is looked for that could be joined

std::string in_metres(double metres) {
  std::ostringstream text;
  text << std::setprecision(3) << metres << " m";
  return text.str();
}

std::string quoted(const Clip& clip) { return "\"" + clip.name + "\""; }

void check(const MotionGraphOptions& options) {
  if (!(options.threshold_m > 0.0) || options.threshold_m > hopeless_m) {
    throw Error("a motion graph's threshold is " + in_metres(options.threshold_m),
                "choose it above 0 and up to 1 m; 0.06 m joins walks");
  }
  if (!(options.cloud.window_seconds > 0.0) || options.cloud.window_seconds > 2.0) {
    throw Error("a motion graph's window is not between 0 and 2 seconds",
                "a third of a second is usual");
  }
  if (!(options.cloud.virtual_point_m >= 0.0)) {
    throw Error("the distance of a motion graph's virtual points from the bones is negative",
                "0.1 m is usual");
  }
  if (!(options.most_contact_change >= 0.0 && options.most_contact_change <= 1.0)) {
    throw Error("a motion graph's most_contact_change is no share", "choose it from 0 to 1");
  }
  if (!(options.most_facing_change_deg > 0.0)) {
    throw Error("a motion graph's most_facing_change_deg is not positive", "5 degrees are usual");
  }
  double sum = 0.0;
  for (const double weight : options.cloud.joint_weights) {
    if (!(weight >= 0.0))
      throw Error("a joint of a motion graph weighs less than 0", "use 0 to omit it");
    sum += weight;
  }
  if (sum <= 0.0) throw Error("no joint of a motion graph has a weight", "use 1 for all");
}

bool is_same_body(const Skeleton& a, const Skeleton& b) {
  constexpr double alike_m = 1e-3;
  if (a.size() != b.size()) return false;
  for (std::size_t j = 1; j < a.joints.size(); ++j) {
    if ((a.joints[j].offset - b.joints[j].offset).norm() > alike_m) return false;
  }
  return true;
}

void check_alike(const Clip& clip, const Clip& first) {
  if (!is_body(clip.body)) {
    throw Error("the motion " + quoted(clip) + " does not have the canonical body",
                "map it to the body first (rig/body_mapping.h)");
  }
  if (!is_same_body(clip.body, first.body)) {
    throw Error(
        "the motions " + quoted(first) + " and " + quoted(clip) + " are of different bodies",
        "a motion graph needs one: retarget them to one body first");
  }
  if (std::abs(clip.frames_per_second - first.frames_per_second) > 1e-9) {
    throw Error(
        "the motions " + quoted(first) + " and " + quoted(clip) + " have different frame rates",
        "resample them to one rate first");
  }
}

/// A clip that does not loop: cycle after cycle and a window more.
Clip unrolled(const Clip& clip, int window, double least_seconds) {
  if (!clip.loops) return clip;
  const int wanted = std::max(static_cast<int>(std::ceil(least_seconds * clip.frames_per_second)),
                              clip.frame_count()) +
                     window + 1;
  Clip longer = repeated(clip, (wanted + clip.frame_count() - 1) / clip.frame_count());
  longer.poses.resize(static_cast<std::size_t>(wanted));
  longer.name = clip.name;
  return longer;
}

/// The least threshold at which a component with a cycle is left; above 1 m none is looked for.
double sufficient_threshold(MotionGraph graph, const std::vector<DistanceMinimum>& minima) {
  std::vector<double> metres;
  for (const DistanceMinimum& m : minima) metres.push_back(m.metres);
  std::sort(metres.begin(), metres.end());
  const auto enough = std::partition_point(metres.begin(), metres.end(), [&](double threshold) {
    return connect(graph, minima, threshold) == 0;
  });
  return enough == metres.end() ? -1.0 : *enough;
}

[[noreturn]] void refuse_unconnected(const MotionGraph& graph,
                                     const std::vector<DistanceMinimum>& minima) {
  const double enough = sufficient_threshold(graph, minima);
  throw Error("no part of the motion graph can be walked endlessly at a threshold of " +
                  in_metres(graph.threshold_m),
              enough < 0.0
                  ? "the motions are too unlike or too short: add some that repeat"
                  : "raise the threshold to " +
                        in_metres(std::ceil(enough * 1000.0 + 1.0) / 1000.0) + ", or add motions");
}

/// A blend turns the pelvis by no more than this beyond what its motions do, where less change of
/// facing can achieve it.
constexpr double most_turn_a_frame = 0.9 * radians_per_degree;

void find_turns(MotionGraph& graph) {
  std::vector<PointCloud> clouds;
  for (const Clip& clip : graph.clips) clouds.push_back(point_cloud(clip, graph.cloud));
  for (GraphTransition& t : graph.transitions) {
    const WindowDistance distance =
        window_distance(clouds[static_cast<std::size_t>(t.from_clip)], t.from_frame,
                        clouds[static_cast<std::size_t>(t.to_clip)], t.to_frame, graph.window);
    t.turn = distance.alignment.turn;
    const double change = facing_change(graph, t);
    const double most = radians_per_degree * graph.most_facing_change_deg;
    for (const double share : {1.0, 0.75, 0.5, 0.25, 0.0}) {
      t.turn = distance.alignment.turn - change + std::clamp(change, -share * most, share * most);
      if (turn_beyond_motions(graph, t) < most_turn_a_frame) break;
    }
    t.metres = distance.metres;
  }
}

void find_plants(MotionGraph& graph) {
  graph.plants.clear();
  for (const Clip& clip : graph.clips) graph.plants.push_back(foot_plants(clip));
}

}  // namespace

MotionGraph motion_graph(std::span<const Clip> clips, const MotionGraphOptions& options) {
  check(options);
  if (clips.empty()) throw Error("a motion graph without motions", "give one at least");
  MotionGraph graph;
  graph.threshold_m = options.threshold_m;
  graph.cloud = options.cloud;
  graph.most_facing_change_deg = options.most_facing_change_deg;
  graph.window = std::max(2, static_cast<int>(std::lround(options.cloud.window_seconds *
                                                          clips.front().frames_per_second)));
  std::vector<PointCloud> clouds;
  for (const Clip& clip : clips) {
    check_alike(clip, clips.front());
    graph.clips.push_back(unrolled(clip, graph.window, options.unrolled_seconds));
    if (graph.clips.back().frame_count() < 2 * graph.window) {
      throw Error("the motion " + quoted(clip) + " is too short for a motion graph",
                  "two windows are needed: " + std::to_string(2 * graph.window) + " frames");
    }
    clouds.push_back(point_cloud(graph.clips.back(), options.cloud));
  }
  MinimaOptions minima_options;
  minima_options.window = graph.window;
  minima_options.least_gap = graph.window;
  minima_options.most_metres = hopeless_m;
  minima_options.threads = options.threads;
  find_plants(graph);
  std::vector<DistanceMinimum> minima = distance_minima(clouds, minima_options);
  const FootContacts contacts = foot_contacts(graph);
  std::erase_if(minima, [&](const DistanceMinimum& m) {
    return contact_change(contacts, m, graph.window) > options.most_contact_change;
  });
  if (connect(graph, minima, options.threshold_m) == 0) refuse_unconnected(graph, minima);
  find_turns(graph);
  return graph;
}

MotionGraph with_motions(MotionGraph graph, std::span<const Clip> clips) {
  std::vector<SynchronisedMotion> motions;
  for (const Clip& clip : clips) motions.push_back({clip, {}});
  return with_motions(std::move(graph), motions);
}

MotionGraph with_motions(MotionGraph graph, std::span<const SynchronisedMotion> motions) {
  if (motions.size() != graph.clips.size()) {
    throw Error("a motion graph of " + std::to_string(graph.clips.size()) + " motions is given " +
                    std::to_string(motions.size()),
                "give one in place of each, in their order");
  }
  graph.frame_seconds.clear();
  bool in_tempo = false;
  for (std::size_t c = 0; c < motions.size(); ++c) {
    const Clip& clip = motions[c].clip;
    check_alike(clip, motions.front().clip);
    if (clip.frame_count() != graph.clips[c].frame_count() || clip.loops ||
        clip.frames_per_second != graph.clips[c].frames_per_second) {
      throw Error("the motion " + quoted(clip) + " has not the frames of " +
                      quoted(graph.clips[c]) + ", which it is to replace",
                  "put it in step first (synchronised), and unroll loops");
    }
    graph.frame_seconds.push_back(motions[c].frame_seconds);
    in_tempo = in_tempo || !motions[c].frame_seconds.empty();
  }
  for (std::size_t c = 0; c < motions.size(); ++c) {
    graph.clips[c] = motions[c].clip;
    std::vector<double>& seconds = graph.frame_seconds[c];
    if (seconds.empty())
      seconds.assign(graph.clips[c].poses.size(), 1.0 / graph.clips[c].frames_per_second);
  }
  if (!in_tempo) graph.frame_seconds.clear();
  find_turns(graph);
  find_plants(graph);
  return graph;
}

}  // namespace mien::motion
