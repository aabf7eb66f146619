#include "bt_core/python/tree.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "bt_core/base/diagnostic.h"
#include "bt_core/python/interrupt.h"
#include "bt_core/python/leaf.h"
#include "bt_core/python/values.h"

namespace coppice::python {
namespace {

// All trees, so that none outlives Python.
struct AllTrees {
  std::mutex mutex;
  std::vector<std::weak_ptr<Tree>> trees;
  std::atomic<bool> ended{false};
};

AllTrees& All() {
  static auto* const all = new AllTrees();
  return *all;
}

void RefuseIfEnded() {
  if (All().ended) throw std::runtime_error("the program ends: no tree is ticked any more");
}

}  // namespace

// This thread ticks, without the GIL.
class Tree::Ticking {
 public:
  explicit Ticking(Tree& tree) : tree_(tree) { tree.Enter(); }
  ~Ticking() { tree_.Leave(); }
  Ticking(const Ticking&) = delete;
  Ticking& operator=(const Ticking&) = delete;

 private:
  Tree& tree_;
};

Tree::Tree(std::shared_ptr<const Program> program, std::shared_ptr<Clock> clock,
           ExceptionPolicy on_exception)
    : program_(std::move(program)),
      clock_(std::move(clock)),
      executor_(std::make_unique<Executor>(program_, *clock_, ExecutorOptions{on_exception})) {}

std::shared_ptr<Tree> Tree::Make(std::shared_ptr<const Program> program,
                                 std::shared_ptr<Clock> clock, ExceptionPolicy on_exception) {
  RefuseIfEnded();
  auto tree = std::make_shared<Tree>(std::move(program), std::move(clock), on_exception);
  const std::lock_guard<std::mutex> lock(All().mutex);
  std::vector<std::weak_ptr<Tree>>& all = All().trees;
  all.erase(std::remove_if(all.begin(), all.end(), [](const auto& one) { return one.expired(); }),
            all.end());
  all.push_back(tree);
  return tree;
}

Tree::~Tree() {
  Interruption interruption(nullptr);
  const py::gil_scoped_release release;
  stream_.reset();
  executor_.reset();
}

bool Tree::TryEnter() {
  std::thread::id nobody;
  return ticker_.compare_exchange_strong(nobody, std::this_thread::get_id());
}

void Tree::Enter() {
  RefuseIfEnded();
  if (IsMine()) throw std::runtime_error("a leaf cannot tick, run or halt the tree that it is in");
  if (!TryEnter()) throw std::runtime_error("another thread ticks this tree");
}

// What was asked of this thread meanwhile is done first, so that nobody waits in vain.
void Tree::Leave() {
  executor_->RunCalls();
  const std::lock_guard<std::mutex> lock(mutex_);
  ticker_ = std::thread::id();
  changed_.notify_all();
}

Status Tree::Tick() {
  const Ticking ticking(*this);
  Interruption interruption(nullptr);
  Status result = Status::kIdle;
  std::exception_ptr error;
  {
    const py::gil_scoped_release release;
    try {
      result = executor_->Tick();
    } catch (...) {
      error = std::current_exception();
    }
  }
  RaiseError(error, interruption);
  return result;
}

Status Tree::Run(const RunOptions& options) {
  const Ticking ticking(*this);
  Runner runner(*executor_, options);
  Interruption interruption(&runner);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    runner_ = &runner;
  }
  Status result = Status::kIdle;
  std::exception_ptr error;
  {
    const InterruptStops stops(runner);
    const py::gil_scoped_release release;
    try {
      result = runner.Run();
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    runner_ = nullptr;
  }
  RaiseError(error, interruption);
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return result;
}

// With ExceptionPolicy::kRethrow the exception of Python itself comes out again.
void Tree::RaiseError(const std::exception_ptr& error, const Interruption& interruption) {
  interruption.Raise();
  if (!error) return;
  try {
    try {
      std::rethrow_exception(error);
    } catch (const TickError& tick) {
      std::rethrow_if_nested(tick);
      throw;
    }
  } catch (const PythonError& raised) {
    Interruption of_leaf(nullptr);
    Interruption::Keep(py::reinterpret_borrow<py::object>(raised.exception.get()));
    of_leaf.Raise();
  }
}

void Tree::Halt() {
  const Ticking ticking(*this);
  Interruption interruption(nullptr);
  {
    const py::gil_scoped_release release;
    executor_->Halt();
  }
  interruption.Raise();
}

void Tree::Stop() {
  const py::gil_scoped_release release;
  std::unique_lock<std::mutex> lock(mutex_);
  if (runner_) runner_->RequestStop();
  if (IsMine()) return;
  changed_.wait(lock, [this] { return runner_ == nullptr && ticker_ == std::thread::id(); });
}

bool Tree::is_running() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return runner_ != nullptr;
}

