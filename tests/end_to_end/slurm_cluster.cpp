#include "end_to_end/slurm_cluster.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace mien::test {

namespace {

namespace fs = std::filesystem;

/// Daemons lie where only root's PATH leads.
std::string program_at(const std::string& name) {
  for (const char* folder : {"/usr/sbin", "/usr/bin", "/sbin", "/bin", "/usr/local/sbin"}) {
    const fs::path file = fs::path(folder) / name;
    if (::access(file.c_str(), X_OK) == 0) return file.string();
  }
  return "";
}

/// Since Slurm 23.11, daemons end where there are no control groups, although nothing here uses
/// them, unless they are told not to; older ones refuse to be told.
bool wants_control_groups() {
  const std::string told =
      run_program({program_at("slurmd"), "-V"}, 10.0).output;  // "slurm 23.11.4"
  int year = 0, month = 0;
  const std::size_t space = told.find(' ');
  if (space == std::string::npos) return false;
  std::sscanf(told.c_str() + space, "%d.%d", &year, &month);
  return year > 23 || (year == 23 && month >= 11);
}

std::string user_name() {
  const passwd* user = ::getpwuid(::getuid());
  return user != nullptr ? user->pw_name : std::to_string(::getuid());
}

bool is_free(int port) {
  const int number = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  const int result = ::bind(number, reinterpret_cast<const sockaddr*>(&address), sizeof address);
  ::close(number);
  return result == 0;
}

/// The first of three in a row.
int free_ports() {
  std::mt19937 random(static_cast<unsigned>(::getpid()));
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const int port = 20000 + static_cast<int>(random() % 10000);
    if (is_free(port) && is_free(port + 1) && is_free(port + 2)) return port;
  }
  throw std::runtime_error("no free ports");
}

pid_t process_in(const fs::path& file) {
  std::ifstream stream(file);
  pid_t process = 0;
  return stream >> process && process > 1 ? process : 0;
}

bool is_alive(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  return status >> number >> name >> state && state != "Z";
}

void end_process(pid_t process, int signal) {
  if (process == 0) return;
  ::kill(process, signal);
  wait_until(5.0, [&] { return !is_alive(process); });
}

/// Processes that were begun with this variable, but for this one.
std::vector<pid_t> processes_with(const std::string& variable) {
  std::vector<pid_t> found;
  std::error_code error;
  for (fs::directory_iterator at("/proc", error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (std::stoi(name) == ::getpid()) continue;
    const std::string environment = std::string(1, '\0') + text_of(at->path() / "environ");
    const std::string wanted = std::string(1, '\0') + variable + std::string(1, '\0');
    if (environment.find(wanted) != std::string::npos) found.push_back(std::stoi(name));
  }
  return found;
}

std::string command_of(pid_t process) {
  std::string name = text_of("/proc/" + std::to_string(process) + "/comm");
  while (name.ends_with('\n')) name.pop_back();
  return name;
}

}  // namespace

bool wait_until(double seconds, const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  return true;
}

std::string SlurmCluster::obstacle() {
  for (const char* name : {"munged", "slurmctld", "slurmd", "sbatch", "squeue"}) {
    if (program_at(name).empty()) return std::string(name) + " is not installed";
  }
  return "";
}

SlurmCluster::SlurmCluster(Requeue requeue) : port_(free_ports()) {
  fs::permissions(folder(), fs::perms(0711));
  for (const char* name : {"state", "log", "spool-n1", "spool-n2"}) {
    fs::create_directory(folder() / name);
  }
  write_configuration(requeue);
  ::setenv("SLURM_CONF", (folder() / "slurm.conf").c_str(), 1);
  try {
    start();
  } catch (...) {
    stop();
    throw;
  }
}

SlurmCluster::~SlurmCluster() { stop(); }

