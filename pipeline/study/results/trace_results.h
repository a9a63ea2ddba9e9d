#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/base/statistics/agreement.h"
#include "pipeline/base/statistics/bradley_terry.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// The mean of traces at a time of the film.
struct TracePoint {
  double time_s = 0.0;  ///< in the film, after the lag is taken off
  int people = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation (n − 1); NaN for one participant
  /// 95 % interval of the mean (Student, over participants), of this time alone; NaN for one
  /// participant.
  Interval95 ends;
};

/// The mean trace of a stimulus on a scale. Several traces of a participant are averaged first.
struct MeanTrace {
  std::size_t stimulus = 0;  ///< index into AnswerSet
  std::size_t scale = 0;     ///< index into AnswerSet
  std::vector<TracePoint> points;
};

/// Agreement of participants about the course of a stimulus on a scale, after the lead: the times
/// are what is rated, the participants the raters (Shrout and Fleiss 1979, Cronbach 1951). Times in
/// succession are not independent, so there are no intervals.
struct TraceAgreement {
  std::size_t stimulus = 0;  ///< index into AnswerSet
  std::size_t scale = 0;     ///< index into AnswerSet
  int people = 0;
  int samples = 0;
  double alpha = 0.0;     ///< Cronbach's alpha: how the participants' courses go together
  Intraclass intraclass;  ///< ICC(2,1) and ICC(2,k): agreement also of their levels
  int unmoved = 0;        ///< traces in which the marker was not moved
};

struct TraceResults {
  std::vector<MeanTrace> means;  ///< by stimulus, then by scale
  std::vector<TraceAgreement> agreement;
};

/// The results of continuous trials; empty for other trials.
TraceResults trace_results(const AnswerSet& answer_set);

}  // namespace mien::pipeline
