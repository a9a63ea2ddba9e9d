#include "pipeline/farm/slurm/job_attempts.h"

#include <fmt/format.h>

#include "pipeline/farm/slurm/worker_codes.h"

namespace mien::pipeline {

namespace {

// A worker that finds its disk full removes what it had written of it, so that a look afterwards
// may find room; a megabyte is what disk_fault.h asks for.
constexpr const char* functions =
    R"sh(
# Slurm opens no log: it would not begin a job whose log it cannot open. By hand there is none.
open_log() {
  [ -n "$SLURM_JOB_ID" ] || return
  [ ! -d "$folder" ] || mkdir -p "${log%/*}" 2>/dev/null
  if { : >>"$log"; } 2>/dev/null; then exec >>"$log" 2>&1; fi
}
open_log

# What ails the study's folder, in the system's words; nothing when it takes what is written.
ailment() {
  [ -d "$folder/ends" ] || { echo "$folder/ends does not exist"; return; }
  local probe=$folder/ends/.writable-$job-$$ words
  words=$( { head -c 1048576 /dev/zero >"$probe" && sync "$probe"; } 2>&1) ||
    echo "$folder cannot be written to (${words##*: })"
  rm -f -- "$probe" 2>/dev/null
}

say() { echo "mien farm: $* ($(date -u +%FT%TZ), ${SLURMD_NODENAME:-$(hostname)})"; }

stopped=
worker=
stop() { signalled=yes; stopped=yes; [ -z "$worker" ] || kill -TERM "$worker" 2>/dev/null; }
trap stop TERM INT

waited=0
pause() {  # a signal ends it at once
  [ -z "$stopped" ] || return
  sleep "$1" &
  wait $! || kill $! 2>/dev/null
  waited=$((waited + $1))
}

# Waits until the folder is well; fails when there is no patience left, or the job is told to stop.
await_folder() {
  local ails before=
  while ails=$(ailment); [ -n "$ails" ]; do
    [ -z "$stopped" ] && [ "$waited" -lt "$patience" ] || return 1
    [ -n "$before" ] || say "$ails; waiting, at most $((patience - waited)) s"
    before=$ails
    pause 10
  done
  open_log
  [ -z "$before" ] || say "continues after waiting $waited s, because $before"
}

)sh";

/// The worker runs in the background: otherwise the shell would handle SIGTERM only after it ends.
constexpr const char* until_it_ends = R"sh(  worker=$!
  [ -z "$stopped" ] || kill -TERM "$worker" 2>/dev/null
  while :; do
    signalled=
    wait "$worker"
    code=$?
    [ -n "$signalled" ] || break
  done
  worker=
}

)sh";

constexpr const char* loop = R"sh(while :; do
  await_folder || {{ code={no_disk}; break; }}
  [ -z "$stopped" ] || {{ code={stopped}; break; }}
  if cd -- "$started"; then work; else code={wrong_setup}; fi
  [ $code -ne 0 ] && [ -z "$stopped" ] && [ "$waited" -lt "$patience" ] || break
  if [ $code -eq {no_disk} ]; then  # what was removed may have made room, until it is written again
    say "retrying in a minute"
    pause 60
  elif [ -z "$(ailment)" ]; then
    break
  fi
done
trap - TERM INT
[ -z "$stopped" ] || say "received a stop signal: time limit, preemption or scancel"

)sh";

}  // namespace

std::string job_attempts(const std::string& call, int stopped) {
  return functions + ("work() {\n  " + call + " &\n") + until_it_ends +
         fmt::format(loop, fmt::arg("no_disk", worker_disk_unavailable),
                     fmt::arg("stopped", stopped), fmt::arg("wrong_setup", worker_wrong_setup));
}

}  // namespace mien::pipeline