void SlurmCluster::write_configuration(Requeue requeue) const {
  const std::string at = folder().string();
  const std::string user = user_name();
  std::ofstream file(folder() / "slurm.conf");
  file << "ClusterName=mientest\nSlurmctldHost=localhost\nSlurmctldPort=" << port_
       << "\nAuthType=auth/munge\nAuthInfo=socket=" << at << "/munge.sock,cred_expire=5"
       << "\nSlurmUser=" << user << "\nSlurmdUser=" << user << "\nStateSaveLocation=" << at
       << "/state\nSlurmdSpoolDir=" << at << "/spool-%n\nSlurmdPidFile=" << at
       << "/slurmd-%n.pid\nSlurmctldPidFile=" << at << "/slurmctld.pid\nSlurmctldLogFile=" << at
       << "/log/slurmctld.log\nSlurmdLogFile=" << at << "/log/slurmd-%n.log\n"
       << "ProctrackType=proctrack/pgid\nTaskPlugin=task/none\nSwitchType=switch/none\n"
       << "MpiDefault=none\nSchedulerType=sched/backfill\nSelectType=select/cons_tres\n"
       << "SelectTypeParameters=CR_CPU\nReturnToService=2\nSlurmdTimeout=10\nKillWait=3\n"
       << "JobRequeue=1\nMaxArraySize=1001\n"
       << "SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1,"
       << "sched_min_interval=0,requeue_setup_env_fail\n"
       << "JobCompType=jobcomp/filetxt\nJobCompLoc=" << at << "/log/jobcomp.txt\n"
       << "AccountingStorageType=accounting_storage/none\n";
  if (requeue == Requeue::by_site) file << "RequeueExit=75\nRequeueExitHold=78\n";
  for (int node = 1; node <= 2; ++node) {
    file << "NodeName=n" << node << " NodeHostname=localhost Port=" << port_ + node
         << " CPUs=1 RealMemory=1000 State=UNKNOWN\n";
  }
  file << "PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP\n";
  if (wants_control_groups()) std::ofstream(folder() / "cgroup.conf") << "CgroupPlugin=disabled\n";
}

void SlurmCluster::start() {
  const std::string at = folder().string();
  std::mt19937 random(static_cast<unsigned>(::getpid()));
  std::string key;
  for (int i = 0; i < 1024; ++i) key += static_cast<char>(random());
  scratch_.write("munge.key", key);
  fs::permissions(folder() / "munge.key", fs::perms::owner_read);
  must_run({program_at("munged"), "--key-file=" + at + "/munge.key",
            "--socket=" + at + "/munge.sock", "--pid-file=" + at + "/munged.pid",
            "--log-file=" + at + "/log/munged.log", "--seed-file=" + at + "/munge.seed",
            "--force"});
  start_controller(false);
  restart_node(1);
  restart_node(2);
  const bool is_up = wait_until(30.0, [] {
    const std::string states = run_program({"sinfo", "-h", "-N", "-o", "%t"}, 10.0).output;
    return states == "idle\nidle\n";
  });
  if (is_up) return;
  throw std::runtime_error(
      "the cluster does not come up: " + text_of(folder() / "log/slurmctld.log") +
      text_of(folder() / "log/slurmd-n1.log"));
}

void SlurmCluster::stop() const {
  for (const char* name : {"slurmd-n1.pid", "slurmd-n2.pid", "slurmctld.pid", "munged.pid"}) {
    end_process(process_in(folder() / name), SIGTERM);
  }
  const std::string ours = "SLURM_CONF=" + (folder() / "slurm.conf").string();
  for (const pid_t process : processes_with(ours)) ::kill(process, SIGKILL);
  ::unsetenv("SLURM_CONF");
}

void SlurmCluster::kill_node(int node) const {
  end_process(process_in(folder() / ("slurmd-n" + std::to_string(node) + ".pid")), SIGKILL);
}

void SlurmCluster::restart_node(int node) const {
  must_run({program_at("slurmd"), "-N", "n" + std::to_string(node)});
}

void SlurmCluster::kill_steps() const {
  const std::string ours = "SLURM_CONF=" + (folder() / "slurm.conf").string();
  for (const pid_t process : processes_with(ours)) {
    const std::string command = command_of(process);
    const bool is_of_a_job =
        text_of("/proc/" + std::to_string(process) + "/environ").find("SLURM_JOB_ID=") !=
        std::string::npos;
    if (command == "slurmstepd" || is_of_a_job) ::kill(process, SIGKILL);
  }
}

void SlurmCluster::kill_controller() const {
  end_process(process_in(folder() / "slurmctld.pid"), SIGKILL);
}

void SlurmCluster::start_controller(bool forgets) const {
  if (forgets) {
    fs::remove_all(folder() / "state");
    fs::create_directory(folder() / "state");
  }
  must_run({program_at("slurmctld")});
}

std::vector<std::string> SlurmCluster::queue() const {
  std::vector<std::string> rows;
  std::istringstream lines(
      must_run({"squeue", "-h", "-r", "-a", "-t", "all", "-o", "%F|%K|%T|%r|%N|%k"}));
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  return rows;
}

bool SlurmCluster::wait_until_empty(double seconds) const {
  return wait_until(seconds, [] {
    const Ended ended = run_program({"squeue", "-h"}, 10.0);
    return ended.code == 0 && ended.output.empty();
  });
}

}  // namespace mien::test