// What a thread asks of the one that ticks. Under the tree's mutex.
struct Tree::Request {
  const std::function<void(Executor&)>* function;  // null: done
  std::exception_ptr error;

  void CarryOut(Executor& executor) {
    if (!function) return;
    try {
      (*function)(executor);
    } catch (...) {
      error = std::current_exception();
    }
    function = nullptr;
  }
};

void Tree::Use(const std::function<void(Executor&)>& function) {
  if (IsMine()) return function(*executor_);
  const auto request = std::make_shared<Request>(Request{&function, nullptr});
  {
    const py::gil_scoped_release release;
    AskWhoTicks(request);
  }
  if (request->error) std::rethrow_exception(request->error);
}

void Tree::UseBetweenTicks(const std::function<void(Executor&)>& function) {
  if (IsMine()) throw std::runtime_error("this cannot be done within a tick of the tree");
  Use(function);
}

void Tree::AskWhoTicks(const std::shared_ptr<Request>& request) {
  const auto carry_out = [this, request] {
    const std::lock_guard<std::mutex> lock(mutex_);
    request->CarryOut(*executor_);
    changed_.notify_all();
  };
  while (!TryEnter()) {
    executor_->inbox()->PostCall(carry_out);
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return !request->function || ticker_ == std::thread::id(); });
    if (!request->function) return;
  }
  carry_out();
  Leave();
}

std::vector<Status> Tree::Statuses() {
  std::vector<Status> statuses;
  Use([&](Executor& executor) { statuses = executor.statuses(); });
  return statuses;
}

Status Tree::RootStatus() {
  Status status = Status::kIdle;
  Use([&](Executor& executor) { status = executor.StatusOf(NodeIndex(0)); });
  return status;
}

std::uint64_t Tree::Ticks() {
  std::uint64_t ticks = 0;
  Use([&](Executor& executor) { ticks = executor.ticks(); });
  return ticks;
}

double Tree::NextTick() {
  Time next{};
  Use([&](Executor& executor) { next = executor.next_tick(); });
  return next == kNever ? std::numeric_limits<double>::infinity() : ToSeconds(next);
}

std::vector<std::string> Tree::Keys() const {
  std::vector<std::string> keys;
  for (const SlotDefinition& slot : program_->layout.slots) {
    if (slot.scope == kMainScope && !slot.key.empty()) keys.push_back(slot.key);
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

SlotIndex Tree::Find(const std::string& key) const {
  const SlotIndex slot = program_->layout.Find(kMainScope, key);
  if (slot != kNoSlot) return slot;
  const std::string hint = DidYouMean(key, Keys());
  throw py::key_error("the tree uses no key \"" + key + "\"" +
                      (hint.empty() ? "" : " (" + hint + ")"));
}

py::object Tree::Get(SlotIndex slot) {
  Value value;
  Use([&](Executor& executor) { value = executor.blackboard()[slot].value; });
  return ToPython(value);
}

bool Tree::IsSet(SlotIndex slot) {
  bool is_set = false;
  Use([&](Executor& executor) { is_set = executor.blackboard()[slot].value.has_value(); });
  return is_set;
}

void Tree::Set(const std::string& key, py::handle value) {
  const SlotIndex slot = Find(key);
  const Type* const type = program_->layout.slots[slot].type;
  try {
    executor_->inbox()->Post(slot, 0, FromPython(type, value));
  } catch (const py::type_error& error) {
    throw py::type_error("key \"" + key + "\": " + error.what());
  } catch (const py::value_error& error) {
    throw py::value_error("key \"" + key + "\": " + error.what());
  }
  if (IsMine() || !TryEnter()) return;
  const Time next = executor_->next_tick();
  {
    const py::gil_scoped_release release;
    executor_->ServeDrains();  // takes what lies in the inbox
  }
  executor_->WakeAt(next);
  Leave();
}

EventStream& Tree::stream() {
  if (!stream_) stream_.emplace(*executor_);
  return *stream_;
}

void Tree::End(std::chrono::steady_clock::time_point deadline) {
  {
    std::unique_lock<std::mutex> lock(mutex_);
    if (runner_) runner_->RequestStop();
    executor_->inbox()->set_ending(true);  // also if it stands at a breakpoint
    changed_.wait_until(lock, deadline, [this] { return ticker_ == std::thread::id(); });
  }
  if (!TryEnter()) return;
  executor_->Halt();
  Leave();
}

void EndAllTrees() {
  std::vector<std::shared_ptr<Tree>> trees;
  {
    const std::lock_guard<std::mutex> lock(All().mutex);
    All().ended = true;
    for (const std::weak_ptr<Tree>& tree : All().trees) trees.push_back(tree.lock());
  }
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  for (const std::shared_ptr<Tree>& tree : trees) {
    const py::gil_scoped_release release;
    if (tree) tree->End(deadline);
  }
}

}  // namespace coppice::python
