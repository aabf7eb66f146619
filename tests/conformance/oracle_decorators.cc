// The decorators of the oracle.
#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <optional>

#include "tests/conformance/oracle.h"

namespace coppice::conformance {
namespace {

using std::chrono::milliseconds;

constexpr Status kSuccess = Status::kSuccess;
constexpr Status kFailure = Status::kFailure;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSkipped = Status::kSkipped;

class Mapped : public OracleNode {
 public:
  Mapped(World& world, const Shape& shape, Status on_success, Status on_failure)
      : OracleNode(world, shape), results_{{kSuccess, on_success}, {kFailure, on_failure}} {}

 private:
  Status Run() override {
    const Status result = PassOn(child().Tick());
    return results_.count(result) ? results_.at(result) : result;
  }

  const std::map<Status, Status> results_;
};

// Repeat goes on after SUCCESS, RetryUntilSuccessful after FAILURE.
class Loop : public OracleNode {
 public:
  Loop(World& world, const Shape& shape, Status again, const std::string& port)
      : OracleNode(world, shape), again_(again), limit_(shape.Number(port, 0)) {}

 private:
  bool more() const { return limit_ == -1 || done_ < limit_; }

  Status Run() override {
    while (more()) {
      const bool took_longer = child().status() == kRunning;
      const Status result = child().Tick();
      if (result == kRunning) return result;
      ResetChildren();
      if (result != again_) return result;
      ++done_;
      if (!took_longer && more()) {
        world_.tick_again = true;
        return kRunning;
      }
    }
    return again_;
  }
  void Forget() override { done_ = 0; }
  bool RemembersWhenSkipped() const override { return done_ > 0; }

  const Status again_;
  const int limit_;
  int done_ = 0;
};

class KeepRunning : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override { return PassOn(child().Tick()) == kFailure ? kFailure : kRunning; }
};

// What decorators have in common that pass the result of their child on.
class Passing : public OracleNode {
 protected:
  using OracleNode::OracleNode;
  Status TickChild() { return PassOn(child().Tick()); }
  bool child_runs() { return child().status() == kRunning; }

  // Before a time nothing is ticked; who waits in RUNNING wants to be woken.
  Status HoldBack(Time until, Status result) {
    if (result == kRunning) world_.WakeAt(until);
    return result;
  }
};

class Timer : public Passing {
 protected:
  using Passing::Passing;
  // True when the time since the first call of this activation is over; else asks for a tick then.
  bool Expired(int msec) {
    if (!expiry_) expiry_ = world_.now + milliseconds(msec);
    if (world_.now >= *expiry_) return true;
    world_.WakeAt(*expiry_);
    return false;
  }
  void Forget() override { expiry_.reset(); }

 private:
  std::optional<Time> expiry_;
};

class Timeout : public Timer {
  using Timer::Timer;
  Status Run() override {
    const int msec = shape_.Number("msec", 0);
    if (msec > 0 && Expired(msec)) return End(kFailure);
    return TickChild();
  }
};

class Delay : public Timer {
  using Timer::Timer;
  bool RemembersWhenSkipped() const override { return true; }
  Status Run() override { return Expired(shape_.Number("delay_msec", 0)) ? TickChild() : kRunning; }
};

class RunOnce : public Passing {
  using Passing::Passing;
  Status Run() override {
    if (done_) return shape_.Text("then_skip", "true") == "true" ? kSkipped : *done_;
    const Status result = TickChild();
    if (IsCompleted(result)) done_ = result;
    return result;
  }
  std::optional<Status> done_;
};

class SingleTrigger : public Passing {
  using Passing::Passing;
  Status Run() override {
    const bool fired = fired_ && last_tick_ + 1 >= world_.tick;
    last_tick_ = world_.tick;
    if (fired) return kFailure;
    const Status result = TickChild();
    fired_ = IsCompleted(result);
    return result;
  }
  bool fired_ = false;
  std::uint64_t last_tick_ = 0;
};

class RateController : public Passing {
  using Passing::Passing;
  Status Run() override {
    if (!was_running() && last_tick_ + 1 < world_.tick) due_.reset();
    last_tick_ = world_.tick;
    if (due_ && world_.now < *due_ && !child_runs()) return HoldBack(*due_, kRunning);
    const Status result = TickChild();
    if (result == kSkipped) due_.reset();
    if (IsCompleted(result)) {
      const std::chrono::duration<double> period(1.0 / shape_.Number("hz", 10));
      due_ = world_.now + std::chrono::duration_cast<Duration>(period);
    }
    return result;
  }
  void OnHalt() override { due_.reset(); }

