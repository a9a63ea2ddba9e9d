#!/bin/sh
# Compiles the motion core to WebAssembly: build_module.sh FOLDER puts live_core.wasm there, and
# keeps objects and a log beside it. Needs em++ (Emscripten 3.1.6 or later) and nothing else.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/../../.." && pwd)
[ $# -eq 1 ] || { echo "usage: build_module.sh FOLDER" >&2; exit 2; }
mkdir -p "$1"
out=$(CDPATH='' cd -- "$1" && pwd)
eigen=${EIGEN_INCLUDE:-/usr/include/eigen3}

# Rooms that go in whole, and files of others: what reads, writes or searches files stays out.
rooms='biomechanics dynamics gait gestures interpolation live live/browser math modify rig skeleton'
files='error.cpp
  examples/compared_example.cpp examples/make_example.cpp examples/settled_feet.cpp
  formats/bvh/bvh_as_read.cpp formats/bvh/bvh_rotation.cpp formats/reading/frame_rate.cpp
  measures/distance/distance.cpp
  measures/features/feature_scale.cpp measures/features/motion_feature_list.cpp measures/features/motion_features.cpp
  procedural/affective_walk.cpp procedural/builtin_styles.cpp
  procedural/expressive_walks.cpp procedural/foot_roll.cpp procedural/leg_cycle.cpp
  procedural/walk_curves.cpp procedural/walk_style.cpp procedural/walker.cpp
  procedural/walker_legs.cpp
  steered_walk/root_motion.cpp steered_walk/live_walk.cpp steered_walk/steered_moment.cpp
  steered_walk/steered_pose.cpp steered_walk/steered_walk.cpp
  steered_walk/step_plan.cpp steered_walk/stepping_leg.cpp
  steered_walk/walker_gaits.cpp'

# Exceptions as WebAssembly has them: Chrome 95, Firefox 100, Safari 15.2. Without -msimd128: clang 14
# vectorizes motion/rig/rest_calibration.cpp wrongly, and Eigen makes no use of it.
flags="-std=c++20 ${LIVE_OPTIMISE:--O3} -DNDEBUG -ffp-contract=off -fwasm-exceptions"

# From within the folder, whose name may hold blanks: the sources, and Eigen's headers alone of the folder
# that they lie in.
cd "$out"
mkdir -p objects include
ln -sfn "$root/motion" include/motion
ln -sfn "$eigen/Eigen" include/Eigen
ln -sfn "$eigen/unsupported" include/unsupported

# A file is compiled again when it, or any header, has changed since.
changed=$(find -L include/motion \( -name '*.h' -o -name build_module.sh \) -newer live_core.wasm 2>/dev/null |
  head -n 1)
[ -f live_core.wasm ] && [ -z "$changed" ] || rm -f objects/*.o
for room in $rooms; do (cd include/motion && ls "$room"/*.cpp); done >sources
printf '%s\n' $files >>sources
: >linked
: >stale
while read -r source; do
  object=objects/$(echo "$source" | tr / _).o
  echo "$object" >>linked
  [ "$object" -nt "include/motion/$source" ] || echo "include/motion/$source $object" >>stale
done <sources
xargs -r -P "${JOBS:-$(nproc)}" -n 2 sh -c 'em++ '"$flags"' -Iinclude -c "$0" -o "$1"' <stale
em++ $flags -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=33554432 -sTOTAL_STACK=1048576 \
  -sEXPORTED_FUNCTIONS=_live_open,_live_room,_live_leave,_live_set,_live_slider,_live_make,_live_distance,_live_example,_live_target,_live_result,_live_result_size,_walker_open,_walker_mood,_walker_steer,_walker_advance,_walker_frame,_walker_frame_size,_walker_told,_walker_told_size \
  --no-entry @linked -o part.wasm
mv part.wasm live_core.wasm
