// Runs the tests of a module. Where MIEN_TEST_TALLY names a file, lines are added to it that
// `./mien test` adds up: "ran 12" and, for each skipped test, "skipped Suite.Test: reason".

#include <cstdlib>
#include <iostream>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

class Tally : public testing::EmptyTestEventListener {
 public:
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (result.skipped()) reason_ = first_line(result.message());
  }

  void OnTestEnd(const testing::TestInfo& test) override {
    if (test.result()->Skipped())
      lines_ += std::string("skipped ") + test.test_suite_name() + "." + test.name() + ": " +
                reason_ + "\n";
    reason_.clear();
  }

  void OnTestProgramEnd(const testing::UnitTest& all) override {
    const int skipped = all.skipped_test_count();
    if (skipped > 0 && skipped == all.test_to_run_count())
      std::cout << "all tests were skipped\n";  // suites.cmake looks for it
    const char* file = std::getenv("MIEN_TEST_TALLY");
    if (file == nullptr) return;
    lines_ += "ran " + std::to_string(all.test_to_run_count() - skipped) + "\n";
    // One write: other programs add their lines at the same time.
    const int tally = ::open(file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (tally < 0 || ::write(tally, lines_.data(), lines_.size()) < 0)
      std::cerr << file << " cannot be written\n";
    if (tally >= 0) ::close(tally);
  }

 private:
  std::string reason_;
  std::string lines_;
};

}  // namespace

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  auto& all = *testing::UnitTest::GetInstance();
  all.listeners().Append(new Tally);
  const int code = RUN_ALL_TESTS();
  if (!testing::GTEST_FLAG(list_tests) && all.test_to_run_count() == 0) {
    std::cerr << "no test has a name like " << testing::GTEST_FLAG(filter) << "\n";
    return 1;
  }
  return code;
}
