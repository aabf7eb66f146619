// An action written as one function that reads from top to bottom, as a C++20 coroutine. This is
// the only header of the project that needs C++20; what does not include it stays C++17.
//
//   class Fetch : public CoroutineAction {
//    public:
//     static constexpr const char* kDescription = "Fetches a cup.";
//     Input<double> battery{this, "battery", "charge, 0 to 1"};
//     Mailbox<Arrival> arrived{this, "arrived"};
//
//    private:
//     Steps Run() override {
//       const Light light(lamp_);                             // off again at the end or halt
//       co_await Sleep(std::chrono::seconds(1));
//       co_await Until([this] { return *battery > 0.2; });
//       navigator_.NavigateTo(kKitchen, arrived.NewSender());
//       const Arrival arrival = co_await Receive(arrived);
//       co_return arrival.reached ? Status::kSuccess : Status::kFailure;
//     }
//   };
//
// Run begins with the activation; each co_await that has to wait makes the tick RUNNING, and Run
// goes on in the first tick in which the wait is over. Everything runs on the ticking thread, so
// between two co_await the world stands still. Halting destroys what Run holds, in reverse order,
// as if it had returned. An exception leaves Run and fails the node with its text.
//
// A tick allocates nothing. The memory of Run's variables is allocated in the first activation
// and kept. Only Run itself is such a coroutine: what it calls are plain functions.
#ifndef COPPICE_BT_CORE_NODES_COROUTINE_ACTION_H_
#define COPPICE_BT_CORE_NODES_COROUTINE_ACTION_H_

#if !defined(__cpp_impl_coroutine)
#error "coroutine_action.h needs C++20: set CXX_STANDARD 20 for the targets that include it"
#endif

#include <chrono>
#include <coroutine>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#include "bt_core/nodes/leaf.h"

namespace coppice {

class CoroutineAction : public Action {
 private:
  class Wait;

 public:
  /// What Run returns. The caller cannot do anything with it.
  class [[nodiscard]] Steps {
   public:
    struct promise_type;
    Steps(Steps&& other) noexcept : frame_(std::exchange(other.frame_, nullptr)) {}
    Steps& operator=(Steps&& other) noexcept {
      std::swap(frame_, other.frame_);
      return *this;
    }
    ~Steps() {
      if (frame_) frame_.destroy();
    }

   private:
    friend class CoroutineAction;
    Steps() = default;
    explicit Steps(std::coroutine_handle<promise_type> frame) : frame_(frame) {}
    std::coroutine_handle<promise_type> frame_;
  };

  Status OnStart() final;
  Status OnRunning() final;
  void OnHalted() final { steps_ = Steps(); }

 protected:
  /// The whole action. Returns SUCCESS, FAILURE or SKIPPED by co_return.
  virtual Steps Run() = 0;

  /// co_await Sleep(d): goes on so much time of the tree's clock later.
  auto Sleep(Duration duration);

  /// co_await Until(f): goes on in the first tick in which f() is true; asked once in each tick,
  /// the first time at once. A tick comes when something arrives for the tree, and at its period.
  template <class Predicate>
  auto Until(Predicate predicate);

  /// co_await Receive(m): gives the next message for the mailbox. NewSender() comes first.
  template <class T>
  auto Receive(Mailbox<T>& mailbox);

  /// co_await Yield(): goes on in the next tick, which is asked for at once.
  auto Yield();

  // co_await future: gives what a std::future gives, its exceptions included. It is looked at in
  // each tick and does not wake the tree; a mailbox does. A halt destroys a future that was moved
  // into the co_await: one of std::async waits there until its thread is done.

 private:
  // Lies in the frame of Run while it waits.
  class Wait {
   public:
    virtual bool IsOver() = 0;
    bool await_ready() { return IsOver(); }
    template <class Promise>
    void await_suspend(std::coroutine_handle<Promise> frame) {
      frame.promise().wait = this;
    }

   protected:
    ~Wait() = default;
  };
  class SleepWait;
  class YieldWait;
  template <class Predicate>
  class UntilWait;
  template <class T>
  class ReceiveWait;
  template <class Future>
  class FutureWait;

  struct Delete {
    void operator()(std::byte* memory) const { ::operator delete(memory); }
  };

  void* Memory(std::size_t size);
  Status Resume();

