#include "bt_core/nodes/threaded_action.h"

#include <pthread.h>

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace coppice {

// One thread that sleeps until it is asked to work, and ends with the object.
class ThreadedAction::Worker {
 public:
  explicit Worker(ThreadedAction& action) : action_(action), thread_([this] { Loop(); }) {
    pthread_setname_np(thread_.native_handle(), action.thread_name());
  }
  ~Worker() {
    Tell(&Worker::end_);
    thread_.join();
  }
  void Ask() { Tell(&Worker::asked_); }

 private:
  void Tell(bool Worker::*what) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      this->*what = true;
    }
    told_.notify_one();
  }

  void Loop() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      told_.wait(lock, [this] { return asked_ || end_; });
      if (end_) return;
      asked_ = false;
      lock.unlock();
      action_.WorkOnce();
      lock.lock();
    }
  }

  ThreadedAction& action_;
  std::mutex mutex_;
  std::condition_variable told_;
  bool asked_ = false;
  bool end_ = false;
  std::thread thread_;
};

ThreadedAction::ThreadedAction() = default;
ThreadedAction::~ThreadedAction() { BeforeDestruction(); }

void ThreadedAction::BeforeDestruction() {
  stop_.RequestStop();
  worker_.reset();
}

Status ThreadedAction::OnStart() {
  begun_ = false;
  return is_working() ? Status::kRunning : Begin();  // the end of the old work wakes the tree
}

Status ThreadedAction::OnRunning() {
  if (!begun_) return is_working() ? Status::kRunning : Begin();
  const WorkResult* result = result_.Take();
  if (!result) return Status::kRunning;
  if (!result->message.empty()) return Fail(result->message);
  Finish();
  return result->status;
}

Status ThreadedAction::Begin() {
  Prepare();
  if (!worker_) worker_ = std::make_unique<Worker>(*this);
  stop_.Reset();
  sender_ = result_.NewSender();
  working_.store(true, std::memory_order_relaxed);
  begun_ = true;
  worker_->Ask();
  return Status::kRunning;
}

void ThreadedAction::OnHalted() {
  stop_.RequestStop();
  if (is_working()) DrainFor(stop_limit());
}

void ThreadedAction::WorkOnce() {
  WorkResult result;
  try {
    result.status = Work(stop_);
    if (result.status == Status::kRunning || result.status == Status::kIdle) {
      result = {Status::kFailure, std::string("Work returned ") + ToString(result.status)};
    }
  } catch (const std::exception& error) {
    result.message = error.what();
    if (result.message.empty()) result.message = "Work threw an exception without text";
  } catch (...) {
    result.message = "Work threw something that is not a std::exception";
  }
  const Sender<WorkResult> sender = sender_;
  working_.store(false, std::memory_order_release);  // from here on a new activation may begin
  sender.Send(result);
}

}  // namespace coppice
