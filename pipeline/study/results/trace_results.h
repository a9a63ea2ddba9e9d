#pragma once

#include <cstddef>
#include <string>
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
  std::string remark;     ///< why there are none, or what they mean (agreement_remark)
};

/// The mean of traces over a part of the film in one mood, of stimuli whose mood changes
/// (ReportedStimulus::moods). Each participant contributes the mean of all own samples in the part.
struct TraceSegment {
  std::size_t stimulus = 0;  ///< index into AnswerSet
  std::size_t scale = 0;     ///< index into AnswerSet
  std::string mood;
  double from_s = 0.0;  ///< time of the film; of the first part, after the lead
  double to_s = 0.0;
  int people = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation (n − 1); NaN for one participant
  Interval95 ends;         ///< of the mean (Student); NaN for one participant
  /// Mean difference from the part before and its interval (Student, paired by participant); NaN
  /// for the first part.
  double change = 0.0;
  Interval95 change_ends;
};

struct TraceResults {
  std::vector<MeanTrace> means;        ///< by stimulus, then by scale
  std::vector<TraceSegment> segments;  ///< by stimulus, then by scale, then by time
  std::vector<TraceAgreement> agreement;
};

/// The results of continuous trials; empty for other trials.
TraceResults trace_results(const AnswerSet& answer_set);

}  // namespace mien::pipeline
