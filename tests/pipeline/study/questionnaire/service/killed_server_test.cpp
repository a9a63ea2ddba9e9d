#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "pipeline/study/questionnaire/service/served_example.h"
#include "pipeline/study/questionnaire/service/service.h"
#include "pipeline/study/server/http_server.h"
#include "pipeline/study/server/raw_client.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// What the processes of this test tell one another.
struct Board {
  std::atomic<int> port = 0;      ///< of the server that runs; 0: none yet
  std::atomic<int> answered = 0;  ///< records that a client was told to be stored
  std::atomic<int> killed = 0;
  std::atomic<bool> is_over = false;
};

Board& shared_board() {
  void* memory =
      mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return *new (memory) Board();
}

void nap() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

[[noreturn]] void serve_until_killed(const ServedStudy& study, const std::filesystem::path& file,
                                     Board& board) {
  try {
    SessionStore store(file);
    QuestionnaireService service(study, store);
    HttpSettings settings;
    settings.port = board.port;
    const HttpServer server(settings,
                            [&](const HttpRequest& request) { return service.answer(request); });
    board.port = server.port();
    while (!board.is_over) nap();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "server: %s\n", error.what());
    _exit(1);
  }
  _exit(0);
}

/// Starts servers one after the other, and kills each when its share of the answers is in.
[[noreturn]] void start_and_kill_servers(const ServedStudy& study,
                                         const std::filesystem::path& file, int records, int kills,
                                         Board& board) {
  for (int round = 0; round <= kills; ++round) {
    const pid_t server = fork();
    if (server == 0) serve_until_killed(study, file, board);
    const int share = (round + 1) * records / (kills + 1);
    while (!board.is_over && (round == kills || board.answered < share)) nap();
    if (round < kills) {
      kill(server, SIGKILL);
      ++board.killed;
    }
    int status = 0;
    waitpid(server, &status, 0);
    if (round < kills ? !WIFSIGNALED(status) : !WIFEXITED(status) || WEXITSTATUS(status) != 0)
      _exit(1);
  }
  _exit(0);
}

/// Asks until there is an answer, like the page.
std::string ask_until_answered(const Board& board, const std::string& request) {
  while (!board.is_over) {
    try {
      const std::string answer = reply_of(board.port, request);
      if (status_in(answer) != 0) return answer;
    } catch (const std::runtime_error&) {  // between two servers
    }
    nap();
  }
  return {};
}

/// Participants who answer at once while servers are killed: each answer must be there once.
void answer_while_killing(int participants, int kills) {
  const test::TemporaryFolder folder;
  const ServedStudy study = example_study(folder.path(), participants, 12);
  const std::filesystem::path file = folder.path() / "answers.db";
  std::vector<std::string> links;
  {
    SessionStore store(file);
    const QuestionnaireService service(study, store);
    for (const SessionState& state : service.sessions().states())
      links.push_back(state.session.link);
  }
  const std::vector<std::string> names = record_names(study.plans[0], study.facts);
  const int records = participants * static_cast<int>(names.size());
  Board& board = shared_board();
  const pid_t keeper = fork();
  if (keeper == 0) start_and_kill_servers(study, file, records, kills, board);
  while (board.port == 0) nap();

  std::atomic<int> refused = 0;
  std::vector<std::thread> clients;
  for (int index = 0; index < participants; ++index) {
    clients.emplace_back([&, index] {
      const std::string place = "/s/" + links[static_cast<std::size_t>(index)] + "/";
      for (const std::string& name : names) {
        const std::string record =
            good_record(study, index, name, "browser-" + std::to_string(index)).dump();
        if (name == "trial-3")  // a reload in the middle
          refused +=
              status_in(ask_until_answered(board, get_request(place + "session.json"))) != 200;
        const std::string answer =
            ask_until_answered(board, post_request(place + "records/" + name, record));
        if (status_in(answer) != 200) ++refused;
        ++board.answered;
      }
    });
  }
  for (std::thread& client : clients) client.join();
  board.is_over = true;
  int status = 0;
  waitpid(keeper, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(refused, 0);
  EXPECT_EQ(board.killed, kills);

  SessionStore store(file);
  EXPECT_EQ(store.records().size(), static_cast<std::size_t>(records));
  for (int index = 0; index < participants; ++index) {
    const std::vector<StoredRecord> stored = store.records_of(index);
    ASSERT_EQ(stored.size(), names.size()) << index;
    for (std::size_t at = 0; at < names.size(); ++at)
      EXPECT_EQ(stored[at].content,
                good_record(study, index, names[at], "browser-" + std::to_string(index)).dump());
  }
}

TEST(KilledServer, LosesAndDoublesNoAnswerOfAFewParticipants) { answer_while_killing(4, 2); }

TEST(KilledServer, LosesAndDoublesNoAnswerOfTwentyParticipants) { answer_while_killing(20, 5); }

TEST(KilledServer, LosesAndDoublesNoAnswerOfTwoHundredParticipants) {
  answer_while_killing(200, 20);
}

}  // namespace
}  // namespace mien::pipeline
