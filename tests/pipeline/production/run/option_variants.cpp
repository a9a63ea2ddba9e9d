#include "pipeline/production/run/option_variants.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/bvh/bvh.h"
#include "motion/formats/motion_file.h"
#include "motion/formats/numpy/numpy_files.h"
#include "motion/formats/smpl/smpl.h"
#include "motion/formats/smpl/smpl_model_file.h"
#include "motion/formats/trc/trc.h"
#include "motion/points/point_recording.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/clip.h"
#include "motion/skeleton/recording.h"
#include "motion/two_takes.h"
#include "render/sounds.h"
#include "scenes/skinned_gltf.h"

namespace mien::test {

namespace {

using nlohmann::json;

json parsed(const char* text) { return json::parse(text); }

/// As small and quick as a study can be that still makes every kind of artifact.
json tiny_study() {
  return parsed(R"({"mien": 1, "study": "s", "seed": 1, "examples": {"set": "builtin:walks-10"},
    "output": {"size": [32, 24], "fps": 6, "cycles": 1, "quality": "draft", "video": ["gif"]},
    "stimuli": [{"id": "a", "weights": {"normal": 1}}, {"id": "b", "weights": {"sad": 1}}]})");
}

/// What must stand around an option for it to count: patches of the whole manifest, and values of
/// the map that the option stands in. The first entry whose text the path holds is taken, of each.
struct Surroundings {
  const char* path;
  const char* patch;
  const char* siblings;
};

constexpr char with_wishes[] =
    R"({"stimuli": [{"id": "a", "adjectives": {"quickness": 0.7}}, {"id": "b", "weights": {"sad": 1}}]})";
constexpr char with_foil[] =
    R"({"stimuli": [{"id": "a", "foil": {"of": "b", "differ": "posture"}}, {"id": "b", "weights": {"sad": 1}, "modify": {"emotion": "sad"}}, {"id": "c", "weights": {"normal": 1}, "modify": {"emotion": "sad"}}]})";
constexpr char with_folder[] =
    R"({"examples": {"set": null, "ratings": "simulated"}, "stimuli": [{"id": "a", "weights": {"sad": 1}}, {"id": "b", "weights": {"normal": 1}}]})";
constexpr char with_a_folder_or_set[] =
    R"({"stimuli": [{"id": "a", "features": {"step-length": 0.5}}, {"id": "b", "clip": "one/sad.bvh"}]})";
constexpr char with_folder_of_licence[] =
    R"({"examples": {"set": {"folder": "one", "cycle": "whole"}, "ratings": "simulated"}, "stimuli": [{"id": "a", "weights": {"sad": 1}}, {"id": "b", "weights": {"normal": 1}}]})";
constexpr char with_clip[] =
    R"({"stimuli": [{"id": "a", "clip": {"file": "one/normal.bvh"}}, {"id": "b", "weights": {"sad": 1}}]})";
constexpr char with_graph_of_file[] =
    R"({"stimuli": [{"id": "a", "path": {"graph": [{"file": "long/normal.bvh"}], "script": [{"walk": 1}]}}, {"id": "b", "weights": {"sad": 1}}]})";
constexpr char with_points[] =
    R"({"stimuli": [{"id": "a", "path": {"points": [[0, 0], [0, 1]]}}, {"id": "b", "weights": {"sad": 1}}]})";
constexpr char with_graph[] =
    R"({"stimuli": [{"id": "a", "path": {"graph": [{}], "script": [{"walk": 1}]}}, {"id": "b", "weights": {"sad": 1}}]})";
constexpr char with_markers[] =
    R"({"stimuli": [{"id": "a", "clip": "normal.trc"}, {"id": "b", "clip": "sad.trc"}]})";
constexpr char with_stills[] = R"({"sheets": [{"stills": ["a", "b"]}]})";
constexpr char with_sounds[] =
    R"({"output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}}, {"id": "b", "weights": {"sad": 1}, "audio": {"file": "one.wav", "length": "cut"}}, {"id": "c", "weights": {"proud": 1}, "audio": {"file": "two.wav", "length": "cut"}}]})";
constexpr char with_exchanged_sounds[] =
    R"({"output": {"video": ["mp4"]}, "mismatch": {"audio": "derange"}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "audio": {"file": "one.wav", "length": "cut"}}, {"id": "b", "weights": {"sad": 1}, "audio": {"file": "two.wav", "length": "cut"}}, {"id": "c", "weights": {"proud": 1}, "audio": {"file": "three.wav", "length": "cut"}}]})";
constexpr char with_overlay[] = R"({"overlays": [{"target": "a", "created": "b"}]})";

constexpr char with_questions[] =
    R"({"questionnaire": {"participants": 4, "scales": "all"}, "output": {"video": ["mp4"]}})";
constexpr char with_questions_and_factors[] =
    R"({"questionnaire": {"participants": 4, "scales": "all"}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "factors": {"actor": "k", "mood": "x"}}, {"id": "b", "weights": {"sad": 1}, "factors": {"actor": "m", "mood": "y"}}]})";
constexpr char with_crossed_factors[] =
    R"({"questionnaire": {"participants": 4, "scales": "all", "demographics": [{"id": "sex", "ask": "Which?", "answer": ["f", "m"]}, {"id": "hand", "ask": "Which?", "answer": ["l", "r"]}]}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "factors": {"actor": "k", "mood": "x"}}, {"id": "b", "weights": {"sad": 1}, "factors": {"actor": "m", "mood": "y"}}, {"id": "c", "weights": {"sad": 1}, "factors": {"actor": "k", "mood": "y"}}, {"id": "d", "weights": {"normal": 1}, "factors": {"actor": "m", "mood": "x"}}]})";
constexpr char with_crossed_pairs[] =
    R"({"questionnaire": {"participants": 4, "scales": "all", "trials": "pair", "demographics": [{"id": "sex", "ask": "Which?", "answer": ["f", "m"]}, {"id": "hand", "ask": "Which?", "answer": ["l", "r"]}]}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "factors": {"actor": "k", "mood": "x"}}, {"id": "b", "weights": {"sad": 1}, "factors": {"actor": "m", "mood": "y"}}, {"id": "c", "weights": {"sad": 1}, "factors": {"actor": "k", "mood": "y"}}, {"id": "d", "weights": {"normal": 1}, "factors": {"actor": "m", "mood": "x"}}]})";
constexpr char with_questions_and_glb[] =
    R"({"questionnaire": {"participants": 4, "scales": "all"}, "output": {"video": ["mp4"], "clips": ["bvh", "glb"]}})";

constexpr char with_pairs[] =
    R"({"questionnaire": {"participants": 4, "scales": "all", "trials": "pair"}, "output": {"video": ["mp4"]}})";
constexpr char with_no_scales[] =
    R"({"questionnaire": {"participants": 4}, "output": {"video": ["mp4"]}})";
constexpr char with_best_worst[] =
    R"({"questionnaire": {"participants": 4, "scales": "all", "trials": "best_worst"}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}}, {"id": "b", "weights": {"sad": 1}}, {"id": "c", "weights": {"proud": 1}}, {"id": "d", "weights": {"tired": 1}}]})";
constexpr char with_grid[] =
    R"({"questionnaire": {"participants": 4, "scales": ["sad-happy"], "trials": "grid"}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "factors": {"actor": "k", "mood": "x"}}, {"id": "b", "weights": {"sad": 1}, "factors": {"actor": "m", "mood": "y"}}, {"id": "c", "weights": {"sad": 1}, "factors": {"actor": "k", "mood": "y"}}, {"id": "d", "weights": {"normal": 1}, "factors": {"actor": "m", "mood": "x"}}]})";
constexpr char with_grid_of_actors[] =
    R"({"questionnaire": {"participants": 4, "scales": ["sad-happy"], "trials": "grid", "grid": {"alike": ["actor"]}}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "factors": {"actor": "k", "mood": "x"}}, {"id": "b", "weights": {"sad": 1}, "factors": {"actor": "m", "mood": "y"}}, {"id": "c", "weights": {"sad": 1}, "factors": {"actor": "k", "mood": "y"}}, {"id": "d", "weights": {"normal": 1}, "factors": {"actor": "m", "mood": "x"}}]})";
constexpr char with_reference[] =
    R"({"questionnaire": {"participants": 4, "scales": ["sad-happy"], "trials": "grid", "grid": {"alike": ["actor"], "reference": {"mood": ["x"]}}}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "factors": {"actor": "k", "mood": "x"}}, {"id": "b", "weights": {"sad": 1}, "factors": {"actor": "m", "mood": "y"}}, {"id": "c", "weights": {"sad": 1}, "factors": {"actor": "k", "mood": "y"}}, {"id": "d", "weights": {"normal": 1}, "factors": {"actor": "m", "mood": "x"}}]})";
constexpr char with_continuous[] =
    R"({"questionnaire": {"participants": 4, "scales": ["sad-happy"], "trials": "continuous"}, "output": {"video": ["mp4"]}})";
constexpr char with_staircase[] =
    R"({"questionnaire": {"participants": 4, "trials": "same_different", "adaptive": {"factor": "dose", "method": "staircase", "trials": 20}}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "factors": {"dose": "0", "mood": "0"}}, {"id": "b", "weights": {"sad": 1}, "factors": {"dose": "1", "mood": "4"}}, {"id": "c", "weights": {"proud": 1}, "factors": {"dose": "2", "mood": "3"}}, {"id": "d", "weights": {"tired": 1}, "factors": {"dose": "3", "mood": "2"}}, {"id": "e", "weights": {"tired": 1}, "factors": {"dose": "4", "mood": "1"}}]})";
constexpr char with_quest[] =
    R"({"questionnaire": {"participants": 4, "trials": "same_different", "adaptive": {"factor": "dose"}}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "factors": {"dose": "0"}}, {"id": "b", "weights": {"sad": 1}, "factors": {"dose": "1"}}, {"id": "c", "weights": {"proud": 1}, "factors": {"dose": "2"}}, {"id": "d", "weights": {"tired": 1}, "factors": {"dose": "3"}}]})";
constexpr char with_levels[] =
    R"({"stimuli": [{"id": "a", "weights": {"normal": 1}, "modify": {"emotion": "sad"}}, {"id": "b", "weights": {"sad": 1}}]})";
constexpr char with_a_range[] =
    R"({"stimuli": [{"id": "a", "weights": {"normal": 1}, "modify": {"emotion": "sad"}, "levels": {"factor": "dose", "of": "modify.strength", "values": {}}}, {"id": "b", "weights": {"sad": 1}}]})";
constexpr char with_whole_levels[] =
    R"({"stimuli": [{"id": "a", "weights": {"normal": 1}, "modify": {"emotion": "sad"}, "levels": {"factor": "dose", "of": "modify.weight", "values": {}}}, {"id": "b", "weights": {"sad": 1}}]})";
