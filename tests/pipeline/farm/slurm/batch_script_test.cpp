#include "pipeline/farm/slurm/batch_script.h"

#include <chrono>
#include <fstream>
#include <iterator>
#include <regex>

#include <gtest/gtest.h>
#include <unistd.h>

#include "motion/error.h"
#include "motion/text/shell_word.h"
#include "pipeline/farm/fake_programs.h"
#include "pipeline/farm/slurm/job_attempts.h"
#include "pipeline/tasks/command_run.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using test::FakePrograms;
using test::TemporaryFolder;

std::string contents(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A job of one array in a folder of any name, whose worker is a script.
class BatchScript : public testing::Test {
 protected:
  explicit BatchScript(const std::string& name = "it's 100% \"$HOME\" `id` é # ;")
      : root(temporary.path() / name), folder(root / "farm" / "0001") {
    fs::create_directories(folder / "ends");
    call = {root / "mien", root / "my study.yaml", root, root, "walks", ""};
    job = {"0001", "2-frames", "mien:abc:0001:2-frames", 5};
  }

  fs::path write_script(const SlurmSite& site = {}) const {
    fs::path file = folder / "2-frames.sbatch";
    const std::string script = batch_script(job, folder, call, request, site);
    std::ofstream(file) << std::regex_replace(
        script, std::regex("patience=\\d+"),
        "patience=" + std::to_string(heartbeat_timeout_seconds));
    return file;
  }

  /// A worker that writes its arguments and then does this.
  void write_worker(const std::string& then) const {
    std::ofstream(call.program) << "#!/bin/bash\nprintf '<%s>' \"$@\" >" +
                                       motion::in_single_quotes((root / "words").string())
                                << "\n"
                                << then << "\n";
    fs::permissions(call.program, fs::perms::owner_all);
  }

  CommandResult run_element(int element, int restarts = 0, const SlurmSite& site = {}) const {
    return run_command(
        {"env", "SLURM_ARRAY_JOB_ID=17", "SLURM_ARRAY_TASK_ID=" + std::to_string(element),
         "SLURM_RESTART_COUNT=" + std::to_string(restarts), "SLURMD_NODENAME=n1", "bash",
         write_script(site).string()},
        std::chrono::seconds(60));
  }

  std::string end_note() const { return contents(folder / "ends" / "2-frames.3"); }

  TemporaryFolder temporary;
  fs::path root;
  fs::path folder;
  StudyCall call;
  BatchJob job;
  JobRequest request;
  int heartbeat_timeout_seconds = folder_wait_limit_seconds;  ///< as an operator may write it
};

TEST_F(BatchScript, IsSoundBashWhateverPathsAreCalled) {
  const CommandResult end =
      run_command({"bash", "-n", write_script().string()}, std::chrono::seconds(10));
  EXPECT_TRUE(end.succeeded()) << end.errors;
  job.elements = 0;
  EXPECT_TRUE(
      run_command({"bash", "-n", write_script().string()}, std::chrono::seconds(10)).succeeded());
}

TEST_F(BatchScript, RunsTheWorkerOnTheLineOfItsElement) {
  write_worker("exit 0");
  request.processors = 4;
  call.quality = "draft";
  call.key = "0123abcd";
  ASSERT_EQ(run_element(3).code, 0);
  EXPECT_EQ(contents(root / "words"), "<farm><worker><" + call.manifest.string() + "><--list><" +
                                          (folder / "2-frames.tasks").string() +
                                          "><--line><3><--out><" + root.string() +
                                          "><--jobs><4><--quality><draft><--expect><0123abcd>");
  EXPECT_EQ(end_note(), "");
}

TEST_F(BatchScript, GivesTheSiteATransientEndThreeTimesAndThenGivesUp) {
  write_worker("exit 75");
  const SlurmSite requeues{1001, true, true};
  EXPECT_EQ(run_element(3, 0, requeues).code, 75);
  EXPECT_EQ(run_element(3, 2, requeues).code, 75);
  const CommandResult last = run_element(3, 3, requeues);
  EXPECT_EQ(last.code, 70);
  EXPECT_NE(last.output.find("ended with 75 on n1 after 3 restarts"), std::string::npos);
  EXPECT_EQ(end_note(), "75 3 n1 \n");
}

TEST_F(BatchScript, AsksForTheQueueItselfWhereTheSiteDoesNot) {
  const FakePrograms programs;
  const std::string words = (programs.folder() / "words").string();
  programs.add("scontrol", "echo \"$@\" >>" + words);
  programs.add("squeue", "echo RUNNING");
  programs.add("sleep", "exit 0");
  write_worker("exit 75");
  EXPECT_EQ(run_element(3, 2).code, 75);
  EXPECT_EQ(programs.text_of("words"), "requeue 17_3\n");
  EXPECT_EQ(run_element(3, 3).code, 70);
  EXPECT_EQ(programs.text_of("words"), "requeue 17_3\n");
  write_worker("exit 78");
  EXPECT_EQ(run_element(3).code, 78);
  EXPECT_EQ(programs.text_of("words"), "requeue 17_3\nrequeuehold State=SpecialExit 17_3\n");
}

TEST_F(BatchScript, DoesNotBringACancelledJobToLife) {
  const FakePrograms programs;
  programs.add("scontrol", "echo \"$@\" >>" + (programs.folder() / "words").string());
  programs.add("squeue", "echo COMPLETING");
  write_worker("exit 75");
  EXPECT_EQ(run_element(3).code, 75);
  EXPECT_EQ(programs.text_of("words"), "");
}

TEST_F(BatchScript, WaitsForAFolderThatIsAwayBeforeItBegins) {
  const FakePrograms programs;
  programs.add("sleep", "mkdir -p " + motion::in_single_quotes((folder / "ends").string()));
  write_worker("echo made");
  fs::remove_all(folder / "ends");
  const CommandResult end = run_element(3);
  EXPECT_EQ(end.code, 0) << end.errors;
  EXPECT_NE(end.output.find("does not exist; waiting, at most 3600 s"), std::string::npos);
  EXPECT_NE(end.output.find("continues after waiting 10 s, because"), std::string::npos);
  EXPECT_NE(end.output.find("made\n"), std::string::npos);
}

TEST_F(BatchScript, CountsNoFailureOfAWorkerWhoseFolderWasNotWell) {
  const FakePrograms programs;
  const std::string ends = motion::in_single_quotes((folder / "ends").string());
  const std::string calls = motion::in_single_quotes((root / "calls").string());
  programs.add("sleep", "mkdir -p " + ends);
  const std::string count = "echo x >>" + calls + "; [ $(wc -l <" + calls + ") -gt 2 ] && exit 0\n";
  for (const std::string& first : {std::string("exit 74"), "rmdir " + ends + "; exit 75",
                                   "rmdir " + ends + "; exit 78", "rmdir " + ends + "; exit 1"}) {
    fs::remove(root / "calls");
    write_worker(count + first);
    EXPECT_EQ(run_element(3).code, 0) << first;
    EXPECT_EQ(contents(root / "calls"), "x\nx\nx\n") << first;
    EXPECT_EQ(end_note(), "") << first;
  }
}

TEST_F(BatchScript, WaitsForAFolderAsLongAsItHasPatienceAndIsHeldInTheEnd) {
  const FakePrograms programs;
  const std::string slept = motion::in_single_quotes((programs.folder() / "slept").string());
  programs.add("sleep", "echo \"$1\" >>" + slept);
  const SlurmSite requeues{1001, true, true};
  heartbeat_timeout_seconds = 120;
  write_worker("exit 74");
  EXPECT_EQ(run_element(3, 2, requeues).code, 75);
  EXPECT_EQ(programs.text_of("slept"), "60\n60\n");
  EXPECT_EQ(run_element(3, 3, requeues).code, 78);
  EXPECT_EQ(end_note(), "74 3 n1 \n");
  fs::remove(root / "words");
  fs::remove_all(folder / "ends");
  fs::remove(programs.folder() / "slept");
  EXPECT_EQ(run_element(3, 0, requeues).code, 75);
  std::string tens;
  for (int i = 0; i < 12; ++i) tens += "10\n";
  EXPECT_EQ(programs.text_of("slept"), tens);
  EXPECT_EQ(run_element(3, 3, requeues).code, 78);
  EXPECT_FALSE(fs::exists(root / "words")) << "the worker would make the folder anew";
}

TEST_F(BatchScript, EndsWhileItWaitsWhenItIsToldToStop) {
  write_worker("exit 0");
  fs::remove_all(folder / "ends");
  const std::string run = "bash " +
                          motion::in_single_quotes(write_script({1001, true, true}).string()) +
                          " >" + motion::in_single_quotes((root / "said").string()) +
                          " & job=$!\n"
                          "until [ -s " +
                          motion::in_single_quotes((root / "said").string()) +
                          " ]; do sleep 0.05; done\n"
                          "kill -TERM $job; wait $job; exit $?";
  EXPECT_EQ(run_command({"bash", "-c", run}, std::chrono::seconds(30)).code, 75);
}

TEST_F(BatchScript, WritesItsLogItselfWhereSlurmRunsIt) {
  EXPECT_NE(contents(write_script()).find("#SBATCH --output=/dev/null\n"), std::string::npos);
  fs::create_directories(folder / "log");
  write_worker("echo made; echo ill >&2; exit 70");
  const CommandResult end =
      run_command({"env", "SLURM_JOB_ID=20", "SLURM_ARRAY_JOB_ID=17", "SLURM_ARRAY_TASK_ID=3",
                   "SLURMD_NODENAME=n1", "bash", write_script().string()},
                  std::chrono::seconds(60));
  EXPECT_EQ(end.code, 70);
  EXPECT_EQ(end.output + end.errors, "");
  const std::string log = contents(folder / "log" / "walks-2-frames-17_3.log");
  EXPECT_TRUE(log.starts_with("made\nill\n")) << log;
  EXPECT_NE(log.find("ended with 70 on n1"), std::string::npos) << log;
}

TEST_F(BatchScript, EndsOtherwiseAsTheWorkerDoes) {
  for (const int code : {1, 65, 70, 137}) {
    write_worker(code == 137 ? "kill -9 $$" : "exit " + std::to_string(code));
    EXPECT_EQ(run_element(3, 1).code, code);
    EXPECT_EQ(end_note(), std::to_string(code) + " 1 n1 \n");
  }
  write_worker("exit 0");
  EXPECT_EQ(run_element(3, 2).code, 0);
  EXPECT_EQ(end_note(), "");
}

/// A control group of this test's own, called as Slurm calls a job's, in which little memory may be
/// used; as root, with cgroup v1 or v2.
class LittleMemory {
 public:
  explicit LittleMemory(const std::string& job) {
    for (const char* root : {"/sys/fs/cgroup/memory", "/sys/fs/cgroup"}) {
      std::error_code refused;
      const bool is_first = root == std::string("/sys/fs/cgroup/memory");
      folder_ = fs::path(root) / ("mien-test-" + std::to_string(::getpid())) / ("job_" + job);
      if (!fs::create_directories(folder_, refused)) continue;
      std::ofstream(folder_ / (is_first ? "memory.limit_in_bytes" : "memory.max")) << "32M\n";
      is_there_ = fs::exists(folder_ / (is_first ? "memory.oom_control" : "memory.events"));
      if (is_there_) return;
      remove();
    }
  }
  ~LittleMemory() { remove(); }
  LittleMemory(const LittleMemory&) = delete;
  LittleMemory& operator=(const LittleMemory&) = delete;

  bool is_there() const { return is_there_; }
  std::string processes() const { return (folder_ / "cgroup.procs").string(); }

 private:
  void remove() const {
    ::rmdir(folder_.c_str());
    ::rmdir(folder_.parent_path().c_str());
  }

  fs::path folder_;
  bool is_there_ = false;
};

TEST_F(BatchScript, NotesThatTheKernelCountsAKillForWantOfMemory) {
  const std::string number = std::to_string(::getpid());
  const LittleMemory group(number);
  if (!group.is_there()) GTEST_SKIP() << "no control group of its own can be made here";
  const auto run_in_group = [&] {
    const std::string script = "echo $$ >" + motion::in_single_quotes(group.processes()) +
                               " && exec bash " + motion::in_single_quotes(write_script().string());
    return run_command({"env", "SLURM_ARRAY_TASK_ID=3", "SLURMD_NODENAME=n1",
                        "SLURM_JOB_ID=" + number, "bash", "-c", script},
                       std::chrono::seconds(60));
  };
  write_worker("kill -9 $$");
  EXPECT_EQ(run_in_group().code, 137);
  EXPECT_EQ(end_note(), "137 0 n1 \n") << "somebody else sent the signal";
  write_worker("exec tail /dev/zero");
  EXPECT_EQ(run_in_group().code, 137);
  EXPECT_EQ(end_note(), "137 0 n1 memory\n");
}

TEST_F(BatchScript, TranslatesTheCodesOfMienRun) {
  job.elements = 0;
  const SlurmSite requeues{1001, true, true};
  const auto code_after = [&](int code, const char* restarts) {
    write_worker("exit " + std::to_string(code));
    return run_command({"env", std::string("SLURM_RESTART_COUNT=") + restarts, "bash",
                        write_script(requeues).string()},
                       std::chrono::seconds(10))
        .code;
  };
  EXPECT_EQ(code_after(130, "0"), 75);
  EXPECT_EQ(code_after(130, "3"), 70);
  EXPECT_EQ(code_after(2, "0"), 65);
  EXPECT_EQ(code_after(1, "0"), 1);
}

TEST_F(BatchScript, PassesSigtermOnAndWaitsForTheWorkersCode) {
  write_worker("trap 'exit 75' TERM\necho here >" +
               motion::in_single_quotes((root / "begun").string()) +
               "\nwhile :; do sleep 0.05; done");
  const std::string run = "bash " +
                          motion::in_single_quotes(write_script({1001, true, true}).string()) +
                          " & job=$!\n"
                          "until [ -s " +
                          motion::in_single_quotes((root / "begun").string()) +
                          " ]; do sleep 0.05; done\n"
                          "kill -TERM $job; wait $job; exit $?";
  EXPECT_EQ(run_command({"bash", "-c", run}, std::chrono::seconds(30)).code, 75);
}

TEST_F(BatchScript, AsksForWhatTheOperatorAsksFor) {
  const std::string plain = batch_script(job, folder, call, request, {});
  for (const char* option : {"--partition", "--time", "--mem", "--account", "%8"}) {
    EXPECT_EQ(plain.find(option), std::string::npos) << option;
  }
  request = {"long", "1:00:00", "2G", "lab", 8, 3};
  const std::string text = batch_script(job, folder, call, request, {});
  for (const char* line :
       {"#SBATCH --array=1-5%8\n", "#SBATCH --partition=\"long\"\n", "#SBATCH --time=\"1:00:00\"\n",
        "#SBATCH --mem=\"2G\"\n", "#SBATCH --account=\"lab\"\n", "#SBATCH --cpus-per-task=3\n",
        "#SBATCH --requeue\n", "#SBATCH --signal=B:TERM@30\n", "#SBATCH --open-mode=append\n",
        "#SBATCH --kill-on-invalid-dep=yes\n", "#SBATCH --comment=\"mien:abc:0001:2-frames\"\n",
        "#SBATCH --job-name=\"walks-2-frames\"\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

TEST_F(BatchScript, StartsTheProgramThatTheOperatorNames) {
  const fs::path other = root / "mien of all nodes";
  std::ofstream(other) << "#!/bin/sh\necho \"other $1\" > "
                       << motion::in_single_quotes((root / "said").string()) << "\n";
  fs::permissions(other, fs::perms::owner_all);
  request.program = other.string();
  EXPECT_EQ(run_element(3).code, 0);
  EXPECT_EQ(contents(root / "said"), "other farm\n");
}

TEST_F(BatchScript, RefusesPathsThatNoBatchFileCanName) {
  for (const char* name : {"a\nb", "a\\b", "a\tb"}) {
    call.out = fs::path("/studies") / name;
    EXPECT_THROW(batch_script(job, folder, call, request, {}), Error) << name;
  }
}

}  // namespace
}  // namespace mien::pipeline
