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
rooms='biomechanics gait interpolation live live/browser math rig skeleton'
files='error.cpp
  examples/compared_example.cpp examples/make_example.cpp examples/settled_feet.cpp
  formats/bvh_as_read.cpp formats/bvh_rotation.cpp formats/frame_rate.cpp
  measures/distance.cpp measures/feature_curves.cpp measures/feature_parameter.cpp
  measures/feature_scale.cpp measures/motion_feature_list.cpp measures/motion_features.cpp'

# Exceptions as WebAssembly has them and 128-bit vectors: Chrome 95, Firefox 100, Safari 16.4.
flags="-std=c++20 ${LIVE_OPTIMISE:--O3} -DNDEBUG -ffp-contract=off -fwasm-exceptions -msimd128"

# Eigen's headers alone: nothing else of the folder that they lie in.
mkdir -p "$out/objects" "$out/include"
ln -sfn "$eigen/Eigen" "$out/include/Eigen"
ln -sfn "$eigen/unsupported" "$out/include/unsupported"

cd "$root/motion"
for room in $rooms; do ls "$room"/*.cpp; done >"$out/sources"
printf '%s\n' $files >>"$out/sources"
# A file is compiled again when any header or source has changed since.
newest=$(find "$root/motion" -name '*.h' -newer "$out/live_core.wasm" 2>/dev/null | head -n 1)
[ -f "$out/live_core.wasm" ] && [ -z "$newest" ] || rm -f "$out/objects"/*.o
while read -r source; do
  object=$out/objects/$(echo "$source" | tr / _).o
  [ "$object" -nt "$source" ] || echo "$source $object"
done <"$out/sources" >"$out/stale"
xargs -r -P "${JOBS:-$(nproc)}" -n 2 sh -c \
  'em++ '"$flags"' -I"'"$root"'" -isystem "'"$out/include"'" -c "$0" -o "$1"' <"$out/stale"
em++ $flags -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=33554432 -sTOTAL_STACK=1048576 \
  -sEXPORTED_FUNCTIONS=_live_open,_live_room,_live_leave,_live_set,_live_slider,_live_make,_live_distance,_live_example,_live_target,_live_result,_live_result_size \
  --no-entry "$out/objects"/*.o -o "$out/live_core.part.wasm"
mv "$out/live_core.part.wasm" "$out/live_core.wasm"
