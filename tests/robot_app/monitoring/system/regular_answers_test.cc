#include "robot_app/monitoring/system/regular_answers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <string>

namespace coppice::robot::monitoring {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

using Answers = RegularAnswers<std::string, std::string>;

std::string Politely(const std::string& question) { return question + ", please"; }

// The next answer; empty after 10 s.
std::string Next(Answers& answers) {
  const auto until = std::chrono::steady_clock::now() + seconds(10);
  while (std::chrono::steady_clock::now() < until) {
    if (auto answer = answers.Take()) return *std::move(answer);
    std::this_thread::yield();
  }
  return "";
}

TEST(RegularAnswers, ComeAgainAndAgain) {
  Answers answers(&Politely);
  answers.Ask("tea", milliseconds(1));
  for (int round = 0; round < 3; ++round) EXPECT_EQ(Next(answers), "tea, please");
}

TEST(RegularAnswers, ANewQuestionIsAskedAtOnce) {
  Answers answers(&Politely);
  answers.Ask("tea", std::chrono::hours(1));
  EXPECT_EQ(Next(answers), "tea, please");
  answers.Ask("milk", std::chrono::hours(1));
  EXPECT_EQ(Next(answers), "milk, please");
}

TEST(RegularAnswers, ToAskDoesNotWaitForAnAnswerThatHangsAndTheOldOneIsDropped) {
  std::promise<void> come, go;
  Answers answers([&](const std::string& question) {
    if (question != "tea") return Politely(question);
    come.set_value();
    go.get_future().wait();
    return std::string("too late");
  });
  answers.Ask("tea", std::chrono::hours(1));
  come.get_future().wait();
  answers.Ask("milk", std::chrono::hours(1));  // would hang here
  EXPECT_FALSE(answers.Take().has_value());
  go.set_value();
  EXPECT_EQ(Next(answers), "milk, please");
}

TEST(RegularAnswers, NothingIsAskedWithoutAQuestion) {
  std::atomic<int> asked{0};
  {
    Answers answers([&](const std::string& question) { return ++asked, question; });
    answers.Ask("tea", std::chrono::hours(1));
    EXPECT_EQ(Next(answers), "tea");
    answers.Ask(std::nullopt, Duration::zero());
  }
  EXPECT_EQ(asked, 1);
}

}  // namespace
}  // namespace coppice::robot::monitoring
