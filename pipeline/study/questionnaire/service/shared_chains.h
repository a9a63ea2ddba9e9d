#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/study/questionnaire/service/chain_record.h"

namespace mien::pipeline {

/// An assigned step of a chain across participants.
struct AssignedStep {
  ChainName name;
  int step = 0;
  int person = 0;
  std::vector<double> point;  ///< of the chain
};

/// The step as JSON, for the page (Step of page/src/chains/steps.ts).
nlohmann::ordered_json step_json(const ChainDesign& design, const AssignedStep& step);

/// A person's place in a step of a chain.
struct ChainPlace {
  ChainName name;
  int step = 0;
  int person = 0;
};

/// Why no step is assigned.
enum class NoStep {
  finished,  ///< all chains are complete or have ended
  busy       ///< all steps that are open have been given to other participants
};

/// The chains of an experiment that go across participants. They follow from the answers alone; who
/// has been given which step is known for a limited time. Not thread-safe.
class SharedChains {
 public:
  /// `facts` must outlive this.
  explicit SharedChains(const ChainFacts& facts);

  /// The step for a trial of a session at a time in seconds. Asked again within the time for an
  /// answer, it is the same one. Otherwise, of the chains with an open place that was not given to
  /// others and whose present step the session has not answered, it is on the one with the fewest
  /// steps; of equal ones, on one that the session did not answer last; then by a hash of session
  /// and trial.
  std::optional<AssignedStep> assign(int session, const std::string& trial, std::int64_t now,
                                     NoStep& reason);

  /// Whether an answer to this step and person can be taken: it is of the chain's present step and
  /// point, and nobody else has answered it or has been given it in the meantime.
  bool is_open(int session, const ChainRecord& record, std::int64_t now) const;

  /// Takes an answer that is_open(), or one that was stored before.
  void add(int session, const ChainRecord& record);

  /// The answers of a session to steps that still lack those of others.
  std::vector<ChainPlace> open_answers(int session) const;
  /// Removes these answers, and gives the steps that the session was given to others.
  void forget_open(int session);

  /// Whether all chains are complete, or have ended because those of their word agree.
  bool is_finished() const;
  /// The number of complete steps of all chains, and of all steps; of a word whose chains have
  /// ended, those that there are.
  int complete_steps() const;
  int all_steps() const;

 private:
  struct Chain {
    ChainName name;
    std::vector<double> point;
    std::vector<std::vector<double>> sweeps = {};  ///< points after sweeps, if chains may end early
    int step = 0;
    std::map<int, double> values;  ///< answers to the present step, by person
    std::map<int, int> sessions;   ///< who gave them, by person
    int last_session = -1;         ///< who answered last
  };
  struct Lease {
    int session = 0;
    std::string trial;
    std::int64_t until = 0;
  };
  using Place = std::tuple<std::size_t, int, int>;  ///< chain, step, person

  const Chain* chain_of(const ChainRecord& record) const;
  std::optional<int> open_person(std::size_t chain, int session, std::int64_t now) const;
  void complete_step(Chain& chain, const ChainRecord& record);
  void end_if_converged(const std::string& word);
  bool is_over(const Chain& chain) const;

  const ChainFacts& facts_;
  std::vector<Chain> chains_;
  std::map<Place, Lease> leases_;
  std::set<std::string> ended_words_;               ///< those whose chains agree
  std::map<std::string, std::size_t> sweeps_seen_;  ///< by word, of the shortest chain
};

}  // namespace mien::pipeline
