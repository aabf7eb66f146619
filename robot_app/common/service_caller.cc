#include "robot_app/common/service_caller.h"

#include <pthread.h>

#include <utility>

namespace coppice::robot {

ServiceCaller::ServiceCaller() : thread_([this] { Work(); }) {}

ServiceCaller::~ServiceCaller() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

bool ServiceCaller::Add(Call call) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (calls_.size() >= kMostWaiting) return false;
  calls_.push_back(std::move(call));
  changed_.notify_one();
  return true;
}

void ServiceCaller::RunFinished() {
  std::deque<Finish> finished;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    finished.swap(finished_);
  }
  for (const Finish& finish : finished) finish();
}

void ServiceCaller::Work() {
  pthread_setname_np(pthread_self(), "service_calls");
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stop_ || !calls_.empty(); });
    if (stop_) return;
    const Call call = std::move(calls_.front());
    calls_.pop_front();
    lock.unlock();
    Finish finish = call();
    lock.lock();
    finished_.push_back(std::move(finish));
  }
}

}  // namespace coppice::robot
