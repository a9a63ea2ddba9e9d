#include <optional>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/asked_study.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

std::string told(const std::string& members) {
  const ManifestReading reading =
      parse_manifest(test::asked_study_text(5, members), "/nowhere/m.yaml",
                     [](const std::string&) { return std::nullopt; });
  return reading.faults.empty() ? "" : Faults(reading.faults).what();
}

TEST(QuestionnaireChecks, TellWhatIsWrongWithItsPlace) {
  struct Wrong {
    const char* members;
    const char* place;
    const char* words;
  };
  const Wrong wrong_ones[] = {
      {"scales: all", "m.yaml:5:16: questionnaire.participants", "missing"},
      {"participants: 4", "m.yaml:5:16: questionnaire", "has no scales"},
      {"participants: 4, scales: [sad-hapy]", "m.yaml:5:43: questionnaire.scales[0]",
       "did you mean \"sad-happy\""},
      {"participants: 4, scales: al", "m.yaml:5:42: questionnaire.scales", "all, emotions"},
      {"participants: 4, scales: all, stimuli: [a1, a2]", "m.yaml:5:61: questionnaire.stimuli[1]",
       "unknown stimulus \"a2\""},
      {"participants: 4, scales: all, stimuli: {actr: [a]}", "m.yaml:5:57: questionnaire.stimuli",
       "did you mean \"actor\""},
      {"participants: 4, scales: all, stimuli: {actor: [z]}", "questionnaire.stimuli.actor[0]",
       "unknown level \"z\""},
      {"participants: 4, scales: all, no_repeats: [mood]", "questionnaire.no_repeats[0]",
       "unknown factor"},
      {"participants: 4, scales: all, order: {blocked: actr}", "questionnaire.order.blocked",
       "did you mean \"actor\""},
      {"participants: 4, scales: all, order: latn", "questionnaire.order", "latin"},
      {"participants: 4, scales: all, order: latin, no_repeats: [actor]",
       "questionnaire.no_repeats", "use order: full"},
      {"participants: 4, scales: all, order: {blocked: actor}, no_repeats: [actor]",
       "questionnaire.no_repeats[0]", "blocks contain only one level"},
      {"participants: 4, scales: all, per_participant: 6", "questionnaire.per_participant",
       "use at most 5"},
      {"participants: 4, scales: all, practice: [x]", "questionnaire.practice[0]",
       "unknown stimulus"},
      {"participants: 4, scales: all, reference: x", "questionnaire.reference", "unknown stimulus"},
      {"participants: 4, scales: all, answer: {points: 4, default: middle}",
       "questionnaire.answer.default", "no middle"},
      {"participants: 4, scales: all, answer: {slider: true, points: 4}",
       "questionnaire.answer.points", "cannot be combined with slider"},
      {"participants: 4, scales: all, choices: [a, b]", "questionnaire.choices",
       "only emotion trials"},
      {"participants: 4, scales: all, pairs: [[a1, b2]]", "questionnaire.pairs",
       "only pair or same_different or two_interval trials"},
      {"participants: 4, trials: same_different, scales: all", "questionnaire.scales",
       "ask no scales"},
      {"participants: 4, scales: all, same_different: {same: 0.3}", "questionnaire.same_different",
       "only same_different trials"},
      {"participants: 4, trials: same_different, same_different: {same: 1}",
       "questionnaire.same_different.same", "0.9"},
      {"participants: 4, trials: same_different, preference: {ties: true}",
       "questionnaire.preference.ties", "ask for no preference"},
      {"participants: 4, trials: same_different, same_different: {differ_in: mood}",
       "questionnaire.same_different.differ_in", "unknown factor"},
      {"participants: 4, trials: same_different, stimuli: [a1, b2], same_different: {differ_in: "
       "emotion}",
       "questionnaire.same_different.differ_in", "no two stimuli differ"},
      {"participants: 4, trials: same_different, pairs: [[a1, b2]], same_different: {differ_in: "
       "emotion}",
       "questionnaire.same_different.differ_in", "cannot be combined with pairs"},
      {"participants: 4, trials: same_different, pairs: [[a1, a1]]", "questionnaire.pairs[0][1]",
       "appears twice"},
      {"participants: 4, trials: same_different, reference: a1", "questionnaire.reference",
       "already compared"},
      {"participants: 4, trials: yes_no, question: Sad", "questionnaire",
       "need stimuli with and without the signal"},
      {"participants: 4, trials: yes_no, signal: [a1]", "questionnaire",
       "no question of their own"},
      {"participants: 4, scales: all, signal: [a1]", "questionnaire.signal",
       "only yes_no or two_interval trials"},
      {"participants: 4, trials: yes_no, question: Sad, signal: [x]", "questionnaire.signal[0]",
       "unknown stimulus"},
      {"participants: 4, trials: yes_no, question: Sad, signal: {emotion: [sd]}",
       "questionnaire.signal.emotion[0]", "did you mean \"sad\""},
      {"participants: 4, trials: yes_no, question: Sad, stimuli: [a1, b2], signal: {emotion: "
       "[sad]}",
       "questionnaire.signal", "all of the stimuli have the signal"},
      {"participants: 4, trials: yes_no, question: Sad, stimuli: [a1, b2], signal: {emotion: "
       "[happy]}",
       "questionnaire.signal", "none of the stimuli has the signal"},
      {"participants: 4, trials: two_interval, question: Sad, signal: [a1, b2], pairs: [[a1, c3], "
       "[a1, b2]]",
       "questionnaire.pairs[1]", "both stimuli have the signal"},
      {"participants: 4, trials: two_interval, question: Sad, signal: [a1], preference: {shown: "
       "in_turn}",
       "questionnaire.preference", "only pair or same_different trials"},
      {"participants: 4, scales: all, best_worst: {size: 3}", "questionnaire.best_worst",
       "only best_worst trials"},
      {"participants: 4, scales: all, trials: best_worst, best_worst: {size: 6}",
       "questionnaire.best_worst.size", "there are 5 stimuli for sets of 6"},
      {"participants: 4, scales: all, trials: best_worst, best_worst: {size: 3, sets: 1}",
       "questionnaire.best_worst.sets", "use at least 2"},
      {"participants: 4, scales: all, trials: best_worst, best_worst: {size: 3}, practice: [a1, "
       "b2]",
       "questionnaire.practice", "needs 3 stimuli"},
      {"participants: 4, scales: all, trials: best_worst, best_worst: {size: 3}, practice: [a1, "
       "b2, "
       "a1]",
       "questionnaire.practice[2]", "appears twice in a set"},
      {"participants: 4, scales: all, grid: {alike: [actor]}", "questionnaire.grid",
       "only grid trials"},
      {"participants: 4, scales: [sad-happy], trials: grid", "questionnaire",
       "need sets of stimuli"},
      {"participants: 4, scales: all, trials: grid, grid: {sets: [[a1, b2]]}",
       "questionnaire.scales", "ask one scale"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {alike: [actr]}",
       "questionnaire.grid.alike[0]", "did you mean \"actor\""},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {alike: [actor], sets: [[a1, "
       "b2]]}",
       "questionnaire.grid.alike", "the sets are listed"},
      {"participants: 4, scales: [sad-happy], trials: grid, stimuli: [a1], grid: {sets: [[a1, "
       "b2]]}",
       "questionnaire.stimuli", "the sets of the grid are listed"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, x]]}",
       "questionnaire.grid.sets[0][1]", "unknown stimulus"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2], [c3, a1]]}",
       "questionnaire.grid.sets[1][1]", "appears twice"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2], [c3]]}",
       "questionnaire.grid.sets[1]", "a set has 2 to 12"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {alike: [actor]}",
       "questionnaire.grid.alike", "the set of \"c3\" has no other stimulus"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2], [c3, a4]], "
       "reference: [a1]}",
       "questionnaire.grid.sets[1]", "the set of \"c3\" has no reference"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2]], reference: "
       "[a1, b2]}",
       "questionnaire.grid.sets[0]", "has 2 references"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2]], reference: "
       "{emotion: [sd]}}",
       "questionnaire.grid.reference.emotion[0]", "did you mean \"sad\""},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2]], anchor: "
       "[c3]}",
       "questionnaire.grid.anchor", "no set has an anchor"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2]], reference: "
       "[a1], anchor: [a1]}",
       "questionnaire.grid.anchor", "is the reference, too"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2]]}, reference: "
       "a1",
       "questionnaire.reference", "name the references in grid"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2]]}, practice: "
       "[c3]",
       "questionnaire.practice", "has no other stimulus"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2]]}, answer: "
       "{points: 7}",
       "questionnaire.answer.points", "on sliders from 0 to 100"},
      {"participants: 4, scales: [sad-happy], trials: grid, grid: {sets: [[a1, b2]]}, replays: 2",
       "questionnaire.replays", "played at will"},
      {"participants: 4, scales: all, continuous: {lead: 2}", "questionnaire.continuous",
       "only continuous trials"},
      {"participants: 4, scales: all, analysis: {lag: 2}", "questionnaire.analysis.lag",
       "only continuous trials have traces"},
      {"participants: 4, scales: all, trials: continuous, replays: 2", "questionnaire.replays",
       "a video plays once"},
      {"participants: 4, scales: all, trials: continuous, replays: counted",
       "questionnaire.replays", "a video plays once"},
      {"participants: 4, scales: all, trials: continuous, watch: free", "questionnaire.watch",
       "end with the video"},
      {"participants: 4, scales: all, trials: continuous, view: turn", "questionnaire.view",
       "follow the time of a video"},
      {"participants: 4, scales: all, trials: continuous, reference: a1", "questionnaire.reference",
       "one video is watched"},
      {"participants: 4, scales: all, trials: continuous, answer: {points: 7}",
       "questionnaire.answer.points", "moving a marker from 0 to 100"},
      {"participants: 4, scales: all, trials: continuous, answer: {words: true}",
       "questionnaire.answer.words", "moving a marker from 0 to 100"},
      {"participants: 4, scales: all, trials: continuous, continuous: {input: keys}, phones: "
       "served",
       "questionnaire.phones", "phones have no arrow keys"},
      {"participants: 4, scales: all, trials: continuous, analysis: {quality: {min_sd: 5}}",
       "questionnaire.analysis.quality.min_sd", "traces as raw answers"},
      {"participants: 4, scales: all, trials: continuous, analysis: {quality: {max_longstring: 5}}",
       "questionnaire.analysis.quality.max_longstring", "traces as raw answers"},
      {"participants: 4, scales: [sad-happy], analysis: {quality: {post_screening: excluded}}",
       "questionnaire.analysis.quality.post_screening", "no grid trials with a reference"},
      {"participants: 4, scales: all, trials: pair, practice: [a1]", "questionnaire.practice",
       "an even number of stimuli"},
      {"participants: 4, trials: emotion, stimuli: [a1, b2], choices: [sad]",
       "questionnaire.choices", "at least 2"},
      {"participants: 4, scales: all, replays: often", "questionnaire.replays", "counted, none"},
      {"participants: 4, scales: all, view: turn", "questionnaire.view", "clips: [bvh, glb]"},
      {"participants: 4, scales: all, consent: {file: no.txt}", "questionnaire.consent.file",
       "there is no file /nowhere/no.txt"},
      {"participants: 4, scales: {file: no.scales.yaml}", "questionnaire.scales.file",
       "there is no file"},
      {"participants: 4, scales: all, demographics: [{id: session, ask: x, answer: text}]",
       "questionnaire.demographics[0].id", "a column with this name"},
      {"participants: 4, scales: all, demographics: [{id: simulated, ask: x, answer: text}]",
       "questionnaire.demographics[0].id", "a column with this name"},
      {"participants: 4, scales: all, demographics: [{id: tones_2, ask: x, answer: number}]",
       "questionnaire.demographics[0].id", "a column with this name"},
      {"participants: 4, scales: all, screening: {questions: [{id: tones_1, ask: x, answer: "
       "number}]}",
       "questionnaire.screening.questions[0].id", "a column with this name"},
      {"participants: 4, scales: all, demographics: [{id: url_age, ask: x, answer: text}]",
       "questionnaire.demographics[0].id", "begin with url_"},
      {"participants: 4, scales: all, display: {size: native, distance_cm: 57}",
       "questionnaire.display.distance_cm", "is not needed for this size"},
      {"participants: 4, scales: all, display: {size: {cm: 12, degrees: 10}}",
       "questionnaire.display.size.cm", "cannot be combined with degrees"},
      {"participants: 4, scales: all, display: {size: {}}", "questionnaire.display.size",
       "must not be empty"},
      {"participants: 4, scales: all, answer: {suggest: [happy]}", "questionnaire.answer.suggest",
       "only answers in free words have suggestions"},
      {"participants: 4, scales: all, consent_version: '2'", "questionnaire.consent_version",
       "there is no consent text"},
      {"participants: 4, scales: all, demographics: [{id: a, ask: x, answer: [b, c, b]}]",
       "questionnaire.demographics[0].answer[2]", "appears twice"},
      {"participants: 4, scales: all, recruitment: {prolific: {completed: C1, refused: C1}}",
       "questionnaire.recruitment.prolific.refused", "also the code of"},
      {"participants: 4, scales: all, preference: {ties: true}", "questionnaire.preference",
       "only pair or same_different trials"},
      {"participants: 4, scales: all, trials: pair, preference: {shown: in turn}",
       "questionnaire.preference.shown", "in_turn"},
      {"participants: 4, scales: all, screening: {questions: [{id: a, ask: x, answer: text}]}",
       "questionnaire.screening.questions[0].answer", "number"},
      {"participants: 4, scales: all, screening: {questions: [{id: session, ask: x, answer: "
       "number}]}",
       "questionnaire.screening.questions[0].id", "a column with this name"},
      {"participants: 4, scales: all, demographics: [{id: a, ask: x, answer: text}], screening: "
       "{questions: [{id: a, ask: x, answer: number}]}",
       "questionnaire.demographics[0].id", "already the id of another question"},
      {"participants: 4, scales: all, screening: {questions: [{id: a, ask: x, answer: number, "
       "accept: ['18']}]}",
       "questionnaire.screening.questions[0].accept", "is a number"},
      {"participants: 4, scales: all, screening: {questions: [{id: a, ask: x, answer: number, "
       "accept: yes}]}",
       "questionnaire.screening.questions[0].accept", "is a number"},
      {"participants: 4, scales: all, screening: {questions: [{id: a, ask: x, answer: number, "
       "accept: {from: 65, to: 18}}]}",
       "questionnaire.screening.questions[0].accept", "exchange from and to"},
      {"participants: 4, scales: all, screening: {questions: [{id: a, ask: x, answer: [yes, no], "
       "accept: [yess]}]}",
       "questionnaire.screening.questions[0].accept[0]", "\"yes\""},
      {"participants: 4, scales: all, screening: {questions: [{id: a, ask: x, answer: [yes, no], "
       "accept: {from: 1}}]}",
       "questionnaire.screening.questions[0].accept", "is one of a list"},
      {"participants: 4, scales: all, screening: {questions: [{id: a, ask: x, answer: [yes, no], "
       "accept: [yes, no]}]}",
       "questionnaire.screening.questions[0].accept", "every answer is accepted"},
      {"participants: 4, scales: all, screening: {questions: [{id: a, ask: x, answer: [yes, no]}], "
       "quotas: [{of: {b: yes}, at_most: 3}]}",
       "questionnaire.screening.quotas[0].of.b", "is no screening question"},
      {"participants: 4, scales: all, analysis: {quality: {repeated_by: PROLIFIC_PID}}",
       "questionnaire.analysis.quality.repeated_by", "does not keep the URL parameter"},
      {"participants: 4, scales: all, analysis: {quality: {min_rt_ms: 500, max_rt_ms: 500}}",
       "questionnaire.analysis.quality.min_rt_ms", "is not below max_rt_ms"},
      {"participants: 4, scales: all, analysis: {factors: [actr]}",
       "questionnaire.analysis.factors[0]", "did you mean \"actor\""},
      {"participants: 4, scales: all, analysis: {factors: [actor, actor]}",
       "questionnaire.analysis.factors[1]", "appears twice"},
      {"participants: 4, scales: all, stimuli: {emotion: [sad]}, analysis: {factors: [emotion]}",
       "questionnaire.analysis.factors[0]", "do not differ in \"emotion\""},
      {"participants: 4, scales: all, trials: pair, analysis: {random_slopes: true}",
       "questionnaire.analysis.random_slopes", "ratings of single stimuli"},
      {"participants: 4, scales: all, trials: pair, analysis: {factors: [strength]}",
       "questionnaire.analysis.factors[0]", "unknown factor \"strength\""},
      {"participants: 4, scales: all, trials: pair, preference: {alike: [actr]}",
       "questionnaire.preference.alike[0]", "did you mean \"actor\"?"},
      {"participants: 4, scales: all, trials: pair, stimuli: [a1, b2], preference: {alike: "
       "[actor]}",
       "questionnaire.preference.alike", "no two stimuli have equal levels"},
      {"participants: 4, trials: same_different, preference: {alike: [actor]}",
       "questionnaire.preference.alike", "does not apply to same_different trials"},
      {"participants: 4, scales: all, trials: pair, pairs: [[a1, b2]], preference: {alike: "
       "[actor]}",
       "questionnaire.pairs[0]", "the stimuli have different levels of actor"},
      {"participants: 4, scales: all, analysis: {between: gender}",
       "questionnaire.analysis.between", "there is no question \"gender\""},
      {"participants: 4, scales: all, demographics: [{id: age, ask: x, answer: number}], analysis: "
       "{between: age}",
       "questionnaire.analysis.between", "no choices that could form groups"},
      {"participants: 4, scales: all, analysis: {contrasts: [{name: c, weights: {actor: {a: 1, b: "
       "-0.5}}}]}",
       "m.yaml:5:97: questionnaire.analysis.contrasts[0].weights.actor",
       "the weights have a sum of 0.5; use weights with a sum of 0, such as {a: 1, b: -1}"},
      {"participants: 4, scales: all, analysis: {contrasts: [{name: c, weights: {actor: {a: 1, z: "
       "-1}}}]}",
       "questionnaire.analysis.contrasts[0].weights.actor.z", "no rated stimulus has the level"},
      {"participants: 4, scales: all, analysis: {contrasts: [{name: c, weights: {mood: {a: 1, b: "
       "-1}}}]}",
       "questionnaire.analysis.contrasts[0].weights.mood", "unknown factor \"mood\""},
      {"participants: 4, scales: all, analysis: {factors: [actor], contrasts: [{name: c, weights: "
       "{emotion: {sad: 1, happy: -1}}}]}",
       "questionnaire.analysis.contrasts[0].weights.emotion", "add it to analysis: factors"},
      {"participants: 4, scales: all, analysis: {contrasts: [{name: c, weights: {actor: {a: 1, b: "
       "-1}}}, {name: c, weights: {actor: {a: 1, c: -1}}}]}",
       "questionnaire.analysis.contrasts[1].name", "is the name of another contrast"},
      {"participants: 4, scales: all, analysis: {contrasts: [{name: c, weights: {actor: {a: 1, b: "
       "-1}}, at: {actor: c}}]}",
       "questionnaire.analysis.contrasts[0].at.actor", "one of the factors that are compared"},
      {"participants: 4, scales: all, analysis: {contrasts: [{name: c, weights: {actor: {a: 1, c: "
       "-1}}, at: {emotion: happy}}]}",
       "questionnaire.analysis.contrasts[0].weights", "no combination of levels"},
      {"participants: 4, scales: [sad-happy], analysis: {contrasts: [{name: c, weights: {actor: "
       "{a: "
       "1, b: -1}}, scales: [sad-hapy]}]}",
       "questionnaire.analysis.contrasts[0].scales[0]", "did you mean \"sad-happy\""},
      {"participants: 4, scales: all, recruitment: {prolific: {completd: C1}}",
       "questionnaire.recruitment.prolific", "did you mean \"completed\""},
      {"participants: 4, scales: all, recruitment: {prolific: {completed: C 1}}",
       "questionnaire.recruitment.prolific.completed", "is no completion code"},
      {"participants: 4, scales: all, recruitment: {url_parameters: [a b]}",
       "questionnaire.recruitment.url_parameters[0]", "is no name of a URL parameter"},
      {"participants: 4, scales: all, recruitment: {url_parameters: [a, a]}",
       "questionnaire.recruitment.url_parameters[1]", "appears twice"},
      {"participants: 4, scales: all, recruitment: {redirect: {completed: example.org}}",
       "questionnaire.recruitment.redirect.completed", "begin it with https://"},
      {"participants: 4, scales: all, recruitment: {redirect: {completed: 'https://x/{a b}'}}",
       "questionnaire.recruitment.redirect.completed", "names no URL parameter"},
      {"participants: 4, scales: all, recruitment: {redirect: {completed: 'https://x/{a'}}",
       "questionnaire.recruitment.redirect.completed", "without its counterpart"},
      {"participants: 4, scales: all, recruitment: {redirect: {completed: 'https://x/{{%A%}}'}}",
       "questionnaire.recruitment.redirect.completed", "as recruitment services write it"},
      {"participants: 4, scales: all, recruitment: {url_parameters: [__proto__]}",
       "questionnaire.recruitment.url_parameters[0]", "begin with a letter"},
      {"participants: 4, scales: all, recruitment: {prolific: {completed: C1}, redirect: "
       "{completed: 'https://x'}}",
       "questionnaire.recruitment.redirect.completed", "remove either"},
      {"participants: 4, scales: all, recruitment: {pseudonymise: true}",
       "questionnaire.recruitment.pseudonymise", "no URL parameters to hash"},
      {"participants: 4, scales: all, attention: {evry: 3}", "questionnaire.attention",
       "did you mean \"every\""},
  };
  for (const Wrong& wrong : wrong_ones) {
    const std::string text = told(wrong.members);
    EXPECT_NE(text.find(wrong.place), std::string::npos) << wrong.members << "\n" << text;
    EXPECT_NE(text.find(wrong.words), std::string::npos) << wrong.members << "\n" << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << "more than one: " << text;
  }
}

