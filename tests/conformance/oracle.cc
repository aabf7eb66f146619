#include "tests/conformance/oracle.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

namespace coppice::conformance {

Status OracleNode::Tick() {
  const Status result = Run();
  if (result != Status::kRunning) Forget();
  status_ = result;
  return result;
}

void OracleNode::Halt() {
  if (status_ == Status::kRunning) {
    OnHalt();
    ResetChildren();
    Forget();
  }
  status_ = Status::kIdle;
}

void OracleNode::ResetChildren() {
  for (const auto& child : children) child->Halt();
}

Status OracleNode::End(Status result) {
  ResetChildren();
  return result;
}

namespace {

class Leaf : public OracleNode {
 public:
  Leaf(World& world, int number) : OracleNode(world), number_(number) {}

 private:
  Status Run() override { return world_.tick_leaf(number_, status() != Status::kRunning); }
  void OnHalt() override { world_.halt_leaf(number_); }

  int number_;
};

class Constant : public OracleNode {
 public:
  Constant(World& world, Status result) : OracleNode(world), result_(result) {}

 private:
  Status Run() override { return result_; }

  Status result_;
};

// Sequence: ends at the first FAILURE. Fallback: ends at the first SUCCESS.
class WithMemory : public OracleNode {
 public:
  WithMemory(World& world, Status ends_at) : OracleNode(world), ends_at_(ends_at) {}

 private:
  Status Run() override {
    while (index_ < children.size()) {
      const Status result = children[index_]->Tick();
      if (result == Status::kRunning) return result;
      if (result == ends_at_) return End(result);
      if (result == Status::kSkipped) ++skipped_;
      ++index_;
    }
    if (skipped_ == children.size()) return End(Status::kSkipped);
    return End(ends_at_ == Status::kFailure ? Status::kSuccess : Status::kFailure);
  }
  void Forget() override { index_ = skipped_ = 0; }

  Status ends_at_;
  std::size_t index_ = 0;
  std::size_t skipped_ = 0;
};

class Reactive : public OracleNode {
 public:
  Reactive(World& world, Status ends_at) : OracleNode(world), ends_at_(ends_at) {}

 private:
  Status Run() override {
    std::size_t skipped = 0;
    for (std::size_t i = 0; i < children.size(); ++i) {
      const Status result = children[i]->Tick();
      if (result == Status::kRunning) {
        for (std::size_t behind = i + 1; behind < children.size(); ++behind) {
          children[behind]->Halt();
        }
        return result;
      }
      if (result == ends_at_) return End(result);
      if (result == Status::kSkipped) ++skipped;
    }
    if (skipped == children.size()) return End(Status::kSkipped);
    return End(ends_at_ == Status::kFailure ? Status::kSuccess : Status::kFailure);
  }

  Status ends_at_;
};

class Parallel : public OracleNode {
 public:
  Parallel(World& world, int success_count, int failure_count)
      : OracleNode(world), success_count_(success_count), failure_count_(failure_count) {}

 private:
  // The rule for a Parallel of `count` children none of which is skipped.
  std::optional<Status> Decide(int count, int successes, int failures) const {
    const auto all_but = [count](int port) { return std::max(0, count + 1 + port); };
    const int needed =
        success_count_ < 0 ? all_but(success_count_) : std::min(success_count_, count);
    const int allowed =
        failure_count_ < 0 ? all_but(failure_count_) : std::min(failure_count_, count);
    if (successes >= needed) return Status::kSuccess;
    if (failures >= allowed) return Status::kFailure;
    if (count - failures < needed) return Status::kFailure;
    return std::nullopt;
  }

  Status Run() override {
    const int all = static_cast<int>(children.size());
    if (success_count_ > all || failure_count_ > all) return End(Status::kFailure);
    std::vector<Status> results;
    const auto count = [&results](Status status) {
      return static_cast<int>(std::count(results.begin(), results.end(), status));
    };
    for (const auto& child : children) {
      results.push_back(IsCompleted(child->status()) ? child->status() : child->Tick());
      const int skipped = count(Status::kSkipped);
      if (skipped == static_cast<int>(results.size())) continue;
      const auto decided = Decide(all - skipped, count(Status::kSuccess), count(Status::kFailure));
      if (decided) return End(*decided);
    }
    if (count(Status::kSkipped) == all) return End(Status::kSkipped);
    return Status::kRunning;
  }

  int success_count_;
  int failure_count_;
};

class Mapped : public OracleNode {
 public:
  Mapped(World& world, Status on_success, Status on_failure)
      : OracleNode(world), on_success_(on_success), on_failure_(on_failure) {}