  std::optional<Time> due_;
  std::uint64_t last_tick_ = 0;
};

class Cooldown : public Passing {
  using Passing::Passing;
  Status Run() override {
    if (world_.now < until_ && !child_runs()) {
      return HoldBack(until_, shape_.Result("if_cooling", kFailure));
    }
    const Status result = TickChild();
    if (IsCompleted(result)) until_ = world_.now + milliseconds(shape_.Number("msec", 0));
    return result;
  }
  Time until_{};
};

class CircuitBreaker : public Passing {
  using Passing::Passing;
  enum class State { kClosed, kOpen, kHalfOpen };

  Status Run() override {
    if (state_ == State::kOpen && world_.now >= until_) state_ = State::kHalfOpen;
    if (state_ == State::kOpen) return HoldBack(until_, shape_.Result("if_open", kFailure));
    const Status result = TickChild();
    if (result == kSuccess) state_ = State::kClosed;
    if (result == kFailure) {
      failures_.push_back(world_.now);
      const Time oldest = world_.now - milliseconds(shape_.Number("period_msec", 60000));
      while (failures_.front() < oldest) failures_.pop_front();
      const auto allowed = static_cast<std::size_t>(shape_.Number("max_failures", 3));
      if (state_ == State::kHalfOpen || failures_.size() >= allowed) Open();
    }
    return result;
  }
  void Open() {
    state_ = State::kOpen;
    until_ = world_.now + milliseconds(shape_.Number("open_msec", 30000));
    failures_.clear();
  }

  State state_ = State::kClosed;
  Time until_{};
  std::deque<Time> failures_;
};

// Consecutive counts ticks, Debounce time, until a new answer of the child is believed.
class Filter : public Passing {
 public:
  Filter(World& world, const Shape& shape)
      : Passing(world, shape), answer_(shape.Result("initial", kFailure)) {}

 private:
  Status Run() override {
    const Status result = TickChild();
    if (!IsCompleted(result)) return result;
    if (result == answer_) {
      times_.clear();
      return answer_;
    }
    times_.push_back(world_.now);
    if (!Believes(result)) return answer_;
    times_.clear();
    return answer_ = result;
  }
  bool Believes(Status result) {
    const bool success = result == kSuccess;
    if (shape_.type == "Consecutive") {
      const int needed = shape_.Number(success ? "successes" : "failures", 2);
      return static_cast<int>(times_.size()) >= needed;
    }
    const milliseconds needed(shape_.Number(success ? "success_msec" : "failure_msec", 0));
    const Time at = times_.front() + needed;
    if (world_.now >= at) return true;
    world_.WakeAt(at);
    return false;
  }

  Status answer_;
  std::vector<Time> times_;  // of the contradictions in a row
};

}  // namespace

std::unique_ptr<OracleNode> MakeDecorator(const Shape& shape, World& world) {
  const std::string& type = shape.type;
  const auto mapped = [&](Status on_success, Status on_failure) {
    return std::make_unique<Mapped>(world, shape, on_success, on_failure);
  };
  if (type == "Inverter") return mapped(kFailure, kSuccess);
  if (type == "ForceSuccess") return mapped(kSuccess, kSuccess);
  if (type == "ForceFailure") return mapped(kFailure, kFailure);
  if (type == "SubTree") return mapped(kSuccess, kFailure);
  if (type == "Repeat") return std::make_unique<Loop>(world, shape, kSuccess, "num_cycles");
  if (type == "RetryUntilSuccessful") {
    return std::make_unique<Loop>(world, shape, kFailure, "num_attempts");
  }
  if (type == "KeepRunningUntilFailure") return std::make_unique<KeepRunning>(world, shape);
  if (type == "Timeout") return std::make_unique<Timeout>(world, shape);
  if (type == "Delay") return std::make_unique<Delay>(world, shape);
  if (type == "RunOnce") return std::make_unique<RunOnce>(world, shape);
  if (type == "SingleTrigger") return std::make_unique<SingleTrigger>(world, shape);
  if (type == "RateController") return std::make_unique<RateController>(world, shape);
  if (type == "Cooldown") return std::make_unique<Cooldown>(world, shape);
  if (type == "CircuitBreaker") return std::make_unique<CircuitBreaker>(world, shape);
  if (type == "Consecutive" || type == "Debounce") return std::make_unique<Filter>(world, shape);
  return nullptr;
}

}  // namespace coppice::conformance