/// Their participants are in tables of the same form.
TEST(QuestionnaireChecks, KeepColumnsOfParticipantsFromQuestionsOfOtherExperiments) {
  const std::string head =
      "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10, ratings: builtin}\n";
  const std::string matching =
      head +
      "stimuli: [{id: t1, role: target, weights: {normal: 0.5, sad: 0.5}}]\n"
      "matching: {participants: 2, interfaces: [weights], limit_s: 60, demographics: [{id: ";
  const std::string adaptive =
      head +
      "adaptive: {participants: 2, method: gibbs, words: [sad, happy], space: {groups: "
      "[quickness, largeness]}, iterations: 4, demographics: [{id: ";
  const auto wrong_with = [](const std::string& text) {
    const ManifestReading reading =
        parse_manifest(text + ", ask: x, answer: text}]}\n", "/nowhere/m.yaml",
                       [](const std::string&) { return std::nullopt; });
    return reading.faults.empty() ? std::string() : Faults(reading.faults).what();
  };
  for (const std::string& experiment : {matching, adaptive}) {
    EXPECT_EQ(wrong_with(experiment + "hand"), "");
    for (const char* id : {"session", "simulated", "jatos_worker"}) {
      const std::string text = wrong_with(experiment + id);
      EXPECT_NE(text.find(".demographics[0].id: "), std::string::npos) << id << ": " << text;
    }
  }
}

