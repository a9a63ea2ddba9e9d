#pragma once

#include <cstdint>
#include <string>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/tasks/task_graph.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

extern const TableForm dots_form;

/// Returns a table with the position of each dot of a shot's figures in every frame.
std::string dots_csv(const scenes::Shot& shot);

/// Whether a stimulus is shown as a point-light figure or as markers.
bool has_dots(const Stimulus& stimulus);

/// What a stimulus's figure shows of the markers of its recording: "39 of 41 markers, dark in 2.1 %
/// of their frames". Empty for other kinds of figures. Throws Error.
std::string marker_facts(const Stimulus& stimulus, FinishedMotions& motions);

/// The task "dots:<id>", which makes clips/<id>.dots.csv.
Task dots_task(const Stimulus& stimulus, std::uint64_t seed, const Equalize& equalize,
               const SharedDeterminants& shared, FinishedMotions& motions);

}  // namespace mien::pipeline
