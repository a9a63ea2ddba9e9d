#include <fstream>
#include <optional>
#include <sstream>

#include <gtest/gtest.h>

#include "pipeline/commands/line/program.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

enum class Fruit { apple, pear };

/// A program of one command that takes one of each kind.
struct Market {
  bool is_open = false;
  int count = 3;
  double share = 0.5;
  std::optional<double> weight;
  std::string place;
  std::vector<std::string> names;
  Fruit fruit = Fruit::pear;
  std::vector<Fruit> basket;
  std::vector<std::string> given;
  int runs = 0;

  Command program() {
    const WordValues<Fruit> fruits = {{"apple", Fruit::apple}, {"pear", Fruit::pear}};
    CommandOption share_option = option("--share", &share, "Share").between(0.0, 1.0);
    share_option.given = &given;
    const Command sell = {
        .name = "sell",
        .summary = "Sell fruits",
        .options = {argument("place", &place, "Where"),
                    option("--count,-c", &count, "How many")
                        .between(1, 9)
                        .with_default()
                        .formerly("--amount"),
                    option("--weight", &weight, "Of one").positive().needs("--count"),
                    option("--names", &names, "Names").with_commas().formerly("--titles"),
                    choice("--fruit", fruit, fruits, "Which"),
                    choice("--basket", basket, fruits, "Several"), share_option,
                    flag("--open", &is_open, "Now").excludes("--names").formerly("--ajar")},
        .notes = "Example:\n  mien sell here",
        .run = [this](const Console&) { return ++runs, exit_done; }};
    const Command close = {.name = "close", .run = [](const Console&) { return exit_failed; }};
    return {.name = "mien", .summary = "A market", .commands = {sell, close}};
  }
};

/// What a command line ends with: its exit code and what it says of faults.
std::pair<int, std::string> ended(Market& market, std::vector<const char*> words) {
  words.insert(words.begin(), "mien");
  std::ostringstream out;
  std::ostringstream err;
  const int code = run_command_line(market.program(), static_cast<int>(words.size()), words.data(),
                                    {out, err, false, {}});
  return {code, out.str() + err.str()};
}