TEST(QuestionnaireChecks, LetPeopleBeTurnedUnlessTheyAreDots) {
  const auto faults_of = [](const std::string& figure) {
    const ManifestReading reading = parse_manifest(
        "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\nlook: {figure: " + figure +
            "}\nstimuli:\n  - id: pair\n    people: [{weights: {sad: 1}, place: {x: -1}}, "
            "{weights: "
            "{happy: 1}, place: {x: 1}}]\nquestionnaire: {participants: 2, scales: all, view: "
            "turn}\n",
        "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; });
    return reading.faults.empty() ? std::string() : Faults(reading.faults).what();
  };
  EXPECT_EQ(faults_of("stick"), "");
  EXPECT_EQ(faults_of("mannequin"), "");
  const std::string dots = faults_of("point-light");
  EXPECT_NE(dots.find("m.yaml:8:53: questionnaire.view: the figures of the people of \"pair\" "
                      "cannot be turned in the browser"),
            std::string::npos)
      << dots;
}

TEST(QuestionnaireChecks, WarnOfAttentionChecksThatLeaveNobodyOut) {
  const auto warnings = [](const char* attention) {
    const std::string members = "participants: 4, scales: [sad-happy], attention: {every: ";
    return questionnaire_warnings(test::asked_study(5, members + attention + "}")).size();
  };
  EXPECT_EQ(warnings("3"), 1u);
  EXPECT_EQ(warnings("2"), 0u);
  EXPECT_EQ(warnings("0"), 1u) << "which are no checks";
  EXPECT_TRUE(
      questionnaire_warnings(test::asked_study(5, "participants: 4, scales: [sad-happy]")).empty());
}

TEST(QuestionnaireChecks, WarnOfPointsThatAreNotTheNumbersOfAScale) {
  const auto warned = [](double least, double most, const std::string& answer) {
    Manifest manifest =
        test::asked_study(5, "participants: 4, scales: [sad-happy], answer: {" + answer + "}");
    manifest.scales.file = "own.yaml";
    manifest.scales.set.scales = {
        {.id = "sad-happy", .low = "sad", .high = "happy", .least = least, .most = most}};
    std::string text;
    for (const Fault& fault : questionnaire_warnings(manifest))
      text += fault.path + ": " + fault.wrong + "; " + fault.remedy + "\n";
    return text;
  };
  EXPECT_EQ(warned(1.0, 7.0, "points: 5"),
            "questionnaire.answer.points: \"sad-happy\" goes from 1 to 7, but is answered with 5 "
            "points, which are 1.5 apart; for one point per number, answer: {points: 7}\n");
  EXPECT_EQ(warned(1.0, 7.0, "points: 7"), "");
  EXPECT_EQ(warned(-2.0, 2.0, "points: 7"), "") << "the range of built-in scales";
  EXPECT_EQ(warned(0.0, 100.0, "slider: true"), "");
}

TEST(QuestionnaireChecks, WarnWhereOneRatingOfAHiddenReferenceExcludes) {
  const auto warned = [](const char* sets, const char* screening) {
    const Manifest manifest = test::asked_study(
        14, fmt::format("participants: 4, scales: [sad-happy], trials: grid, grid: {{sets: [{}], "
                        "reference: [a1, c3, b5, a7, c9, b11, a13]}}{}",
                        sets, screening));
    std::string text;
    for (const Fault& fault : questionnaire_warnings(manifest))
      text += fault.path + ": " + fault.wrong + "\n";
    return text;
  };
  constexpr char six[] = "[a1, b2], [c3, a4], [b5, c6], [a7, b8], [c9, a10], [b11, c12]";
  const std::string seven = std::string(six) + ", [a13, b14]";
  constexpr char excluded[] = ", analysis: {quality: {post_screening: excluded}}";
  EXPECT_EQ(warned(six, excluded),
            "questionnaire.analysis.quality.post_screening: a single rating of a hidden reference "
            "below 90 excludes a participant, because a session has 6 sets\n");
  EXPECT_EQ(warned(seven.c_str(), excluded), "");
  EXPECT_EQ(warned(six, ""), "");
}

TEST(QuestionnaireChecks, WarnOfPracticeThatIsAnalysed) {
  const auto warned = [](const char* members) {
    std::string text;
    for (const Fault& fault : questionnaire_warnings(test::asked_study(5, members)))
      text += fault.path + ": " + fault.wrong + "\n";
    return text;
  };
  EXPECT_EQ(warned("participants: 4, scales: all, practice: [a1]"),
            "questionnaire.practice[0]: \"a1\" is also shown in the main part and analysed there, "
            "which has all stimuli\n");
  EXPECT_EQ(warned("participants: 4, scales: all, practice: [a1], stimuli: [b2, c3]"), "");
}

TEST(QuestionnaireChecks, RefuseComparedStimuliOfNoCondition) {
  Manifest manifest =
      test::asked_study(5,
                        "participants: 4, scales: all, trials: pair, analysis: {factors: "
                        "[emotion]}");
  EXPECT_TRUE(check_factorial(manifest).empty());
  manifest.stimuli[1].factors.clear();
  const std::vector<Fault> faults = check_factorial(manifest);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].path, "questionnaire.analysis.factors[0]");
  EXPECT_NE(faults[0].wrong.find("is compared, but has no level of \"emotion\""),
            std::string::npos);
}

