#include "pipeline/farm/slurm/batch_script.h"

#include <iomanip>
#include <sstream>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/text/shell_word.h"
#include "pipeline/farm/slurm/job_attempts.h"
#include "pipeline/farm/slurm/worker_codes.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using motion::in_single_quotes;

constexpr int stopped_run = 130;  ///< exit code of `mien run` after a stop signal

std::string line(std::string_view option) { return fmt::format("#SBATCH --{}\n", option); }

std::string line(std::string_view option, std::string_view value) {
  return value.empty() ? "" : line(fmt::format("{}={}", option, batch_value(value)));
}

std::string introduction(const BatchJob& job, const StudyCall& call) {
  if (job.elements == 0) {
    return fmt::format(
        "# {}, submission {}: makes what its other jobs did not, and the study's record.\n"
        "# To run it again: sbatch {}.sbatch (or mien farm resume)\n",
        call.study, job.submission, job.name);
  }
  return fmt::format(
      "# {0}, submission {1}: {2}, each a line of {3}.tasks.\n"
      "# To run it again: sbatch {3}.sbatch; or some of it: sbatch --array=3,7 {3}.sbatch\n"
      "# Without Slurm: SLURM_ARRAY_TASK_ID=3 bash {3}.sbatch\n"
      "# Existing results are not made again.\n",
      call.study, job.submission,
      job.elements == 1 ? "1 element" : fmt::format("{} elements", job.elements), job.name);
}

std::string options(const BatchJob& job, const StudyCall& call, const JobRequest& request) {
  const bool is_array = job.elements > 0;
  std::string text = line("job-name", call.study + "-" + job.name);
  if (is_array) {
    std::string array = fmt::format("array=1-{}", job.elements);
    if (request.array_limit > 0) array += fmt::format("%{}", request.array_limit);
    text += line(array);
  }
  text += line("partition", request.partition) + line("time", request.time) +
          line("mem", request.memory) + line("account", request.account);
  text += line(fmt::format("cpus-per-task={}", request.processors));
  // Slurm begins no job whose log it cannot open: it fails at once, and so do all that follow.
  text += line("output=/dev/null");
  text += line("comment", job.comment);
  return text + line("requeue") + line("open-mode=append") + line("signal=B:TERM@30") +
         line("kill-on-invalid-dep=yes");
}

std::string paths(const BatchJob& job, const fs::path& folder, const StudyCall& call,
                  const std::string& program) {
  std::string text = fmt::format(
      "\nmien={}\nmanifest={}\nout={}\nfolder={}\nstarted={}\n"
      "patience={}  # seconds that the job waits for a folder that is full, read-only or away\n\n",
      in_single_quotes(program), in_single_quotes(call.manifest.string()),
      in_single_quotes(call.out.string()), in_single_quotes(folder.string()),
      in_single_quotes(call.started.string()), folder_wait_limit_seconds);
  if (job.elements > 0) {
    text +=
        "element=${SLURM_ARRAY_TASK_ID:-1}\n"
        "job=${SLURM_ARRAY_JOB_ID:-none}_$element\n";
  } else {
    text +=
        "element=1\n"
        "job=${SLURM_JOB_ID:-none}\n";
  }
  return text + fmt::format(
                    "log=$folder/log/{}-$job.log\n"
                    "ended=$folder/ends/{}.$element  # there when it did not end well\n"
                    "restarts=${{SLURM_RESTART_COUNT:-0}}\n",
                    in_single_quotes(call.study + "-" + job.name), job.name);
}

std::string call_text(const BatchJob& job, const StudyCall& call, const JobRequest& request) {
  const std::string quality =
      call.quality.empty() ? "" : " --quality " + in_single_quotes(call.quality);
  if (job.elements == 0) {
    return fmt::format("\"$mien\" run \"$manifest\" --out \"$out\" --jobs {}{}", request.processors,
                       quality);
  }
  return fmt::format(
      "\"$mien\" farm worker \"$manifest\" --list \"$folder/{}.tasks\" --line \"$element\" \\\n"
      "    --out \"$out\" --jobs {}{} --expect {}",
      job.name, request.processors, quality, call.key);
}

