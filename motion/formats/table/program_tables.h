#pragma once

#include "motion/formats/table/table_rows.h"
#include "motion/formats/table/wide_table.h"

namespace mien::motion {

// Headers of tables that programs for motion capture write. Each is called when its first row has
// been read, and leaves the rows before the first frame.

/// CSV of OptiTrack Motive 1.x to 3.x ("Data Export: CSV", docs.optitrack.com): a first line of
/// names and values in turn (Format Version, Export Frame Rate, Length Units …); rows of the
/// columns' types (Marker, Rigid Body, Rigid Body Marker, Bone, Bone Marker), names, perhaps IDs
/// and parents, kinds (Position, Rotation, Mean Marker Error); and the row "Frame, Time (Seconds),
/// X, Y, Z, …". Takes the positions of the first of these types that occurs: Marker, Bone Marker,
/// Rigid Body Marker, Bone.
WideColumns motive_columns(TableRows& rows);

/// TSV of Qualisys Track Manager: rows of a keyword and its values, among them FREQUENCY,
/// DATA_INCLUDED, EVENT and MARKER_NAMES; perhaps a row of column names; rows of positions in
/// millimetres, perhaps after the number of the frame and the time. `*declared_frames` becomes
/// NO_OF_FRAMES, or −1.
WideColumns qualisys_columns(TableRows& rows, std::int64_t* declared_frames);

/// Whether the word begins a section of a CSV of Vicon Nexus, in a row of its own.
bool is_nexus_section(std::string_view word);

/// CSV of Vicon Nexus: sections, of which "Trajectories" has a row with the frame rate, one with
/// the names of points over their x, the axes, and the units. Goes to that section; notes which
/// sections stand before it.
WideColumns nexus_columns(TableRows& rows);

}  // namespace mien::motion
