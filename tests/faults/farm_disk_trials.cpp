#include "faults/farm_disk_trials.h"

#include <functional>

#include "pipeline/farm/fake_programs.h"

#include "end_to_end/farm_study.h"
#include "faults/own_disk.h"

namespace mien::test {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t ample_room = std::size_t{64} << 20;

/// A Slurm that takes each job and holds it.
class HoldingSlurm {
 public:
  HoldingSlurm() {
    const std::string at = programs_.folder().string();
    programs_.write("rows", "");
    programs_.write("cancelled", "");
    programs_.say("sinfo", "main*|4\n");
    programs_.say("scontrol", "MaxArraySize = 1001\n");
    programs_.add("sleep", "exec /bin/sleep 0.1");
    programs_.add("squeue", "cat " + at + "/rows");
    programs_.add("scancel", "echo \"$@\" >>" + at + "/cancelled");
    programs_.add("sbatch",
                  "for script; do :; done\n"
                  "comment=$(sed -n 's/^#SBATCH --comment=\"\\(.*\\)\"/\\1/p' \"$script\")\n"
                  "n=$(($(wc -l <" +
                      at +
                      "/rows) + 1))\n"
                      "echo \"$n|$n|1|PENDING|JobHeldUser||0:00|$comment\" >>" +
                      at +
                      "/rows\n"
                      "echo $n");
  }

  std::string cancelled() const { return programs_.text_of("cancelled"); }

 private:
  FakePrograms programs_;
};

void resume_on_full_disk(const fs::path& manifest, const fs::path& out, Figures& figures) {
  OwnDisk disk(out, ample_room);
  const HoldingSlurm slurm;
  const auto farm = [&](const char* command) {
    return run_mien({"farm", command, manifest.string(), "--out", out.string()});
  };
  Trial::expect_code(farm("submit"), 0, "submit", figures);
  const fs::path journal = out / "tiny/farm/journal.jsonl";
  const std::string before = text_of(journal);
  const fs::space_info space = fs::space(out);
  if (!disk.resize(space.capacity - space.free)) figures.complaints.emplace_back("is not full");
  ++figures.faults;
  const Ended refused = farm("resume");
  Trial::expect_code(refused, 1, "resume on a full disk", figures);
  if (refused.errors.find("No space left on device") == std::string::npos)
    figures.complaints.push_back("told so: " + refused.errors);
  if (!slurm.cancelled().empty()) figures.complaints.push_back("taken back: " + slurm.cancelled());
  if (fs::exists(out / "tiny/farm/0002") || text_of(journal) != before)
    figures.complaints.emplace_back("something half written was left");
  disk.resize(ample_room);
  Trial::expect_code(farm("resume"), 0, "resume once there is room", figures);
  if (slurm.cancelled().empty()) figures.complaints.emplace_back("nothing was taken back");
  ++figures.studies;
}

/// How a disk is made ill, and what is said of it.
struct Illness {
  std::string name;
  std::string words;
  std::function<bool(OwnDisk& disk, const fs::path& out)> strike;
};

std::vector<Illness> illnesses() {
  return {{"full", "is full",
           [](OwnDisk& disk, const fs::path& out) {
             const fs::space_info space = fs::space(out);
             return disk.resize(space.capacity - space.free);
           }},
          {"read-only", "Read-only file system",
           [](OwnDisk& disk, const fs::path&) { return disk.set_read_only(true); }}};
}

void wait_on_ailing_disk(const Illness& illness, const fs::path& manifest, const fs::path& out,
                         Figures& figures) {
  OwnDisk disk(out, ample_room);
  const HoldingSlurm slurm;
  const auto farm = [&](const char* command) {
    return run_mien({"farm", command, manifest.string(), "--out", out.string()});
  };
  Trial::expect_code(farm("submit"), 0, "submit", figures);
  const fs::path submission = out / "tiny/farm/0001";
  if (!illness.strike(disk, out)) figures.complaints.push_back(illness.name + ": is well");
  ++figures.faults;
  Running job({"env", "SLURM_JOB_ID=1", "SLURM_ARRAY_JOB_ID=1", "SLURM_ARRAY_TASK_ID=1", "bash",
               (submission / "1-motions.sbatch").string()});
  pause_for(1.0);
  if (!job.is_running()) figures.complaints.push_back(illness.name + ": the job did not wait");
  const std::string told = farm("status").output;
  if (told.find(illness.words) == std::string::npos)
    figures.complaints.push_back(illness.name + ": status tells " + told);
  disk.set_read_only(false);
  disk.resize(ample_room);
  Trial::expect_code(Trial::ended(job), 0, illness.name + ", then well", figures);
  const std::string log = text_of(submission / "log/tiny-1-motions-1_1.log");
  if (log.find("mien farm: continues after") == std::string::npos)
    figures.complaints.push_back(illness.name + ": the log tells " + log);
  ++figures.studies;
}

}  // namespace

Figures resumed_on_full_disks() {
  Figures figures{.fault = "resumed on a full disk"};
  with_own_mounts(figures, [](Figures& own) {
    const Scratch scratch;
    const fs::path manifest = scratch.write("tiny.yaml", tiny_study);
    resume_on_full_disk(manifest, scratch.path() / "out", own);
  });
  return figures;
}

Figures jobs_on_failing_disks() {
  Figures figures{.fault = "jobs whose folder is full or read-only for a while"};
  with_own_mounts(figures, [](Figures& own) {
    const Scratch scratch;
    const fs::path manifest = scratch.write("tiny.yaml", tiny_study);
    for (const Illness& illness : illnesses())
      wait_on_ailing_disk(illness, manifest, scratch.path() / illness.name, own);
  });
  return figures;
}

}  // namespace mien::test
