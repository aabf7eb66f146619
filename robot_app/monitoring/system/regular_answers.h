// Asks the same question again and again on a thread of its own: for what may hang, as a network, a
// disk or the kernel's list of links, so that it delays nothing but its own answer.
//
//   RegularAnswers<std::string, double> used([](const std::string& disk) { return Used(disk); });
//   used.Ask("/", std::chrono::seconds(1));
//   if (const auto answer = used.Take()) ...
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_REGULAR_ANSWERS_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_REGULAR_ANSWERS_H_

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "bt_core/base/clock.h"

namespace coppice::robot::monitoring {

/// Ask and Take are for any thread and never wait for an answer; the end waits for the one that is
/// under way.
template <class Question, class Answer>
class RegularAnswers {
 public:
  using Work = std::function<Answer(const Question&)>;

  explicit RegularAnswers(Work work) : work_(std::move(work)), thread_([this] { Run(); }) {}
  ~RegularAnswers() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  RegularAnswers(const RegularAnswers&) = delete;
  RegularAnswers& operator=(const RegularAnswers&) = delete;

  /// From now on, beginning at once; nothing is asked no more. Answers to older questions are
  /// dropped.
  void Ask(std::optional<Question> question, Duration period) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      question_ = std::move(question);
      period_ = period;
      ++questions_;
      answer_.reset();
    }
    changed_.notify_all();
  }

  /// The newest answer; each is given once.
  std::optional<Answer> Take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(answer_, std::nullopt);
  }

 private:
  void Run() {
    std::unique_lock<std::mutex> lock(mutex_);
    auto next = std::chrono::steady_clock::now();
    int asked = 0;  // the question that was asked last
    while (true) {
      changed_.wait_until(lock, next, [&] { return is_ending_ || asked != questions_; });
      if (is_ending_) return;
      asked = questions_;
      next = std::chrono::steady_clock::now() + (question_ ? period_ : std::chrono::hours(1));
      if (question_) FindAnswer(lock);
    }
  }

  void FindAnswer(std::unique_lock<std::mutex>& lock) {
    const Question question = *question_;
    const int number = questions_;
    lock.unlock();
    Answer answer = work_(question);
    lock.lock();
    if (number == questions_) answer_ = std::move(answer);
  }

  const Work work_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_ending_ = false;
  int questions_ = 0;  // since the start
  std::optional<Question> question_;
  Duration period_{0};
  std::optional<Answer> answer_;
  std::thread thread_;  // last: it uses all of them
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_REGULAR_ANSWERS_H_
