#include "robot_app/monitoring/system/remote_watch.h"

#include <utility>

namespace coppice::robot::monitoring {

RemoteWatch::~RemoteWatch() { Stop(); }

void RemoteWatch::Ask(RemoteQuestions questions) {
  Stop();
  answers_.reset();
  if (questions.clocks.empty() && questions.hosts.empty()) return;
  stop_requested_ = false;
  thread_ = std::thread([this, questions = std::move(questions)] { Run(questions); });
}

void RemoteWatch::Run(const RemoteQuestions& questions) {
  auto next = std::chrono::steady_clock::now();
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stop_requested_) {
    lock.unlock();
    RemoteAnswers answers{QueryClocks(questions.clocks, questions.deadline),
                          TryToReach(questions.hosts, questions.deadline)};
    lock.lock();
    answers_ = std::move(answers);
    next = std::max(next + questions.period, std::chrono::steady_clock::now());
    stop_.wait_until(lock, next, [this] { return stop_requested_; });
  }
}

void RemoteWatch::Stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_requested_ = true;
  }
  stop_.notify_all();
  if (thread_.joinable()) thread_.join();
}

std::optional<RemoteAnswers> RemoteWatch::Take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(answers_, std::nullopt);
}

}  // namespace coppice::robot::monitoring