constexpr char with_same_different[] =
    R"({"questionnaire": {"participants": 4, "trials": "same_different"}, "output": {"video": ["mp4"]}})";
constexpr char with_same_different_and_factors[] =
    R"({"questionnaire": {"participants": 4, "trials": "same_different"}, "output": {"video": ["mp4"]}, "stimuli": [{"id": "a", "weights": {"normal": 1}, "factors": {"actor": "k", "mood": "x"}}, {"id": "b", "weights": {"sad": 1}, "factors": {"actor": "m", "mood": "y"}}, {"id": "c", "weights": {"sad": 1}, "factors": {"actor": "k", "mood": "y"}}]})";
constexpr char with_screening[] =
    R"({"questionnaire": {"participants": 4, "scales": "all", "screening": {"questions": [{"id": "age", "ask": "How old?", "answer": "number"}]}}, "output": {"video": ["mp4"]}})";
constexpr char with_prolific[] =
    R"({"questionnaire": {"participants": 4, "scales": "all", "recruitment": {"prolific": {"completed": "DONE"}}}, "output": {"video": ["mp4"]}})";

constexpr char with_matching[] =
    R"({"matching": {"participants": 4}, "stimuli": [{"id": "a", "role": "target", "weights": {"normal": 1}}, {"id": "b", "role": "target", "weights": {"sad": 1}}, {"id": "c", "weights": {"proud": 1}}]})";

constexpr char with_adaptive[] =
    R"({"adaptive": {"participants": 4, "method": "gibbs", "words": ["sad"], "space": {"groups": "all"}}})";

constexpr char with_languages[] =
    R"({"adaptive": {"participants": 4, "method": "gibbs", "words": {"sad": {"en": "sad", "ja": "悲しい"}}, "space": {"groups": "all"}}})";

constexpr char without_space[] =
    R"({"adaptive": {"participants": 4, "method": "gibbs", "words": ["sad"]}})";

constexpr char with_choices[] =
    R"({"adaptive": {"participants": 4, "method": "mcmc", "words": ["sad"], "space": {"groups": "all"}}})";

constexpr char with_shared_chains[] =
    R"({"adaptive": {"participants": 100, "method": "gibbs", "words": ["sad"], "space": {"groups": "all"}, "across_participants": true}})";

constexpr char with_several_chains[] =
    R"({"adaptive": {"participants": 100, "method": "gibbs", "words": ["sad"], "space": {"groups": "all"}, "across_participants": true, "chains": 2}})";

constexpr char with_attention_checks[] =
    R"({"adaptive": {"participants": 4, "method": "gibbs", "words": ["sad"], "space": {"groups": "all"}, "attention": {"every": 5}}})";

constexpr char with_shared_steps[] =
    R"({"adaptive": {"participants": 100, "method": "gibbs", "words": ["sad"], "space": {"groups": "all"}, "across_participants": true, "people_per_step": 2}})";

constexpr char with_people[] =
    R"({"stimuli": [{"id": "a", "people": [{"weights": {"normal": 1}, "place": {}}, {"weights": {"sad": 1}, "place": {"x": 1}}]}, {"id": "b", "weights": {"tired": 1}}, {"id": "c", "weights": {"proud": 1}}]})";

constexpr char with_faces[] = R"({"look": {"figure": {"character": "face.gltf"}}})";

constexpr char with_faces_of_people[] =
    R"({"look": {"figure": {"character": "face.gltf"}}, "stimuli": [{"id": "a", "people": [{"weights": {"normal": 1}, "place": {}}, {"weights": {"sad": 1}, "place": {"x": 1}}]}, {"id": "b", "weights": {"tired": 1}}]})";