 private:
  Status Run() override {
    const Status result = child().Tick();
    if (result == Status::kRunning) return result;
    if (result == Status::kSuccess) return End(on_success_);
    if (result == Status::kFailure) return End(on_failure_);
    return End(Status::kSkipped);
  }

  Status on_success_;
  Status on_failure_;
};

// Repeat goes on after SUCCESS, RetryUntilSuccessful after FAILURE.
class Loop : public OracleNode {
 public:
  Loop(World& world, Status again, int limit) : OracleNode(world), again_(again), limit_(limit) {}

 private:
  bool more() const { return limit_ < 0 || done_ < limit_; }

  Status Run() override {
    while (more()) {
      const bool was_running = child().status() == Status::kRunning;
      const Status result = child().Tick();
      if (result == Status::kRunning) return result;
      ResetChildren();
      if (result != again_) return result;
      ++done_;
      if (!was_running && more()) {
        world_.tick_again = true;
        return Status::kRunning;
      }
    }
    return again_;
  }
  void Forget() override { done_ = 0; }

  Status again_;
  int limit_;
  int done_ = 0;
};

class Timer : public OracleNode {
 public:
  Timer(World& world, int msec) : OracleNode(world), msec_(msec) {}

 protected:
  // True when the time since the first call of this activation is over; else asks for a tick then.
  bool Expired() {
    if (!expiry_) expiry_ = world_.now + std::chrono::milliseconds(msec_);
    if (world_.now >= *expiry_) return true;
    world_.wake_at = std::min(world_.wake_at, *expiry_);
    return false;
  }
  void Forget() override { expiry_.reset(); }
  Status TickChild() {
    const Status result = child().Tick();
    return result == Status::kRunning ? result : End(result);
  }
  int msec_;

 private:
  std::optional<Time> expiry_;
};

class Timeout : public Timer {
  using Timer::Timer;
  Status Run() override {
    if (msec_ > 0 && Expired()) return End(Status::kFailure);
    return TickChild();
  }
};

class Delay : public Timer {
  using Timer::Timer;
  Status Run() override { return Expired() ? TickChild() : Status::kRunning; }
};

std::unique_ptr<OracleNode> MakeNode(const Shape& shape, World& world, int& next_leaf) {
  const std::string& type = shape.type;
  const auto port = [&shape](std::size_t k) { return shape.ports.at(k); };
  constexpr Status kSuccess = Status::kSuccess;
  constexpr Status kFailure = Status::kFailure;
  if (type == "Leaf") return std::make_unique<Leaf>(world, next_leaf++);
  if (type == "AlwaysSuccess") return std::make_unique<Constant>(world, kSuccess);
  if (type == "AlwaysFailure") return std::make_unique<Constant>(world, kFailure);
  if (type == "Sequence") return std::make_unique<WithMemory>(world, kFailure);
  if (type == "Fallback") return std::make_unique<WithMemory>(world, kSuccess);
  if (type == "ReactiveSequence") return std::make_unique<Reactive>(world, kFailure);
  if (type == "ReactiveFallback") return std::make_unique<Reactive>(world, kSuccess);
  if (type == "Parallel") return std::make_unique<Parallel>(world, port(0), port(1));
  if (type == "Inverter") return std::make_unique<Mapped>(world, kFailure, kSuccess);
  if (type == "ForceSuccess") return std::make_unique<Mapped>(world, kSuccess, kSuccess);
  if (type == "ForceFailure") return std::make_unique<Mapped>(world, kFailure, kFailure);
  if (type == "SubTree") return std::make_unique<Mapped>(world, kSuccess, kFailure);
  if (type == "Repeat") return std::make_unique<Loop>(world, kSuccess, port(0));
  if (type == "RetryUntilSuccessful") return std::make_unique<Loop>(world, kFailure, port(0));
  if (type == "Timeout") return std::make_unique<Timeout>(world, port(0));
  if (type == "Delay") return std::make_unique<Delay>(world, port(0));
  throw std::logic_error("no such node: " + type);
}

std::unique_ptr<OracleNode> Make(const Shape& shape, World& world, int& next_leaf) {
  std::unique_ptr<OracleNode> node = MakeNode(shape, world, next_leaf);
  for (const Shape& child : shape.children) {
    node->children.push_back(Make(child, world, next_leaf));
  }
  return node;
}

}  // namespace

std::unique_ptr<OracleNode> MakeOracle(const Shape& shape, World& world) {
  int next_leaf = 0;
  return Make(shape, world, next_leaf);
}

}  // namespace coppice::conformance