  // Before the frame, which lies in it.
  std::unique_ptr<std::byte, Delete> memory_;
  std::size_t memory_size_ = 0;
  Steps steps_;
};

struct CoroutineAction::Steps::promise_type {
  Status result = Status::kFailure;
  Wait* wait = nullptr;

  // Run is a member function, so the frame can lie in memory of the action.
  template <class Action>
  static void* operator new(std::size_t size, Action& action) {
    return static_cast<CoroutineAction&>(action).Memory(size);
  }
  static void operator delete(void*) {}

  Steps get_return_object() {
    return Steps(std::coroutine_handle<promise_type>::from_promise(*this));
  }
  std::suspend_always initial_suspend() noexcept { return {}; }
  std::suspend_always final_suspend() noexcept { return {}; }
  void return_value(Status status) { result = status; }
  void unhandled_exception() { throw; }  // to who resumed: the engine's policy decides

  template <class Awaited>
  decltype(auto) await_transform(Awaited&& awaited) {
    if constexpr (std::is_base_of_v<Wait, std::remove_cvref_t<Awaited>>) {
      return std::forward<Awaited>(awaited);
    } else {
      return FutureWait<Awaited>(std::forward<Awaited>(awaited));
    }
  }
};

class CoroutineAction::SleepWait final : public Wait {
 public:
  SleepWait(CoroutineAction& action, Time end) : action_(action), end_(end) {}
  bool IsOver() override {
    if (action_.now() >= end_) return true;
    action_.WakeAt(end_);
    return false;
  }
  void await_resume() const {}

 private:
  CoroutineAction& action_;
  const Time end_;
};

class CoroutineAction::YieldWait final : public Wait {
 public:
  explicit YieldWait(CoroutineAction& action) : action_(action) {}
  bool IsOver() override {
    if (std::exchange(yielded_, true)) return true;
    action_.WakeAt(action_.now());
    return false;
  }
  void await_resume() const {}

 private:
  CoroutineAction& action_;
  bool yielded_ = false;
};

template <class Predicate>
class CoroutineAction::UntilWait final : public Wait {
 public:
  explicit UntilWait(Predicate predicate) : predicate_(std::move(predicate)) {}
  bool IsOver() override { return predicate_(); }
  void await_resume() const {}

 private:
  Predicate predicate_;
};

template <class T>
class CoroutineAction::ReceiveWait final : public Wait {
 public:
  explicit ReceiveWait(Mailbox<T>& mailbox) : mailbox_(mailbox) {}
  bool IsOver() override { return (message_ = mailbox_.Take()) != nullptr; }
  T await_resume() const { return *message_; }

 private:
  Mailbox<T>& mailbox_;
  const T* message_ = nullptr;
};

// Future: std::future<T>& or std::future<T>, which is then kept here.
template <class Future>
class CoroutineAction::FutureWait final : public Wait {
 public:
  explicit FutureWait(Future&& future) : future_(std::forward<Future>(future)) {}
  bool IsOver() override {
    const auto state = future_.wait_for(std::chrono::seconds(0));
    return state == decltype(state)::ready;
  }
  decltype(auto) await_resume() { return future_.get(); }

 private:
  Future future_;
};

inline auto CoroutineAction::Sleep(Duration duration) { return SleepWait(*this, now() + duration); }

template <class Predicate>
auto CoroutineAction::Until(Predicate predicate) {
  return UntilWait<Predicate>(std::move(predicate));
}

template <class T>
auto CoroutineAction::Receive(Mailbox<T>& mailbox) {
  return ReceiveWait<T>(mailbox);
}

inline auto CoroutineAction::Yield() { return YieldWait(*this); }

inline void* CoroutineAction::Memory(std::size_t size) {
  if (size > memory_size_) {
    memory_.reset(static_cast<std::byte*>(::operator new(size)));
    memory_size_ = size;
  }
  return memory_.get();
}

inline Status CoroutineAction::OnStart() {
  steps_ = Run();
  return Resume();
}

inline Status CoroutineAction::OnRunning() {
  try {
    if (!steps_.frame_.promise().wait->IsOver()) return Status::kRunning;
  } catch (...) {
    steps_ = Steps();
    throw;
  }
  return Resume();
}

inline Status CoroutineAction::Resume() {
  Steps steps = std::move(steps_);  // ends here, unless it goes on
  steps.frame_.resume();
  if (steps.frame_.done()) return steps.frame_.promise().result;
  steps_ = std::move(steps);
  return Status::kRunning;
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_COROUTINE_ACTION_H_