const Surroundings surroundings[] = {
    {"people[].look.face.take", with_faces_of_people, R"({"file": "face.gltf"})"},
    {"people[].look.face.fps", with_faces_of_people, R"({"file": "frames.csv"})"},
    {"people[].look.face.start", with_faces_of_people, R"({"file": "rise.csv"})"},
    {"people[].look.face", with_faces_of_people, "{}"},
    {"look.face.take", with_faces, R"({"file": "face.gltf"})"},
    {"look.face.fps", with_faces, R"({"file": "frames.csv"})"},
    {"look.face.start", with_faces, R"({"file": "rise.csv"})"},
    {"look.face", with_faces, "{}"},
    {"stimuli[].people[].", with_people, "{}"},
    {"stimuli[].people", with_people, "{}"},
    {"stimuli[].swap", with_people, "{}"},
    {"stimuli[].audio.file", with_sounds, R"({"length": "cut"})"},
    {"stimuli[].audio.from", with_sounds, R"({"length": "cut"})"},
    {"stimuli[].audio.length", with_sounds, R"({"file": "one.wav"})"},
    {"stimuli[].audio.", with_sounds, R"({"file": "one.wav", "length": "cut"})"},
    {"stimuli[].audio", with_sounds, "{}"},
    {"equalize.loudness", with_sounds, "{}"},
    {"mismatch.", with_exchanged_sounds, "{}"},
    {"mismatch", with_exchanged_sounds, "{}"},
    {"modify.freeze.at", "{}", R"({"parts": "legs"})"},
    {"modify.drives[].limb", "{}", R"({"body": "right-foot-forward", "scale": 2})"},
    {"modify.drives[].body", "{}", R"({"limb": "left-hand-forward", "scale": 2})"},
    {"modify.drives[].", "{}", R"({"limb": "left-hand-forward", "body": "right-foot-forward"})"},
    {"modify.keys[].at", "{}", R"({"left-hand": [0.3, 1.2, 0.3]})"},
    {"modify.keys[].relative", "{}", R"({"at": 0.2, "left-hand": [0.3, 1.2, 0.3]})"},
    {"modify.keys[].reach", "{}", R"({"at": 0.2, "left-hand": [0.3, 1.2, 0.3]})"},
    {"modify.keys[].", "{}", R"({"at": 0.2})"},
    {"modify.constraints[].part", "{}",
     R"({"place": [0.1, 1.2, 0.3], "from": 0.2, "to": 0.5, "reach": 0.2})"},
    {"modify.constraints[].relative", "{}",
     R"({"part": "left-hand", "place": [0.3, 1.2, 0.3], "from": 0.2, "to": 0.5})"},
    {"modify.constraints[].from", "{}",
     R"({"part": "left-hand", "place": [0.3, 1.2, 0.3], "to": 0.6})"},
    {"modify.constraints[].to", "{}",
     R"({"part": "left-hand", "place": [0.3, 1.2, 0.3], "from": 0.2})"},
    {"modify.constraints[].reach", "{}",
     R"({"part": "left-hand", "place": [0.3, 1.2, 0.3], "from": 0.4, "to": 0.5})"},
    {"modify.constraints[].stays", "{}", R"({"part": "left-hand", "from": 0.2, "to": 0.6})"},
    {"modify.constraints[].follows[].", "{}", "{}"},
    {"modify.constraints[].angle", "{}", R"({"at_least": 30})"},
    {"modify.constraints[].distance_to", "{}", R"({"part": "left-hand", "at_most": 0.2})"},
    {"modify.constraints[].at_", "{}", R"({"part": "left-hand", "distance_to": "right-hand"})"},
    {"modify.constraints[].look_at", "{}", "{}"},
    {"modify.constraints[].within.", "{}", "{}"},
    {"modify.constraints[].", "{}", R"({"part": "left-hand"})"},
    {"matching.demographics[].", with_matching,
     R"({"id": "age", "ask": "How old?", "answer": "text"})"},
    {"matching", with_matching, "{}"},
    {"questionnaire.recruitment.prolific.", with_prolific, "{}"},
    {"questionnaire.recruitment.pseudonymise", with_prolific, "{}"},
    {"questionnaire.analysis.quality.repeated_by",
     R"({"questionnaire": {"participants": 4, "scales": "all", "recruitment": {"url_parameters": ["a", "b"]}}, "output": {"video": ["mp4"]}})",
     "{}"},
    {"questionnaire.analysis.contrasts[].weights", with_crossed_factors, R"({"name": "c"})"},
    {"questionnaire.analysis.contrasts[].", with_crossed_factors,
     R"({"name": "c", "weights": {"actor": {"k": 1, "m": -1}}})"},
    {"questionnaire.analysis.contrasts", with_crossed_factors, "{}"},
    {"questionnaire.analysis.factors", with_crossed_factors, "{}"},
    {"questionnaire.analysis.between", with_crossed_factors, "{}"},
    {"questionnaire.screening.questions[].accept.", with_screening, "{}"},
    {"questionnaire.screening.questions[].accept", with_screening,
     R"({"answer": ["f", "m", "x"]})"},
    {"questionnaire.screening.quotas[].of.", with_screening, "{}"},
    {"questionnaire.screening.quotas[].of", with_screening, R"({"at_most": 3})"},
    {"questionnaire.screening.quotas[].", with_screening, R"({"of": {"age": {"from": 18}}})"},
    {"questionnaire.screening.quotas", with_screening, "{}"},
    {"questionnaire.screening.questions[].", with_screening, "{}"},
    {"questionnaire.order", with_questions_and_factors, "{}"},
    {"questionnaire.no_repeats", with_questions_and_factors, "{}"},
    {"questionnaire.view", with_questions_and_glb, "{}"},
    {"questionnaire.choices", with_questions, R"({"trials": "emotion"})"},
    {"questionnaire.pairs", with_questions, R"({"trials": "pair"})"},
    {"questionnaire.consent_version", with_questions, R"({"consent": "Yes."})"},
    {"questionnaire.answer.suggest", with_questions, R"({"words": true})"},
    {"questionnaire.display.distance_cm", with_questions, R"({"size": {"degrees": 12}})"},
    {"questionnaire.display.blind_spot", with_questions, R"({"size": {"degrees": 12}})"},
    {"questionnaire.preference.alike", with_crossed_pairs, "{}"},
    {"questionnaire.preference.", with_pairs, "{}"},
    {"questionnaire.best_worst.", with_best_worst, "{}"},
    {"questionnaire.best_worst", with_best_worst, "{}"},
    {"questionnaire.grid.sets", with_grid, "{}"},
    {"questionnaire.grid.reference.", with_grid_of_actors, "{}"},
    {"questionnaire.grid.anchor.", with_grid_of_actors, "{}"},
    {"questionnaire.grid.reference", with_grid_of_actors, "{}"},
    {"questionnaire.grid.anchor", with_grid_of_actors, "{}"},
    {"questionnaire.grid", with_grid, "{}"},
    {"questionnaire.adaptive.until.", with_quest, R"({"sd": 0.5, "at_most": 20})"},
    {"questionnaire.adaptive.until", with_quest, "{}"},
    {"questionnaire.adaptive.step.", with_staircase, "{}"},
    {"questionnaire.adaptive.", with_staircase, "{}"},
    {"questionnaire.adaptive", with_staircase, "{}"},
    {"adaptive.demographics[].", with_adaptive,
     R"({"id": "age", "ask": "How old?", "answer": "text"})"},
    {"adaptive.language.browser", with_languages, "{}"},
    {"adaptive.space.recipe.", without_space, R"({"of": "normal", "paths": [0.5, 1.5]})"},
    {"adaptive.space.", without_space, "{}"},
    {"adaptive.deviation", with_choices, "{}"},
    {"adaptive.trials_per_participant", with_shared_chains, "{}"},
    {"adaptive.answer_within_s", with_shared_chains, "{}"},
    {"adaptive.people_per_step", with_shared_chains, "{}"},
    {"adaptive.aggregate", with_shared_steps, "{}"},
    {"adaptive.until.", with_several_chains, R"({"r_hat": 1.3, "at_most": 25})"},
    {"adaptive.until", with_several_chains, "{}"},
    {"adaptive.attention.max_failed_checks", with_attention_checks, R"({"every": 5})"},
    {"adaptive", with_adaptive, "{}"},
    {"questionnaire.continuous.", with_continuous, "{}"},
    {"questionnaire.continuous", with_continuous, "{}"},
    {"questionnaire.analysis.lag", with_continuous, "{}"},
    {"questionnaire.analysis.quality.post_screening", with_reference, "{}"},
    {"questionnaire.same_different.differ_in", with_same_different_and_factors, "{}"},
    {"questionnaire.same_different.", with_same_different, "{}"},
    {"questionnaire.same_different", with_no_scales, R"({"trials": "same_different"})"},
    {"questionnaire.signal", with_no_scales, R"({"trials": "yes_no", "question": "Is it?"})"},
    {"questionnaire.preference", with_questions, R"({"trials": "pair"})"},
    {"questionnaire.scales.ask",
     R"({"questionnaire": {"participants": 4}, "output": {"video": ["mp4"]}})",
     R"({"file": "my.scales.yaml"})"},
    {"questionnaire.scales.file",
     R"({"questionnaire": {"participants": 4}, "output": {"video": ["mp4"]}})", "{}"},
    {"questionnaire.demographics[].", with_questions,
     R"({"id": "age", "ask": "How old?", "answer": "text"})"},
    {"questionnaire.", with_questions, "{}"},
    {"questionnaire", R"({"output": {"video": ["mp4"]}})", "{}"},
    {"interpolation.neighbours", with_wishes, R"({"method": "knn"})"},
    {"interpolation.blends", with_wishes, R"({"method": "knn"})"},
    {"interpolation.power", with_wishes, R"({"method": "inverse-distance"})"},
    {"interpolation.cells", with_wishes, R"({"method": "grid"})"},
    {"interpolation.nodes", with_wishes, R"({"method": "grid"})"},
    {"interpolation.drift", with_wishes, R"({"method": "kriging"})"},
    {"interpolation.nugget", with_wishes, R"({"method": "kriging"})"},
    {"interpolation.variance", with_wishes, R"({"method": "pca"})"},
    {"interpolation.estimate", with_wishes, R"({"method": "pca"})"},
    {"interpolation.noise", with_wishes, R"({"method": "pca", "estimate": "most-likely"})"},
    {"interpolation.step", with_wishes, R"({"method": "incremental"})"},
    {"interpolation", with_wishes, "{}"},
    {"stimuli[].adjectives", with_wishes, "{}"},
    {"stimuli[].role", R"({"look": {"colours": "role"}})", "{}"},
    {"stimuli[].hold", with_wishes, "{}"},
    {"stimuli[].foil", with_foil, "{}"},
    {"stimuli[].levels.values.whole", with_whole_levels, R"({"from": 0, "to": 3, "steps": 3})"},
    {"stimuli[].levels.values.", with_a_range, R"({"from": 0.1, "to": 0.9, "steps": 4})"},
    {"stimuli[].levels.", with_levels,
     R"({"factor": "dose", "of": "modify.strength", "values": [0.2, 0.4]})"},
    {"stimuli[].levels", with_levels, "{}"},
    {"stimuli[].modify.ends", with_clip, "{}"},
    {"modify.harmonics", "{}", R"({"method": "unuma", "neutral": "normal", "styled": "sad"})"},
    {"modify.order", "{}", R"({"method": "hsu", "neutral": "normal", "styled": "sad"})"},
    {"modify.inputs", "{}", R"({"method": "hsu", "neutral": "normal", "styled": "sad"})"},
    {"modify.components", "{}", R"({"method": "shapiro", "neutral": "normal", "styled": "sad"})"},
    {"modify.swap", "{}", R"({"method": "shapiro", "neutral": "normal", "styled": "sad"})"},
    {"modify.method", "{}", R"({"neutral": "normal", "styled": "sad"})"},
    {"modify.neutral", "{}", R"({"method": "waveshape", "styled": "sad"})"},
    {"modify.styled", "{}", R"({"method": "waveshape", "neutral": "normal"})"},
    {"modify.strength", "{}", R"({"emotion": "sad"})"},
    {"modify.acceleration_at", "{}", R"({"acceleration": 0.5})"},
    {"modify.limbs", "{}", R"({"acceleration": 0.5})"},
    {"modify.signal", "{}", R"({"paths": 0.5})"},
    {"modify.gravity", "{}", R"({"tempo": 1.2})"},
    {"modify.hands", "{}", R"({"paths": 0.5})"},
    {"modify.seed", "{}", R"({"variation": 0.5})"},
    {"modify.pose.neutral.joints", "{}", R"({"motion": "nameless/normal.npz"})"},
    {"modify.pose.posed.joints", "{}", R"({"motion": "nameless/normal.npz"})"},
    {"modify.pose.neutral.licence.", "{}", R"({"name": "CC0"})"},
    {"modify.pose.posed.licence.", "{}", R"({"name": "CC0"})"},
    {"modify.pose.neutral.licence", "{}", R"({"motion": "one/sad.bvh"})"},
    {"modify.pose.posed.licence", "{}", R"({"motion": "one/sad.bvh"})"},
    {"modify.pose.neutral.source", "{}", R"({"motion": "one/sad.bvh"})"},
    {"modify.pose.posed.source", "{}", R"({"motion": "one/sad.bvh"})"},
    {"modify.pose.neutral.subject", "{}", R"({"motion": "one/sad.bvh"})"},
    {"modify.pose.posed.subject", "{}", R"({"motion": "one/sad.bvh"})"},
    {"modify.pose.neutral.body_model", "{}", R"({"motion": "smpl/sad.npz"})"},
    {"modify.pose.posed.body_model", "{}", R"({"motion": "smpl/sad.npz"})"},
    {"modify.pose.neutral.take", "{}", R"({"motion": "takes.gltf"})"},
    {"modify.pose.posed.take", "{}", R"({"motion": "takes.gltf"})"},
    {"modify.pose.neutral.", "{}", R"({"motion": "normal"})"},
    {"modify.pose.posed.", "{}", R"({"motion": "sad"})"},
    {"modify.pose.neutral", "{}", R"({"posed": "sad"})"},
    {"modify.pose.posed", "{}", R"({"neutral": "sad"})"},
    {"output.samples", "{}", R"({"quality": "reference"})"},
    {"on_fault",
     R"({"stimuli": [{"id": "a", "weights": {"normal": 1}, "modify": {"emotion": "sad"}}, {"id": "b", "weights": {"sad": 1}}]})",
     "{}"},
    {"recipes",
     R"({"stimuli": [{"id": "a", "weights": {"normal": 1}, "modify": {"emotion": "sad"}}, {"id": "b", "weights": {"sad": 1}}]})",
     "{}"},
    {"examples.set.body_model", with_folder,
     R"({"folder": "smpl", "include": "*.npz", "cycle": "whole"})"},
    {"examples.set.joints", with_folder,
     R"({"folder": "nameless", "include": "*.npz", "cycle": "whole"})"},
    {"examples.set.fps", with_folder, R"({"folder": "unrated", "cycle": "whole"})"},
    {"examples.set.licence.", with_folder_of_licence, R"({"name": "CC0"})"},
    {"examples.set.take", with_folder, R"({"folder": "takes", "cycle": "whole"})"},
    {"examples.set.", with_folder, R"({"folder": "one", "cycle": "whole"})"},
    {"examples.set", with_a_folder_or_set, "{}"},
    {"examples.scales", R"({"examples": {"ratings": "simulated"}})", "{}"},
    {"examples.expect[].", "{}", R"({"parameter": "quickness", "order": ["sad", "normal"]})"},
    {"stimuli[].features", "{}", "{}"},
    {"stimuli[].clip.frames", "{}", R"({"file": "one/normal.bvh"})"},
    {"stimuli[].clip.joints", "{}", R"({"file": "nameless/normal.npz"})"},
    {"stimuli[].clip.licence.", with_clip, R"({"name": "CC0"})"},
    {"stimuli[].clip.licence", "{}", R"({"file": "one/normal.bvh"})"},
    {"stimuli[].clip.source", "{}", R"({"file": "one/normal.bvh"})"},
    {"stimuli[].clip.take", "{}", R"({"file": "takes.gltf"})"},
    {"stimuli[].clip.subject", "{}", R"({"file": "one/normal.bvh"})"},
    {"stimuli[].clip.body_model", "{}", R"({"file": "smpl/normal.npz"})"},
    {"stimuli[].clip.fps", "{}", R"({"file": "unrated/normal.bvh"})"},
    {"stimuli[].path.script[].walk", "{}", "{}"},
    {"stimuli[].path.script[].turn", "{}", "{}"},
    {"stimuli[].path.script[].stand", "{}", "{}"},
    {"stimuli[].path.script[].", "{}", R"({"walk": 1})"},
    {"stimuli[].path.script", "{}", "{}"},
    {"stimuli[].path.points", "{}", "{}"},
    {"stimuli[].path.graph[].joints", with_graph, R"({"file": "long/nameless.npz"})"},
    {"stimuli[].path.graph[].licence.", with_graph_of_file, R"({"name": "CC0"})"},
    {"stimuli[].path.graph[].licence", with_graph, R"({"file": "long/normal.bvh"})"},
    {"stimuli[].path.graph[].source", with_graph, R"({"file": "long/normal.bvh"})"},
    {"stimuli[].path.graph[].take", with_graph, R"({"file": "long/takes.gltf"})"},
    {"stimuli[].path.graph[].subject", with_graph, R"({"file": "long/normal.bvh"})"},
    {"stimuli[].path.graph[].body_model", with_graph, R"({"file": "long/smpl.npz"})"},
    {"stimuli[].path.graph[].fps", with_graph, R"({"file": "long/unrated.bvh"})"},
    {"stimuli[].path.graph[].file", with_graph, "{}"},
    {"stimuli[].path.graph", "{}", R"({"script": [{"walk": 1}]})"},
    {"stimuli[].path.threshold_m", "{}",
     R"({"graph": ["long/normal.bvh", "long/sad.bvh"], "script": [{"walk": 1}]})"},
    {"stimuli[].path.moods[].at", with_points, R"({"mood": {"sad": 1}})"},
    {"stimuli[].path.moods[].mood", with_points, R"({"at": 0.1})"},
    {"stimuli[].path.moods", with_points, "{}"},
    {"stimuli[].path.", "{}", R"({"script": [{"walk": 1}]})"},
    {"camera.position", "{}", R"({"target": [0, 1, 0]})"},
    {"camera.target", "{}", R"({"position": [3, 1, 1]})"},
    {"screen.distance_cm", "{}", R"({"width_cm": 50})"},
    {"screen.width_cm", "{}", R"({"distance_cm": 60})"},
    {"screen.degrees", "{}", R"({"distance_cm": 60, "width_cm": 50})"},
    {"look.figure.markers.lifetime", with_markers, R"({"pairs": [["LeftHip", "LeftKnee"]]})"},
    {"look.figure.markers", with_markers, "{}"},
    {"trail.every", "{}", R"({"before": 2})"},
    {"trail.min_opacity", "{}", R"({"before": 2})"},
    {"trail.trace_width", "{}", R"({"traces": ["hands"]})"},
    {"look.scene.background", "{}", R"({"set": "studio"})"},
    {"card.seconds", "{}", R"({"text": "Look"})"},
    {"fixation.size", "{}", R"({"seconds": 0.2})"},
    {"overlays[].opacity", with_overlay, "{}"},
    {"overlays[].layout", with_overlay, "{}"},
    {"sheets[].compare.", R"({"sheets": [{"compare": {"target": "a", "created": "b"}}]})", "{}"},
    {"sheets[].id", R"({"sheets": [{"compare": {"target": "a", "created": "b"}}]})", "{}"},
    {"sheets[].columns", with_stills, R"({"stills": ["a", "b"], "compare": null})"},
    {"sheets[].stills", with_stills, R"({"compare": null})"},
    {"sheets[].gallery", "{}", R"({"compare": null})"},
};