TEST(QuestionnaireChecks, WarnOfAnAnalysisOfVarianceOfNobody) {
  const auto warned = [](const char* members) {
    return questionnaire_warnings(test::asked_study(12, members)).size();
  };
  EXPECT_EQ(warned("participants: 4, scales: all, analysis: {factors: [emotion]}, "
                   "per_participant: 2"),
            1u);
  EXPECT_EQ(warned("participants: 4, scales: all, analysis: {factors: [emotion]}, "
                   "per_participant: 3"),
            0u);
  EXPECT_EQ(warned("participants: 4, scales: all, trials: pair, per_participant: 2, analysis: "
                   "{factors: [emotion]}"),
            0u);
}

TEST(QuestionnaireChecks, TakeTextsAndScalesFromFiles) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "own.scales.yaml",
             "name: own\nrange: [0, 1]\nscales:\n  x: {low: l, high: h}\n  y: {low: l, high: h}\n");
  write_file(folder.path() / "c.txt", "I agree.\n");
  write_file(
      folder.path() / "m.yaml",
      test::asked_study_text(
          4, "participants: 4, scales: {file: own.scales.yaml, ask: [y]}, consent: {file: c.txt}"));
  const ManifestReading reading =
      read_manifest(folder.path() / "m.yaml", [](const std::string&) { return std::nullopt; });
  ASSERT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
  EXPECT_EQ(reading.manifest.questionnaire->consent.text, "I agree.\n");
  const ScaleSet scales = questionnaire_scales(reading.manifest);
  ASSERT_EQ(scales.scales.size(), 1u);
  EXPECT_EQ(scales.scales[0].id, "y");
  EXPECT_EQ(scales.scales[0].most, 1.0);
}

TEST(Asked, AreTheStimuliOfTheLevelsAndTheirEmotions) {
  const Manifest manifest =
      test::asked_study(12, "participants: 4, trials: emotion, stimuli: {actor: [a, c]}");
  EXPECT_EQ(questionnaire_stimuli(manifest).size(), 8u);
  ASSERT_EQ(questionnaire_choices(manifest).size(), 3u);
  EXPECT_EQ(questionnaire_choices(manifest)[1].first, "happy");
  EXPECT_EQ(
      questionnaire_scales(test::asked_study(3, "participants: 4, scales: emotions")).scales.size(),
      6u);
  // Single emotions beside the study's own scales.
  const Manifest mixed =
      test::asked_study(3, "participants: 4, scales: [slow-fast, tired-excited]");
  EXPECT_EQ(questionnaire_scales(mixed).scales.size(), 2u);
}

}  // namespace
}  // namespace mien::pipeline
