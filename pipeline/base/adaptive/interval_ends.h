#pragma once

namespace mien::pipeline {

/// Ends of an interval in units of what it is about; NaN if unknown.
struct IntervalEnds {
  double low;
  double high;
};

}  // namespace mien::pipeline