TEST(CommandValues, TakeWhatIsTypedIntoTheirVariables) {
  Market market;
  const auto [code, told] =
      ended(market, {"sell", "here", "-c", "7", "--weight", "0.25", "--names", "a,b", "--fruit",
                     "apple", "--basket", "pear,apple", "--share", "1"});
  EXPECT_EQ(code, exit_done) << told;
  EXPECT_EQ(market.runs, 1);
  EXPECT_EQ(market.place, "here");
  EXPECT_EQ(market.count, 7);
  EXPECT_EQ(market.weight, 0.25);
  EXPECT_EQ(market.names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(market.fruit, Fruit::apple);
  EXPECT_EQ(market.basket, (std::vector<Fruit>{Fruit::pear, Fruit::apple}));
  EXPECT_EQ(market.given, std::vector<std::string>{"--share"});
  EXPECT_FALSE(market.is_open);
}

TEST(CommandValues, RefuseWhatTheyDoNotAllowAndRunNothing) {
  const std::pair<std::vector<const char*>, std::string> cases[] = {
      {{"sel"}, "unknown command \"sel\"; did you mean \"sell\"?\n"},
      {{"sell"}, "mien sell: place is missing; write mien sell <place>; see mien sell --help"},
      {{"sell", "a", "--count", "10"}, "mien sell: --count: 10 is not a whole number from 1 to 9;"},
      {{"sell", "a", "--count", "0"}, "mien sell: --count: 0 is not a whole number from 1 to 9;"},
      {{"sell", "a", "--count", "1.5"},
       "mien sell: --count: 1.5 is not a whole number from 1 to 9;"},
      {{"sell", "a", "--count", "few"},
       "mien sell: --count: few is not a whole number from 1 to 9;"},
      {{"sell", "a", "--count", "1", "--weight", "-1"},
       "mien sell: --weight: -1 is not a number above 0;"},
      {{"sell", "a", "--weight", "1"}, "mien sell: --weight requires --count;"},
      {{"sell", "a", "--fruit", "plum"}, "mien sell: --fruit: \"plum\" is not one of apple, pear;"},
      {{"sell", "a", "--basket", "pear,aple"}, "--basket: \"aple\": did you mean \"apple\"?"},
      {{"sell", "a", "--names", "b", "--open"}, "excludes"},
      {{"sell", "a", "--open", "--shar", "1"}, "unknown option --shar; did you mean --share?"},
      {{"sell", "a", "--names", ""}, "--names: empty; give a value, or omit it"},
      {{"sell", "a", "--fruit", ""}, "--fruit: "},
      {{"sell", ""}, "place: empty; give a value, or omit it"},
      {{"sell", "a", "b"}, "mien sell: unexpected argument \"b\";"}};
  for (const auto& [words, fault] : cases) {
    Market market;
    const auto [code, told] = ended(market, words);
    EXPECT_EQ(code, exit_bad_input) << fault;
    EXPECT_NE(told.find(fault), std::string::npos) << told;
    EXPECT_EQ(market.runs, 0);
  }
}

TEST(CommandValues, TakeWordsThatAreNamesOfOtherCommandsToo) {
  Market market;
  const auto [code, told] = ended(market, {"sell", "close"});
  EXPECT_EQ(code, exit_done) << told;
  EXPECT_EQ(market.place, "close");
}

TEST(FormerNames, AreUnderstoodWithAWarning) {
  Market market;
  const auto [code, told] = ended(market, {"sell", "--titles", "a,b", "--amount=7", "here",
                                           "--weight", "0.25", "--titles", "c"});
  EXPECT_EQ(code, exit_done);
  EXPECT_EQ(market.count, 7);
  EXPECT_EQ(market.weight, 0.25);  // which needs --count
  EXPECT_EQ(market.place, "here");
  EXPECT_EQ(market.names, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(told,
            "warning: --amount is now called --count\nwarning: --titles is now called --names\n");

  Market shut;
  EXPECT_EQ(ended(shut, {"sell", "here", "--ajar"}),
            std::pair(exit_done, std::string("warning: --ajar is now called --open\n")));
  EXPECT_TRUE(shut.is_open);
}

TEST(FormerNames, AreRefusedBesideTheNewOnesAndWithTheirFaults) {
  const std::pair<std::vector<const char*>, std::string> cases[] = {
      {{"sell", "a", "--amount", "3", "--count", "4"},
       "mien sell: --amount: now called --count, which is given too; omit it; see mien sell"},
      {{"sell", "a", "--count", "4", "--amount", "3"}, "--amount: now called --count"},
      {{"sell", "a", "--amount", "10"}, "--count: 10 is not a whole number from 1 to 9;"},
      {{"sell", "a", "--titles", "b", "--open"}, "excludes"},
      {{"sell", "a", "--amount"}, "mien sell: value missing; see mien sell --help"},
      {{"sell", "a", "--amoun", "1"}, "unknown option --amoun; "}};
  for (const auto& [words, fault] : cases) {
    Market market;
    const auto [code, told] = ended(market, words);
    EXPECT_EQ(code, exit_bad_input) << fault;
    EXPECT_NE(told.find(fault), std::string::npos) << told;
    EXPECT_EQ(told.find("did you mean --amount"), std::string::npos) << told;
    EXPECT_EQ(market.runs, 0);
  }
}

TEST(FormerNames, AreRequiredNoMoreThanTheNewOnes) {
  std::string reason;
  const Command program = {
      .name = "mien",
      .options = {option("--reason", &reason, "Why").required().formerly("--why")},
      .run = [](const Console&) { return exit_done; }};
  std::ostringstream out;
  const char* const words[] = {"mien", "--why", "agreed"};
  EXPECT_EQ(run_command_line(program, 3, words, {out, out, false, {}}), exit_done) << out.str();
  EXPECT_EQ(reason, "agreed");
}

TEST(FormerNames, AreNotInHelp) {
  Market market;
  const std::string help = ended(market, {"sell", "--help"}).second;
  for (const char* former : {"--amount", "--titles", "--ajar"})
    EXPECT_EQ(help.find(former), std::string::npos) << help;
}

TEST(CommandValues, AreWhatHelpTells) {
  Market market;
  const auto [code, help] = ended(market, {"help", "sell"});
  EXPECT_EQ(code, exit_done);
  EXPECT_EQ(market.runs, 0);
  for (const std::string words :
       {"Sell fruits\n", "-c,--count INT", "--fruit apple|pear", "--basket apple|pear ...",
        "--weight FLOAT", "\nExample:\n  mien sell here\n"})
    EXPECT_NE(help.find(words), std::string::npos) << words << "\n" << help;
  const Command program = market.program();
  for (const CommandOption& option : program.commands[0].options)
    EXPECT_NE(help.find(option.is_argument() ? option.argument : option.names.back()),
              std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