/// Requeues the job. If the site does so for an exit code, that suffices; otherwise only a job that
/// is still running may request it, because a cancelled one would be revived.
std::string back_into_queue(const char* name, const char* request, bool site_does, int code) {
  if (site_does) return fmt::format("{}() {{ exit {}; }}  # the site does the rest\n", name, code);
  return fmt::format(
      "{0}() {{\n"
      "  if [ \"$(squeue -h -j \"$job\" -o %T 2>/dev/null)\" = RUNNING ]; then\n"
      "    {1} \"$job\" && sleep 60  # until Slurm ends this attempt\n"
      "  fi\n"
      "  exit {2}\n"
      "}}\n",
      name, request, code);
}

/// The kernel counts out-of-memory kills in the job's control group (cgroup v1 and v2). Slurm uses
/// the same count, but forgets the job after some minutes.
constexpr const char* memory_check = R"(lack=
while IFS=: read -r _ kind group; do
  case $group in *"/job_${{SLURM_JOB_ID:-none}}"*) ;; *) continue ;; esac
  for counts in "/sys/fs/cgroup/$kind$group/memory.oom_control" \
    "/sys/fs/cgroup$group/memory.events"; do
    if grep -qs '^oom_kill [1-9]' "$counts"; then lack={}; fi
  done
done </proc/self/cgroup
)";

std::string ending(const BatchJob& job, const SlurmSite& site) {
  std::string text =
      back_into_queue("try_again", "scontrol requeue", site.requeues_transient, worker_transient) +
      back_into_queue("hold", "scontrol requeuehold State=SpecialExit", site.holds_wrong_setup,
                      worker_wrong_setup);
  text += "\n[ $code -ne 0 ] || { rm -f -- \"$ended\"; exit 0; }\n" +
          fmt::format(memory_check, out_of_memory_note) +
          "echo \"$code $restarts ${SLURMD_NODENAME:-$(hostname)} $lack\" >\"$ended\"\n"
          "echo \"mien farm: ended with $code on ${SLURMD_NODENAME:-$(hostname)} after $restarts "
          "restarts\"\n";
  // `mien run` is a command for people, and has other codes.
  const int again = job.elements > 0 ? worker_transient : stopped_run;
  const std::string wrong = job.elements > 0 ? std::to_string(worker_bad_input) : "2";
  text += job.elements > 0 ? "# $code is the worker's: see mien farm worker --help.\n"
                           : fmt::format(
                                 "# $code is that of mien run: 130 it was stopped, 2 bad "
                                 "input, 1 something failed. The job ends with a worker's: "
                                 "{} bad input, {} tried too often.\n",
                                 worker_bad_input, worker_gave_up);
  text += fmt::format(
      "case $code in\n"
      "  {0}) [ \"$restarts\" -ge {1} ] || try_again; exit {2} ;;  # stopped, or the machine's "
      "fault\n"
      "  {6}) [ \"$restarts\" -lt {1} ] || hold; try_again ;;  # the folder was not well\n"
      "  {3}) exit {4} ;;  # bad input: trying again would not help\n"
      "  {5}) hold ;;  # the set-up is wrong: held until somebody has looked (scontrol release)\n"
      "  *) exit \"$code\" ;;\n"
      "esac\n",
      again, most_restarts, worker_gave_up, wrong, worker_bad_input, worker_wrong_setup,
      worker_disk_unavailable);
  return text;
}

}  // namespace

std::string batch_value(std::string_view text) {
  std::ostringstream value;
  value << std::quoted(text);
  return value.str();
}

void refuse_unwritable(const fs::path& path) {
  const std::string text = path.string();
  for (const char letter : text) {
    const bool is_control = static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f;
    if (!is_control && letter != '\\') continue;
    throw Error(text + ": no batch file can name a path with " +
                    (is_control ? "a line break or another control character" : "a backslash"),
                "rename the folder, or choose another with --out");
  }
}

std::string batch_script(const BatchJob& job, const fs::path& folder, const StudyCall& call,
                         const JobRequest& request, const SlurmSite& site) {
  const fs::path program = request.program.empty() ? call.program : fs::path(request.program);
  for (const fs::path& path : {folder, program, call.manifest, call.out, call.started}) {
    refuse_unwritable(path);
  }
  const int stopped = job.elements > 0 ? worker_transient : stopped_run;
  return "#!/bin/bash\n" + introduction(job, call) + options(job, call, request) +
         paths(job, folder, call, program.string()) +
         job_attempts(call_text(job, call, request), stopped) + ending(job, site);
}

}  // namespace mien::pipeline