/// Values that the schema's own examples and limits do not give, or that would take long.
struct Values {
  const char* path;
  const char* two;
};

const Values chosen_values[] = {
    {"stimuli[].people",
     R"([[{"weights": {"normal": 1}, "place": {}}, {"weights": {"sad": 1}, "place": {"x": 1}}],
         [{"weights": {"normal": 1}, "place": {}}, {"weights": {"tired": 1}, "place": {"x": 1}}]])"},
    {"people[].name", R"(["x", "y"])"},
    {"people[].place", R"([{"x": 0.5}, {"z": 0.5}])"},
    {"people[].place.x", "[0.5, -0.5]"},
    {"people[].place.z", "[0.5, -0.5]"},
    {"people[].place.turn", "[45, 90]"},
    {"people[].start", "[0.2, 0.5]"},
    {"people[].look", R"([{"colour": "#112233"}, {"figure": "mannequin"}])"},
    {"people[].look.colour", R"(["#112233", "#445566"])"},
    {"stimuli[].swap", R"([{"b": "b"}, {"b": "c"}])"},
    {"stimuli[].audio",
     R"([{"file": "one.wav", "length": "cut"}, {"file": "two.wav", "length": "cut"}])"},
    {"stimuli[].audio.file", R"(["one.wav", "two.wav"])"},
    {"stimuli[].audio.from", R"(["b", "c"])"},
    {"stimuli[].audio.offset", "[0.5, -0.5]"},
    {"stimuli[].audio.gain", "[-3, -6]"},
    {"stimuli[].audio.length", R"(["cut", "hold"])"},
    {"equalize.loudness", "[true, -30]"},
    {"mismatch", R"([{"audio": "derange", "seed": 1}, {"audio": "derange", "seed": 6}])"},
    {"mismatch.seed", "[1, 6]"},
    {"mismatch.stimuli", R"([["a", "b"], ["b", "c"]])"},
    {"modify.freeze", R"(["legs", ["legs", "head"]])"},
    {"modify.freeze.parts", R"(["legs", ["trunk", "arms"]])"},
    {"modify.freeze.at", R"([0.2, "frame 3"])"},
    {"modify.ends", R"([{"before": 0.1}, {"before": 0.1, "after": 0.2}])"},
    {"modify.ends.before", "[0.1, 0.2]"},
    {"modify.ends.after", "[0.1, 0.2]"},
    {"modify.drives",
     R"([[{"limb": "left-hand-forward", "body": "right-foot-forward", "scale": 2}], [{"limb": "left-hand-forward", "body": "right-foot-forward", "scale": 3}]])"},
    {"modify.drives[].scale", "[0.5, 2]"},
    {"modify.drives[].shift", "[0.05, 0.1]"},
    {"modify.keys", R"([[{"at": 0.2, "left-hand": [0.3, 1.2, 0.3]}],
                        [{"at": 0.4, "left-hand": [0.3, 1.2, 0.3]}]])"},
    {"modify.keys[].at", R"([0.2, "frame 3"])"},
    {"modify.keys[].reach", "[0.2, 0.4]"},
    {"modify.keys[].relative", R"(["body", "room"])"},
    {"modify.constraints[].relative", R"(["body", "room"])"},
    {"modify.constraints[].stays", R"(["position", "orientation"])"},
    {"modify.keys[].left-foot", "[[0.1, 0.1, 0], [0.1, 0.05, 0]]"},
    {"modify.keys[].right-foot", "[[-0.1, 0.1, 0], [-0.1, 0.05, 0]]"},
    {"modify.keys[].pelvis", "[[0, 0.88, 0], [0, 0.85, 0]]"},
    {"modify.keys[].", "[[0.1, 1.2, 0.3], [0, 1.3, 0.4]]"},
    {"modify.constraints",
     R"([[{"part": "left-hand", "place": [0.3, 1.2, 0.3]}], [{"part": "left-hand", "place": [0.3, 1, 0.3]}]])"},
    {"modify.constraints[].part", R"(["left-hand", "right-hand"])"},
    {"modify.constraints[].from", R"([0.2, "frame 2"])"},
    {"modify.constraints[].to", R"([0.4, "frame 3"])"},
    {"modify.constraints[].reach", "[0.05, 0.2]"},
    {"modify.constraints[].follows",
     R"([[{"at": 0.2, "place": [0.3, 1, 0.3]}, {"at": 0.5, "place": [0.3, 1.2, 0.3]}],
         [{"at": 0.2, "place": [0.3, 1.1, 0.3]}, {"at": 0.5, "place": [0.3, 1.2, 0.3]}]])"},
    {"modify.constraints[].follows[].at", "[0.1, 0.3]"},
    {"modify.constraints[].follows[].place", "[[0.3, 1.1, 0.3], [0.3, 1.2, 0.3]]"},
    {"modify.constraints[].within", R"([{"y": [1, 1.2]}, {"y": [1.1, 1.3]}])"},
    {"modify.constraints[].within.x", "[[0.3, 0.4], [0.4, 0.5]]"},
    {"modify.constraints[].within.y", "[[1, 1.1], [1.1, 1.2]]"},
    {"modify.constraints[].within.z", "[[0.2, 0.3], [0.3, 0.4]]"},
    {"modify.constraints[].distance_to", R"(["right-hand", "pelvis"])"},
    {"modify.constraints[].at_least", "[0.8, 0.9]"},
    {"modify.constraints[].at_most", "[0.2, 0.3]"},
    {"modify.constraints[].angle", R"(["left-elbow-flexion", "right-elbow-flexion"])"},
    {"modify.constraints[].", "[[0.3, 1.2, 0.3], [0.3, 1, 0.3]]"},
    // The first figure of a file, by number and by the name of its root.
    {"clip.subject", R"(["1", "Pelvis"])"},
    {"set.subject", R"(["1", "Pelvis"])"},
    {"graph[].subject", R"(["1", "Pelvis"])"},
    {"neutral.subject", R"(["1", "Pelvis"])"},
    {"posed.subject", R"(["1", "Pelvis"])"},
    {"clip.body_model", R"(["small.npz", "tall.npz"])"},
    {"set.body_model", R"(["small.npz", "tall.npz"])"},
    {"graph[].body_model", R"(["small.npz", "tall.npz"])"},
    {"neutral.body_model", R"(["small.npz", "tall.npz"])"},
    {"posed.body_model", R"(["small.npz", "tall.npz"])"},
    {".licence", R"(["CC0", "MIT"])"},
    {".licence.name", R"(["CC0", "MIT"])"},
    {".licence.share", "[true, false]"},
    {".source", R"(["example.org", "example.com"])"},
    {"clip.fps", "[40, 50]"},
    {"set.fps", "[40, 50]"},
    {"graph[].fps", "[40, 50]"},
    {"stimuli[].path", R"([[{"walk": 1}], {"points": [[0, 0], [0, 1]]}])"},
    {"stimuli[].path.script", R"([[{"walk": 1}], [{"turn": 30}]])"},
    {"stimuli[].path.script[].walk", "[1, 1.5]"},
    {"stimuli[].path.script[].turn", "[30, -30]"},
    {"stimuli[].path.script[].stand", "[0.5, 1]"},
    {"stimuli[].path.script[].pace", "[0.5, 1]"},
    {"stimuli[].path.graph[].take", R"(["Walk", "Stand"])"},
    {"stimuli[].path.graph[].file", R"(["long/normal.bvh", "long/sad.bvh"])"},
    {"stimuli[].path.graph", R"([["long/normal.bvh"], ["long/normal.bvh", "long/sad.bvh"]])"},
    {"stimuli[].path.threshold_m", "[0.1, 0.2]"},
    {"stimuli[].path.points", "[[[0, 0], [0, 1]], [[0, 0], [0.5, 1]]]"},
    {"stimuli[].path.pace", "[0.5, 1]"},
    {"stimuli[].path.set", R"(["builtin:walks-10", "builtin:walks-27"])"},
    {"stimuli[].path.mood", R"([{"sad": 1}, {"sad": 1, "happy": 1}])"},
    {"stimuli[].path.script[].mood", R"([{"sad": 1}, {"sad": 1, "happy": 1}])"},
    {"stimuli[].path.moods",
     R"([[{"at": 0.1, "mood": {"sad": 1}}], [{"at": 0.2, "mood": {"sad": 1}}]])"},
    {"stimuli[].path.moods[].at", "[0.1, 0.2]"},
    {"stimuli[].path.moods[].mood", R"([{"sad": 1}, {"happy": 1}])"},
    {"adaptive",
     R"([{"participants": 4, "method": "gibbs", "words": ["sad"], "space": {"groups": "all"}}, {"participants": 5, "method": "mcmc", "words": ["sad"], "space": {"features": "all"}}])"},
    {"adaptive.title", R"(["Sad?", "How sad?"])"},
    {"adaptive.language", R"(["en", "ja"])"},
    {"adaptive.language.browser", R"([["en"], ["ja", "en"]])"},
    {"adaptive.texts", R"(["one.texts.yaml", ["two.texts.yaml"]])"},
    {"adaptive.consent", R"(["Yes.", "No."])"},
    {"adaptive.consent.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"adaptive.instructions", R"(["Look.", "Look well."])"},
    {"adaptive.instructions.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"adaptive.ending", R"(["Thanks.", "The end."])"},
    {"adaptive.ending.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"adaptive.words", R"([["sad"], {"sad": "sorrowful"}])"},
    {"adaptive.space", R"([{"groups": "all"}, {"features": "all"}])"},
    {"adaptive.space.groups", R"(["all", ["quickness", "largeness"]])"},
    {"adaptive.space.scales", R"([["slow-fast"], ["slow-fast", "sad-happy"]])"},
    {"adaptive.space.features", R"(["all", ["step-length"]])"},
    {"adaptive.space.weights", R"(["all", ["sad", "normal"]])"},
    {"adaptive.space.components", "[1, 2]"},
    {"adaptive.until", R"([{"r_hat": 1.1, "at_most": 30}, {"r_hat": 1.2, "at_most": 40}])"},
    {"adaptive.until.r_hat", "[1.1, 1.2]"},
    {"adaptive.until.at_least", "[8, 9]"},
    {"adaptive.until.at_most", "[20, 30]"},
    {"adaptive.attention", R"([{"every": 5}, {"every": 6}])"},
    {"adaptive.colour", R"(["#112233", "#445566"])"},
    {"adaptive.demographics",
     R"([[{"id": "age", "ask": "How old?", "answer": "number"}], [{"id": "sex", "ask": "Which?", "answer": ["f", "m"]}]])"},
    {"adaptive.demographics[].id", R"(["age", "sex"])"},
    {"adaptive.demographics[].ask", R"(["Who?", "Which?"])"},
    {"adaptive.demographics[].answer", R"(["number", ["f", "m"]])"},
    {"matching", R"([{"participants": 4}, {"participants": 5, "limit_s": 100}])"},
    {"matching.title", R"(["Same?", "Alike?"])"},
    {"matching.language", R"(["en", "ja"])"},
    {"matching.language.browser", R"([["en"], ["ja", "en"]])"},
    {"matching.texts", R"(["one.texts.yaml", ["two.texts.yaml"]])"},
    {"matching.targets", R"([["a"], ["a", "b"]])"},
    {"matching.practice", R"([["b"], ["c"]])"},
    {"matching.interfaces", R"([["adjectives"], ["weights", "features"]])"},
    {"matching.primary", R"([["quickness"], ["quickness", "largeness"]])"},
    {"matching.pairs_offered", R"([["slow-fast"], ["quickness"]])"},
    {"matching.features", R"([["step-length"], ["step-length", "lateral-swing"]])"},
    {"matching.target_colour", R"(["#112233", "#445566"])"},
    {"matching.created_colour", R"(["#112233", "#445566"])"},
    {"matching.consent", R"(["Yes.", "No."])"},
    {"matching.consent.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"matching.instructions", R"(["Look.", "Look well."])"},
    {"matching.instructions.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"matching.ending", R"(["Thanks.", "The end."])"},
    {"matching.ending.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"matching.show_examples", "[false, true]"},
    {"matching.demographics",
     R"([[{"id": "age", "ask": "How old?", "answer": "number"}], [{"id": "sex", "ask": "Which?", "answer": ["f", "m"]}]])"},
    {"matching.demographics[].id", R"(["age", "sex"])"},
    {"matching.demographics[].ask", R"(["Who?", "Which?"])"},
    {"matching.demographics[].answer", R"(["number", ["f", "m"]])"},
    {"stimuli[].path.threshold_m", "[0.06, 0.5]"},
    {"design", R"([{"threshold_m": 0.03}, {"threshold_m": 0.04}])"},
    {"design.alike", R"([["example"], []])"},
    {"design.varies", R"([{"example": ["figure"]}, {"example": ["speed"]}])"},
    {"regression", R"([{"position_mm": 1}, {"position_mm": 2}])"},
    {"regression.parts_mm", R"([{"left hand": 5}, {"left hand": 6}])"},
    {"questionnaire",
     R"([{"participants": 4, "scales": "all"}, {"participants": 5, "scales": "emotions"}])"},
    {"questionnaire.title", R"(["How?", {"en": "How?", "ja": "どう？"}])"},
    {"questionnaire.language", R"(["en", "ja"])"},
    {"questionnaire.language.browser", R"([["en"], ["ja", "en"]])"},
    {"questionnaire.texts", R"(["one.texts.yaml", ["two.texts.yaml"]])"},
    {"questionnaire.consent", R"(["Yes.", "No."])"},
    {"questionnaire.consent_version", R"(["1", "2"])"},
    {"questionnaire.instructions", R"(["Look.", "Look well."])"},
    {"questionnaire.debriefing", R"(["It was about walks.", "It was about style."])"},
    {"questionnaire.debriefing.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"questionnaire.screening", R"([{"refresh_hz": 50}, {"refresh_hz": 100}])"},
    {"questionnaire.screening.questions",
     R"([[{"id": "age", "ask": "How old?", "answer": "number"}], [{"id": "eyes", "ask": "Do you see well?", "answer": ["yes", "no"]}]])"},
    {"questionnaire.screening.questions[].id", R"(["age", "years"])"},
    {"questionnaire.screening.questions[].ask", R"(["How old?", "Your age?"])"},
    {"questionnaire.screening.questions[].answer", R"(["number", ["young", "old"]])"},
    {"questionnaire.screening.questions[].accept", R"([["f"], ["m", "x"]])"},
    {"questionnaire.screening.questions[].accept.from", "[18, 21]"},
    {"questionnaire.screening.questions[].accept.to", "[65, 70]"},
    {"questionnaire.screening.quotas",
     R"([[{"of": {"age": {"from": 18}}, "at_most": 3}], [{"of": {"age": {"from": 18}}, "at_most": 4}]])"},
    {"questionnaire.screening.quotas[].of", R"([{"age": {"from": 18}}, {"age": {"to": 30}}])"},
    {"questionnaire.screening.quotas[].of.from", "[18, 21]"},
    {"questionnaire.screening.quotas[].of.to", "[65, 70]"},
    {"questionnaire.screening.quotas[].at_most", "[3, 4]"},
    {"questionnaire.screening.window", "[[800, 600], [1000, 600]]"},
    {"questionnaire.screening.refresh_hz", "[50, 100]"},
    {"questionnaire.recruitment", R"([{"url_parameters": ["a"]}, {"url_parameters": ["b"]}])"},
    {"questionnaire.recruitment.url_parameters", R"([["a"], ["b"]])"},
    {"questionnaire.recruitment.prolific", R"([{"completed": "DONE"}, {"completed": "ENDED"}])"},
    {"questionnaire.recruitment.prolific.completed", R"(["DONE", "ENDED"])"},
    {"questionnaire.recruitment.prolific.screened_out", R"(["OUT", "SORRY"])"},
    {"questionnaire.recruitment.prolific.refused", R"(["NO", "NOT"])"},
    {"questionnaire.recruitment.prolific.withdrawn", R"(["LEFT", "GONE"])"},
    {"questionnaire.recruitment.prolific.failed_attention", R"(["FAILED", "MISSED"])"},
    {"questionnaire.recruitment.redirect",
     R"([{"completed": "https://a.org"}, {"completed": "https://b.org"}])"},
    {"questionnaire.recruitment.redirect.completed", R"(["https://a.org", "https://b.org"])"},
    {"questionnaire.recruitment.redirect.screened_out", R"(["https://a.org", "https://b.org"])"},
    {"questionnaire.recruitment.redirect.refused", R"(["https://a.org", "https://b.org"])"},
    {"questionnaire.recruitment.redirect.withdrawn", R"(["https://a.org", "https://b.org"])"},
    {"questionnaire.recruitment.redirect.failed_attention",
     R"(["https://a.org", "https://b.org"])"},
    {"questionnaire.analysis.quality", R"([{"min_rt_ms": 200}, {"min_rt_ms": 300}])"},
    {"questionnaire.analysis.quality.repeated_by", R"(["a", "b"])"},
    {"questionnaire.ending", R"(["Thanks.", "The end."])"},
    {"questionnaire.analysis.plan", R"(["One test.", "Two tests."])"},
    {"questionnaire.consent.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"questionnaire.instructions.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"questionnaire.ending.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"questionnaire.analysis.plan.file", R"(["my.set.yaml", "my.scales.yaml"])"},
    {"questionnaire.question", R"(["How?", "What?"])"},
    {"questionnaire.stimuli", R"([["a"], ["b", "a"]])"},
    {"questionnaire.per_participant", "[1, 2]"},
    {"questionnaire.trials", R"(["rating", "pair"])"},
    {"questionnaire.scales", R"([["sad-happy"], "emotions"])"},
    {"questionnaire.scales.file", R"(["my.scales.yaml", "other.scales.yaml"])"},
    {"questionnaire.scales.ask", R"([["slow-quick"], ["big-small"]])"},
    {"questionnaire.choices", R"([["sad", "happy"], {"sad": "S", "happy": "H"}])"},
    {"questionnaire.pairs", R"([[["a", "b"]], [["b", "a"]]])"},
    {"questionnaire.best_worst", R"([{"size": 3, "sets": 2}, {"size": 3, "sets": 5}])"},
    {"questionnaire.best_worst.size", "[3, 4]"},
    {"questionnaire.best_worst.sets", "[4, 5]"},
    {"questionnaire.adaptive", R"([{"factor": "dose"}, {"factor": "mood"}])"},
    {"questionnaire.adaptive.factor", R"(["dose", "mood"])"},
    {"questionnaire.adaptive.trials", "[30, 50]"},
    {"questionnaire.adaptive.tracks", "[2, 3]"},
    {"questionnaire.adaptive.proportion", "[0.6, 0.8]"},
    {"questionnaire.adaptive.until", R"([{"sd": 0.5, "at_most": 20}, {"sd": 0.4, "at_most": 20}])"},
    {"questionnaire.adaptive.until.sd", "[0.3, 0.4]"},
    {"questionnaire.adaptive.until.at_most", "[30, 50]"},
    {"adaptive.space.recipe",
     R"([{"of": "normal", "paths": [0.5, 1.5]}, {"of": "normal", "tempo": [0.8, 1.2]}])"},
    {"adaptive.space.recipe.of", R"(["normal", "sad"])"},
    {"adaptive.space.recipe.emotions", R"([{"sad": [0, 1.5]}, {"sad": [0, 1]}])"},
    {"adaptive.space.recipe.posture",
     R"([{"head-flexion": [-10, 30]}, {"head-flexion": [-10, 20]}])"},
    {"adaptive.space.recipe.paths", "[[0.5, 1.4], [0.6, 1.4]]"},
    {"adaptive.space.recipe.acceleration", "[[-0.5, 0.5], [-0.4, 0.5]]"},
    {"adaptive.space.recipe.tempo", "[[0.7, 1.4], [0.8, 1.4]]"},
    {"questionnaire.adaptive.step", R"([2, {"up": 3, "down": 1}])"},
    {"questionnaire.adaptive.step.up", "[2, 3]"},
    {"questionnaire.adaptive.step.down", "[2, 3]"},
    {"questionnaire.continuous", R"([{"lead": 2}, {"lead": 3}])"},
    {"questionnaire.grid", R"([{"alike": ["actor"]}, {"alike": ["mood"]}])"},
    {"questionnaire.grid.alike", R"([["actor"], ["mood"]])"},
    {"questionnaire.grid.sets", R"([[["a", "b"]], [["b", "a"], ["c", "d"]]])"},
    {"questionnaire.grid.reference", R"([["a", "b"], ["c", "d"]])"},
    {"questionnaire.grid.anchor", R"([["a", "b"], ["c", "d"]])"},
    {"questionnaire.same_different", R"([{"same": 0.3}, {"same": 0.6}])"},
    {"questionnaire.same_different.differ_in", R"(["actor", "mood"])"},
    {"questionnaire.signal", R"([["a"], ["b"]])"},
    {"questionnaire.display", R"([{"size": "native"}, {"size": {"cm": 12}}])"},
    {"questionnaire.display.size", R"(["native", {"degrees": 12}])"},
    {"questionnaire.display.distance_cm", "[57, 60]"},
    {"questionnaire.preference.alike", R"([["actor"], ["mood"]])"},
    {"questionnaire.preference", R"([{"ties": true}, {"strength": true}])"},
    {"questionnaire.answer.suggest", R"([["happy"], ["happy", "sad"]])"},
    {"questionnaire.answer", R"([{"points": 7}, {"slider": true}])"},
    {"questionnaire.order", R"(["full", {"blocked": "actor"}])"},
    {"questionnaire.order.blocked", R"(["actor", "mood"])"},
    {"questionnaire.no_repeats", R"([["actor"], ["mood"]])"},
    {"questionnaire.practice", R"([["a"], ["b"]])"},
    {"questionnaire.warm_up", "[1, 2]"},
    {"questionnaire.attention", R"([{"every": 2}, {"every": 3}])"},
    {"questionnaire.retest", R"([{"repeat": 1}, {"repeat": 2}])"},
    {"questionnaire.retest.repeat", "[1, 2]"},
    {"questionnaire.replays", R"(["none", 3])"},
    {"questionnaire.reference", R"(["a", "b"])"},
    {"questionnaire.demographics",
     R"([[{"id": "age", "ask": "How old?", "answer": "number"}], [{"id": "sex", "ask": "Which?", "answer": ["f", "m"]}]])"},
    {"questionnaire.demographics[].id", R"(["age", "sex"])"},
    {"questionnaire.demographics[].ask", R"(["Who?", "Which?"])"},
    {"questionnaire.demographics[].answer", R"(["number", ["f", "m"]])"},
    {"questionnaire.pace", R"([{"answer": 2}, {"answer": 3}])"},
    {"questionnaire.pace.words_per_minute", "[100, 200]"},
    {"questionnaire.analysis", R"([{"alpha": 0.01}, {"alpha": 0.05}])"},
    {"questionnaire.analysis.alpha", "[0.01, 0.05]"},
    {"questionnaire.analysis.factors", R"([["actor"], ["actor", "mood"]])"},
    {"questionnaire.analysis.between", R"(["sex", "hand"])"},
    {"questionnaire.analysis.contrasts",
     R"([[{"name": "c", "weights": {"actor": {"k": 1, "m": -1}}}], [{"name": "c", "weights": {"mood": {"x": 1, "y": -1}}}]])"},
    {"questionnaire.analysis.contrasts[].name", R"(["c", "d"])"},
    {"questionnaire.analysis.contrasts[].weights",
     R"([{"actor": {"k": 1, "m": -1}}, {"actor": {"k": 1, "m": -1}, "mood": {"x": 1, "y": -1}}])"},
    {"questionnaire.analysis.contrasts[].at", R"([{"mood": "x"}, {"mood": "y"}])"},
    {"questionnaire.analysis.contrasts[].scales", R"([["weak-strong"], ["slow-fast"]])"},
    {"stimuli[].hold", R"(["others", {"largeness": 0.6}])"},
    {"stimuli[].foil.of", R"(["b", "c"])"},
    {"stimuli[].foil.differ", R"(["posture", "path-length"])"},
    {"stimuli[].foil",
     R"([{"of": "b", "differ": "posture"}, {"of": "b", "differ": "path-length"}])"},
    {"output.size", "[[32, 24], [40, 24]]"},
    {"output.scale", "[0.8, 0.9]"},
    {"output.crop", "[[0, 0, 16, 16], [8, 0, 16, 16]]"},
    {"output.fps", "[5, 6]"},
    {"output.cycles", "[1, 2]"},
    {"output.video", R"([["gif"], ["gif", "apng"]])"},
    {"output.clips", R"([["bvh", "trc", "npz", "npy", "csv"], []])"},
    {"card.seconds", "[0.2, 0.4]"},
    {"presentation.card", R"([{"text": "A", "seconds": 0.2}, {"text": "B", "seconds": 0.2}])"},
    {"card.text", R"(["A", "B"])"},
    {"presentation.fixation.size", "[7, 9]"},
    {"presentation", R"([{"blank_after": 0.2}, {"blank_after": 0.4}])"},
    {"blank_before", "[0.2, 0.4]"},
    {"blank_after", "[0.2, 0.4]"},
    {"fade_in", "[0.2, 0.4]"},
    {"fade_out", "[0.2, 0.4]"},
    {"presentation.background", "[0.2, 0.4]"},
    {"presentation.fixation", "[0.2, 0.4]"},
    {"fixation.seconds", "[0.2, 0.4]"},
    {"output.samples", "[1, 2]"},
    {"output.shutter", "[90, 180]"},
    {"study", R"(["s", "t"])"},
    {"mien", "[1]"},
    {"seed", "[1, 2]"},
    {"raters", "[5, 9]"},
    {"examples.set.folder", R"(["one", "two"])"},
    {"examples.set.include", R"(["*.bvh", "{normal,sad}.bvh"])"},
    {"examples.set.exclude", R"(["x*", "tired.bvh"])"},
    {"examples.set.cycle", R"(["whole", "start-peak-end"])"},
    {"examples.set.keytimes",
     R"([{"normal": [0.1, 0.6], "tired": [0.1, 0.6], "sad": [0.1, 0.6]}, {"normal": [0.1, 0.7], "tired": [0.1, 0.6], "sad": [0.1, 0.6]}])"},
    {"examples.set.labels", R"(["file-name", {"tired": "aged"}])"},
    {"examples.set", R"(["builtin:walks-10", "builtin:walks-27"])"},
    {"examples.ratings", R"(["builtin", "simulated"])"},

    {"examples.scales", R"(["builtin", "my.scales.yaml"])"},
    {"examples.expect[].parameter", R"(["quickness", "largeness"])"},
    {"examples.expect[].order", R"([["sad", "normal"], ["normal", "sad"]])"},
    {"examples.expect",
     R"([[{"parameter": "quickness", "order": ["sad", "normal"]}], [{"parameter": "largeness", "order": ["sad", "normal"]}]])"},
    {"recipes", R"(["builtin", "builtin@0.2", "builtin@0.3", "fig29"])"},
    {"on_fault", R"(["warn", "reduce"])"},
    {"look.scene.set", R"(["void", "corridor"])"},
    {"look.scene.background", R"(["#405060", "#605040"])"},
    {"look.scene", R"(["void", "my.set.yaml"])"},
    {"figure.character", R"(["one.gltf", "two.gltf"])"},
    {"look.face.file", R"(["rise.csv", "fall.csv"])"},
    {"look.face.take", R"(["Rise", "Fall"])"},
    {"look.face.start", "[0.1, 0.2]"},
    {"look.face.fps", "[10, 20]"},
    {"look.face", R"([{"one": 0.5}, "hidden"])"},
    {"look.figure.mannequin.", "[0.2, 0.6]"},
    {"look.figure.mannequin", R"([{"sex": 0.1}, {"sex": 0.9}])"},
    {"trail.figure.mannequin.", "[0.2, 0.6]"},
    {"trail.figure.mannequin", R"([{"sex": 0.1}, {"sex": 0.9}])"},
    {"look.figure.point-light.noise", "[2, 5]"},
    {"look.figure.point-light.mask", "[2, 5]"},
    {"look.figure.point-light.joints", R"(["standard", ["Head", "Pelvis"]])"},
    {"look.figure.point-light.colour", R"(["#ff0000", "#00ff00"])"},
    {"look.figure.point-light.background", R"(["#100000", "#001000"])"},
    {"look.figure.point-light", R"([{}, {"inverted": true}])"},
    {"look.figure.markers.noise", "[2, 5]"},
    {"look.figure.markers.mask", "[2, 5]"},
    {"look.figure.markers.colour", R"(["#ff0000", "#00ff00"])"},
    {"look.figure.markers.background", R"(["#100000", "#001000"])"},
    {"look.figure.markers.show", R"([["Left*"], ["Right*"]])"},
    {"look.figure.markers.pairs", R"([[["LeftHip", "LeftKnee"]], [["RightHip", "RightKnee"]]])"},
    {"look.figure.markers", R"([{"gaps": "dark"}, {"gaps": "fill"}])"},
    {"look.figure.trail.figure", R"(["stick", "mannequin"])"},
    {"look.figure.trail.traces", R"([["hands"], ["feet"]])"},
    {"look.figure.trail", R"([{"poses": 2}, {"poses": 3}])"},
    {"look.figure", R"(["stick", "mannequin"])"},
    {"camera.position", "[[3, 1, 1], [3, 1, 2]]"},
    {"camera.target", "[[0, 1, 0], [0, 0.5, 0]]"},
    {"camera.path[].at", "[0, 0.1]"},
    {"camera.path[].position", "[[3, 1, 1], [3, 1, 2]]"},
    {"camera.path[].target", "[[0, 1, 0], [0, 0.5, 0]]"},
    {"camera.path",
     R"([[{"at": 0, "position": [3, 1, 1], "target": [0, 1, 0]}, {"at": 1, "position": [3, 1, 2], "target": [0, 1, 0]}],
         [{"at": 0, "position": [3, 1, 1], "target": [0, 1, 0]}, {"at": 1, "position": [2, 1, 2], "target": [0, 1, 0]}]])"},
    {"camera.figure_px", "[8, 12]"},
    {"camera.fov", "[20, 40]"},
    {"camera.stereo.separation", "[0.06, 0.2]"},
    {"camera.stereo", R"([{"separation": 0.06}, {"separation": 0.2}])"},
    {"camera.screen.distance_cm", "[60, 90]"},
    {"camera.screen.width_cm", "[50, 70]"},
    {"camera.screen.degrees", "[4, 8]"},
    {"camera.screen",
     R"([{"distance_cm": 60, "width_cm": 50}, {"distance_cm": 90, "width_cm": 50}])"},
    {"camera.depth_of_field.aperture", "[0.1, 0.4]"},
    {"camera.depth_of_field.focus", "[1, 4]"},
    {"camera.depth_of_field", R"([{"aperture": 0.1}, {"aperture": 0.4}])"},
    {"look.camera", R"(["front", "side"])"},
    {"look", R"([{"camera": "front"}, {"camera": "side"}])"},
    {"stimuli[].id", R"(["a", "c"])"},
    {"stimuli[].factors", R"([{"actor": "k"}, {"actor": "m"}])"},
    {"stimuli[].levels", R"([{"factor": "dose", "of": "modify.strength", "values": [0.2, 0.4]},
                             {"factor": "dose", "of": "modify.strength", "values": [0.2, 0.5]}])"},
    {"stimuli[].levels.factor", R"(["dose", "amount"])"},
    {"stimuli[].levels.of", R"(["modify.strength", "modify.weight"])"},
    {"stimuli[].levels.values", "[[0.2, 0.4], [0.2, 0.5]]"},
    {"stimuli[].levels.values.from", "[0.1, 0.2]"},
    {"stimuli[].levels.values.to", "[0.6, 0.8]"},
    {"stimuli[].levels.values.steps", "[2, 3]"},
    {"stimuli[].adjectives", R"([{"quickness": 0.6}, {"quickness": 0.7}])"},
    {"stimuli[].features", R"([{"step-length": 0.4}, {"step-length": 0.6}])"},
    {"stimuli[].weights", R"([{"normal": 1}, {"normal": 1, "sad": 1}])"},
    {"stimuli[].clip.file", R"(["one/normal.bvh", "one/sad.bvh"])"},
    {"stimuli[].clip.frames", "[[0, 8], [0, 9]]"},
    {"stimuli[].clip.take", R"(["Walk", "Stand"])"},
    {"examples.set.take", R"(["Walk", "Stand"])"},
    {"stimuli[].clip", R"(["one/normal.bvh", "one/sad.bvh"])"},
    {"modify.emotion", R"(["sad", "tired"])"},
    {"modify.strength", "[0.5, 1]"},
    {"modify.gains.bands", "[[1.2, 1], [0.8, 1]]"},
    {"modify.gains.", "[1.2, 0.7]"},
    {"modify.gains", R"([{"low": 1.2}, {"low": 0.8}])"},
    {"modify.posture.", "[4, 8]"},
    {"modify.posture", R"([{"head-flexion": 4}, {"head-flexion": 8}])"},
    {"modify.pose.neutral.take", R"(["Walk", "Stand"])"},
    {"modify.pose.posed.take", R"(["Walk", "Stand"])"},
    {"modify.pose.neutral.motion", R"(["sad", "tired"])"},
    {"modify.pose.posed.motion", R"(["sad", "tired"])"},
    {"modify.pose.neutral.frame", "[0, 5]"},
    {"modify.pose.posed.frame", "[0, 5]"},
    {"modify.pose.", R"(["normal", "tired"])"},
    {"modify.pose",
     R"([{"neutral": "normal", "posed": "sad"}, {"neutral": "normal", "posed": "tired"}])"},
    {"modify.neutral", R"(["normal", "tired"])"},
    {"modify.styled", R"(["sad", "tired"])"},
    {"modify.method", R"(["waveshape", "displacement"])"},
    {"modify.harmonics", "[3, 5]"},
    {"modify.order", "[3, 5]"},
    {"modify.inputs", "[2, 3]"},
    {"modify.components", "[4, 6]"},
    {"modify.swap", "[[0], [1]]"},
    {"modify.limbs", R"([["head"], ["hands"]])"},
    {"modify.paths", "[0.6, 0.8]"},
    {"modify.acceleration", "[0.2, 0.5]"},
    {"modify.tempo", "[0.9, 1.1]"},
    {"modify.gravity", R"(["scaled", "keep"])"},
    {"modify.hands", R"(["keep", "scale"])"},
    {"modify.gesture.repetitions", "[1, 2]"},
    {"modify.gesture.", "[0.5, 0.8]"},
    {"modify.gesture", R"([{"height": 1.2}, {"width": 1.4}])"},
    {"modify.range.", "[0.1, 0.2]"},
    {"modify.range", R"([{"head-flexion": 0.1}, {"head-flexion": 0.2}])"},
    {"modify.stiffness.", "[0.5, 0.8]"},
    {"modify.stiffness", R"([0.5, {"arms": 0.3}])"},
    {"modify.weight", "[1.2, 1.5]"},
    {"modify.variation", "[0.2, 0.5]"},
    {"modify", R"([{"emotion": "sad"}, {"emotion": "tired"}])"},
    {"overlays[].id", R"(["x", "y"])"},
    {"overlays[].target", R"(["a", "normal"])"},
    {"overlays[].created", R"(["b", "normal"])"},
    {"overlays[].reference", R"(["normal", "sad"])"},
    {"overlays[].output", R"([{"cycles": 1}, {"cycles": 2}])"},
    {"overlays", R"([[{"target": "a", "created": "b"}], [{"target": "b", "created": "a"}]])"},
    {"sheets[].id", R"(["x", "y"])"},
    {"sheets[].compare.target", R"(["a", "normal"])"},
    {"sheets[].compare.created", R"(["b", "normal"])"},
    {"sheets[].compare.reference", R"(["normal", "sad"])"},
    {"sheets[].compare", R"([{"target": "a", "created": "b"}, {"target": "b", "created": "a"}])"},
    {"sheets[].gallery", R"([["a", "b"], ["b", "a"]])"},
    {"sheets[].stills", R"([["a", "b"], ["b", "a"]])"},
    {"sheets[].columns", "[1, 2]"},
    {"sheets", R"([[{"stills": ["a", "b"]}], [{"stills": ["b", "a"]}]])"},
    {"equalize.luminance.by", R"(["study", "figure"])"},
    {"equalize.size.by", R"(["study", "figure"])"},
    {"equalize.place.by", R"(["study", "figure"])"},
    {"equalize.luminance", "[true, false]"},
    {"equalize.size", "[true, false]"},
    {"equalize.place", "[true, false]"},
    {"equalize", R"([["duration"], ["size"]])"},
    {"output", R"([{"cycles": 1}, {"cycles": 2}])"},
    {"interpolation", R"([{"rotations": "karcher-mean"}, {"rotations": "markley-mean"}])"},
    {"interpolation.neighbours", "[4, 6]"},
    {"interpolation.blends", "[10, 20]"},
    {"interpolation.cells", "[2, 3]"},
    {"examples", R"([{"set": "builtin:walks-10"}, {"set": "builtin:walks-10", "raters": 5}])"},
    {"stimuli",
     R"([[{"id": "a", "weights": {"sad": 1}}, {"id": "b", "weights": {"sad": 1}}], [{"id": "a", "weights": {"tired": 1}}, {"id": "b", "weights": {"sad": 1}}]])"},
};

/// Two different values within the schema's limits.
json two_values(const json& node) {
  if (node.contains("enum")) return {node["enum"][0], node["enum"][1]};
  if (node.value("type", "") == "boolean") return {false, true};
  const double least = node.value("minimum", 0.0), most = node.value("maximum", 1.0);
  const double reach = std::min(most - least, 10.0);
  if (node.value("type", "") == "integer")
    return {static_cast<int>(least + 0.3 * reach), static_cast<int>(least + 0.6 * reach)};
  return {least + 0.3 * reach, least + 0.6 * reach};
}

/// The longest entry whose text the path ends in or, where it ends in a dot, holds.
template <class Entry, std::size_t Count>
const Entry* entry_for(const Entry (&entries)[Count], const std::string& path) {
  const Entry* best = nullptr;
  for (const Entry& entry : entries) {
    const std::string_view text(entry.path);
    const bool fits =
        text.ends_with('.') ? path.find(text) != std::string::npos : path.ends_with(text);
    if (fits && (best == nullptr || text.size() > std::string_view(best->path).size()))
      best = &entry;
  }
  return best;
}

std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps;
  std::istringstream text(path);
  for (std::string step; std::getline(text, step, '.');) {
    steps.push_back(step);
    // A map with keys that its author chooses.
    if (step == "of" && path.find("quotas[].of.") != std::string::npos) steps.push_back("age");
  }
  return steps;
}

/// The map that an option stands in, made where it is not there.
json& parent_of(json& manifest, const std::vector<std::string>& steps) {
  json* node = &manifest;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const bool is_array = steps[i].ends_with("[]");
    const std::string key = is_array ? steps[i].substr(0, steps[i].size() - 2) : steps[i];
    json& child = (*node)[key];
    if (is_array && (!child.is_array() || child.empty())) child = json::array({json::object()});
    if (!is_array && !child.is_object()) child = json::object();
    node = is_array ? &child[0] : &child;
  }
  return *node;
}

/// Values without which the map around an option is none.
void add_around(json& manifest, const std::string& path) {
  if (path.starts_with("overlays[].")) {
    json& overlay = manifest["overlays"][0];
    overlay["target"] = "a";
    overlay["created"] = "b";
  }
  if (path.find("camera.path[].") != std::string::npos) {
    const std::string list = path.substr(0, path.find("[]", path.find("camera.path")));
    parent_of(manifest, steps_of(list))["path"] = parsed(
        R"([{"at": 0, "position": [3, 1, 1], "target": [0, 1, 0]}, {"at": 1, "position": [3, 1, 2], "target": [0, 1, 0]}])");
  }
  if (path.find("quotas[].of.") != std::string::npos) {
    manifest["questionnaire"] = parsed(with_screening)["questionnaire"];
    manifest["questionnaire"]["screening"]["quotas"] =
        parsed(R"([{"of": {"age": {}}, "at_most": 3}])");
  }
  if (path.find("within.") != std::string::npos)
    manifest["stimuli"][0]["modify"]["constraints"] = parsed(R"([{"part": "left-hand"}])");
  if (path.find("follows[].") != std::string::npos) {
    manifest["stimuli"][0]["modify"]["constraints"] = parsed(
        R"([{"part": "left-hand", "follows": [{"at": 0.2, "place": [0.3, 1, 0.3]}, {"at": 0.5, "place": [0.3, 1.2, 0.3]}]}])");
  }
  if (path.find("modify.pose.") != std::string::npos) {
    const json file = {{"motion", "one/sad.bvh"}};
    const bool is_of_file = path.find(".licence.") != std::string::npos;
    manifest["stimuli"][0]["modify"]["pose"] = {{"neutral", is_of_file ? file : json("normal")},
                                                {"posed", is_of_file ? file : json("sad")}};
  }
  if (path.starts_with("stimuli[].") && !path.starts_with("stimuli[].adjectives")) {
    json& stimulus = manifest["stimuli"][0];
    const bool other = path.starts_with("stimuli[].clip") || path == "stimuli[].features" ||
                       path.starts_with("stimuli[].path");
    if (other) stimulus.erase("weights");
  }
  if (path == "stimuli[].adjectives") manifest["stimuli"][0].erase("weights");
}

/// Names of the body's joints in their order, and with left and right exchanged.
json names_of_nameless() {
  json names = json::array(), exchanged = json::array();
  for (const motion::Joint& joint : motion::standard_body().joints) {
    names.push_back(joint.name);
    std::string other = joint.name;
    if (joint.name.starts_with("Left")) other.replace(0, 4, "Right");
    if (joint.name.starts_with("Right")) other.replace(0, 5, "Left");
    exchanged.push_back(other);
  }
  return {names, exchanged};
}

/// The joints of a clip as markers, of which one is missing for a while.
motion::PointRecording as_markers(const motion::Clip& clip) {
  motion::PointRecording markers;
  markers.name = clip.name;
  markers.frames_per_second = clip.frames_per_second;
  markers.unit = "m";
  markers.metres_per_unit = 1.0;
  for (const motion::Joint& joint : clip.body.joints) markers.points.push_back(joint.name);
  for (const std::vector<motion::Vec3>& places : motion::joint_paths(clip))
    markers.positions.insert(markers.positions.end(), places.begin(), places.end());
  markers.seen.assign(markers.positions.size(), true);
  for (int frame = 4; frame < 6; ++frame) {
    const std::size_t at = markers.at(frame, motion::LeftWrist);
    markers.seen[at] = false;
    markers.positions[at].setZero();
  }
  return markers;
}

/// The places of a clip's joints without their names, as .npz.
std::string nameless(const motion::Clip& clip) {
  std::vector<double> numbers;
  for (const std::vector<motion::Vec3>& places : motion::joint_paths(clip))
    for (const motion::Vec3& place : places)
      numbers.insert(numbers.end(), {place.x(), place.y(), place.z()});
  const std::string shape = "(" + std::to_string(clip.frame_count()) + ", " +
                            std::to_string(clip.body.joints.size()) + ", 3)";
  return npz_file(
      {{"fps", npy_f8("()", {clip.frames_per_second})}, {"joints", npy_f8(shape, numbers)}});
}

/// The clip as a BVH file that does not state its frame rate.
std::string unrated(const motion::Clip& clip) {
  std::string text = motion::to_bvh(motion::to_recording(clip));
  const std::size_t line = text.find("Frame Time:");
  return text.erase(line, text.find('\n', line) + 1 - line);
}

/// The keys that a person has in common with a stimulus.
const std::vector<std::string> motion_keys = {"adjectives",    "hold",   "features",
                                              "weights",       "clip",   "path",
                                              "interpolation", "modify", "on_fault"};

/// "modify.tempo" of "stimuli[].people[].modify.tempo"; empty if a stimulus has no such key.
std::string key_of_motion(const std::string& path) {
  constexpr std::string_view person = "stimuli[].people[].";
  if (!path.starts_with(person)) return "";
  const std::string own = path.substr(person.size());
  const std::string first = own.substr(0, own.find_first_of(".["));
  return std::ranges::find(motion_keys, first) == motion_keys.end() ? "" : own;
}

/// The motion of the first stimulus given to one of two people.
json with_people_of(json manifest) {
  json& stimulus = manifest["stimuli"][0];
  json person = {{"place", json::object()}};
  for (const std::string& key : motion_keys) {
    if (!stimulus.contains(key)) continue;
    person[key] = stimulus[key];
    stimulus.erase(key);
  }
  stimulus["people"] = {person, {{"weights", {{"sad", 1}}}, {"place", {{"x", 1}}}}};
  return manifest;
}

json with_value(const std::string& path, const json& value) {
  json manifest = tiny_study();
  const Surroundings* around = nullptr;
  for (const Surroundings& entry : surroundings) {
    if (around == nullptr && path.find(entry.path) != std::string::npos) around = &entry;
  }
  if (around != nullptr) manifest.merge_patch(parsed(around->patch));
  add_around(manifest, path);
  const std::vector<std::string> steps = steps_of(path);
  json& parent = parent_of(manifest, steps);
  if (around != nullptr) parent.merge_patch(parsed(around->siblings));
  parent[steps.back()] = value;
  return manifest;
}

}  // namespace

bool has_one_value(const std::string& path) {
  // An overlay takes neither dots nor trails.
  const bool is_refused = path.starts_with("overlays[].look.figure.point-light") ||
                          path.starts_with("overlays[].look.figure.markers") ||
                          path.starts_with("overlays[].look.figure.trail");
  return path == "mien" || path == "mismatch.audio" || path.ends_with(".stick") || is_refused;
}

OptionVariants variants_of(const std::string& path, const json& node) {
  if (const std::string own = key_of_motion(path); !own.empty()) {
    const OptionVariants variants = variants_of("stimuli[]." + own, node);
    return {with_people_of(variants.first), with_people_of(variants.second)};
  }
  const Values* chosen = entry_for(chosen_values, path);
  const bool is_of_nameless =
      path.ends_with(".joints") && path.find("point-light") == std::string::npos;
  const json two = is_of_nameless      ? names_of_nameless()
                   : chosen != nullptr ? parsed(chosen->two)
                                       : two_values(node);
  return {with_value(path, two[0]), with_value(path, two[1])};
}

namespace {

/// Walks of several strides, as motion graphs need them, in all kinds of files.
void write_long_walks(const motion::ExampleSet& walks, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const motion::Example& example : walks.examples) {
    const motion::Clip walk = motion::repeated(example.clip, 4);
    motion::write_motion(motion::to_recording(walk), folder / (example.clip.name + ".bvh"));
    if (example.clip.name != "normal") continue;
    std::ofstream(folder / "takes.gltf") << two_takes(motion::to_recording(walk));
    motion::write_motion(motion::to_recording(walk), folder / "smpl.npz");
    std::ofstream(folder / "nameless.npz") << nameless(walk);
    std::ofstream(folder / "unrated.bvh") << unrated(walk);
  }
}

}  // namespace

void write_variant_files(const std::filesystem::path& folder) {
  const motion::ExampleSet walks = motion::builtin_examples("walks-10");
  write_long_walks(walks, folder / "long");
  std::filesystem::create_directories(folder / "takes");
  std::filesystem::create_directories(folder / "smpl");
  std::ofstream(folder / "small.npz", std::ios::binary) << smpl_model_of_size(0.9);
  std::ofstream(folder / "tall.npz", std::ios::binary) << smpl_model_of_size(1.1);
  // 2 s, longer than the films.
  const render::Sound sound = render::test::noise(0.1, 2 * render::sound_rate);
  render::test::write_wav(folder / "one.wav", sound);
  render::test::write_wav(folder / "two.wav", render::test::noise(0.1, render::sound_rate, 2));
  render::test::write_wav(folder / "three.wav",
                          render::test::tone(440, 0.1, 2 * render::sound_rate));
  std::filesystem::create_directories(folder / "nameless");
  std::filesystem::create_directories(folder / "unrated");
  for (const char* name : {"one", "two"}) {
    std::filesystem::create_directories(folder / name);
    for (const motion::Example& example : walks.examples) {
      const std::string label = example.clip.name;
      if (label != "normal" && label != "sad" && label != "tired") continue;
      motion::Clip clip = example.clip;
      if (std::string(name) == "two") clip.poses.pop_back();
      motion::write_motion(motion::to_recording(clip), folder / name / (label + ".bvh"));
      std::ofstream(folder / "takes" / (label + ".gltf")) << two_takes(motion::to_recording(clip));
      motion::write_motion(motion::to_recording(clip), folder / "smpl" / (label + ".npz"));
      std::ofstream(folder / "nameless" / (label + ".npz")) << nameless(clip);
      std::ofstream(folder / "unrated" / (label + ".bvh")) << unrated(clip);
      std::ofstream(folder / (label + ".trc")) << motion::to_trc(as_markers(clip));
    }
  }
  std::ofstream(folder / "takes.gltf")
      << two_takes(motion::to_recording(walks.examples.front().clip));
  std::ofstream(folder / "my.set.yaml") << "background: \"#204060\"\n";
  std::ofstream(folder / "my.scales.yaml") << R"(
name: mine
scales:
  slow-quick: {low: slow, high: quick, loadings: {activeness: 0.6}}
  big-small: {low: big, high: small, loadings: {largeness: -0.6}}
)";
  std::ofstream(folder / "one.texts.yaml") << "language: en\nquestionnaire: {next: Go on}\n";
  std::ofstream(folder / "two.texts.yaml") << "language: en\nquestionnaire: {next: Forward}\n";
  std::ofstream(folder / "other.scales.yaml") << "scales: {small-big: {low: small, high: big}}\n";
  const std::string figure = skinned_gltf(motion::standard_body(), {}).text();
  std::ofstream(folder / "one.gltf") << figure;
  std::ofstream(folder / "two.gltf") << figure << "\n";
  SkinnedGltf face = skinned_gltf(motion::standard_body(), {});
  add_face(face);
  std::ofstream(folder / "face.gltf") << face.text();
  std::ofstream(folder / "rise.csv") << "time,one\n0,0\n1,1\n";
  std::ofstream(folder / "fall.csv") << "time,one\n0,1\n1,0\n";
  std::ofstream(folder / "frames.csv") << "frame,one\n0,0\n10,1\n";
}

}  // namespace mien::test
