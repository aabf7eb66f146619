// The coroutine of a CoroActionNode: a stack of its own (getcontext(3)).
#include <sys/mman.h>
#include <ucontext.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>

#include "behaviortree_cpp/action_node.h"

namespace BT {

class CoroActionNode::Coroutine {
 public:
  explicit Coroutine(CoroActionNode& node) : node_(node) {
    page_ = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    stack_ = mmap(nullptr, kStackSize + page_, PROT_READ | PROT_WRITE,
                  MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (stack_ == MAP_FAILED) throw std::bad_alloc();
    mprotect(stack_, page_, PROT_NONE);  // a stack that grows too far faults
  }
  ~Coroutine() {
    Stop();
    munmap(stack_, kStackSize + page_);
  }
  Coroutine(const Coroutine&) = delete;
  Coroutine& operator=(const Coroutine&) = delete;

  /// Runs it until it yields or ends.
  NodeStatus Resume() {
    if (!runs_) Begin();
    swapcontext(&outside_, &inside_);
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    return runs_ ? NodeStatus::RUNNING : result_;
  }

  void Yield() {
    swapcontext(&inside_, &outside_);
    if (stops_) throw Unwind();
  }

  /// Unwinds its stack.
  void Stop() {
    if (!runs_) return;
    stops_ = true;
    swapcontext(&outside_, &inside_);
    stops_ = false;
    error_ = nullptr;
  }

 private:
  struct Unwind {};
  static constexpr std::size_t kStackSize = std::size_t{256} << 10;

  void Begin() {
    getcontext(&inside_);
    inside_.uc_stack.ss_sp = static_cast<char*>(stack_) + page_;
    inside_.uc_stack.ss_size = kStackSize;
    inside_.uc_link = &outside_;
    const auto address = reinterpret_cast<std::uintptr_t>(this);
    makecontext(&inside_, reinterpret_cast<void (*)()>(&Coroutine::Main), 2,
                static_cast<unsigned>(address >> 32), static_cast<unsigned>(address));
    runs_ = true;
  }

  static void Main(unsigned high, unsigned low) {
    const auto address = (static_cast<std::uintptr_t>(high) << 32) | low;
    auto& self = *reinterpret_cast<Coroutine*>(address);
    try {
      self.result_ = self.node_.tick();
    } catch (const Unwind&) {
    } catch (...) {
      self.error_ = std::current_exception();
    }
    self.runs_ = false;
  }

  CoroActionNode& node_;
  void* stack_;
  std::size_t page_;
  ucontext_t inside_{};
  ucontext_t outside_{};
  NodeStatus result_ = NodeStatus::FAILURE;
  std::exception_ptr error_;
  bool runs_ = false;
  bool stops_ = false;
};

CoroActionNode::CoroActionNode(const std::string& name, const NodeConfig& config)
    : ActionNodeBase(name, config), coroutine_(std::make_unique<Coroutine>(*this)) {}

CoroActionNode::~CoroActionNode() = default;

void CoroActionNode::setStatusRunningAndYield() {
  setStatus(NodeStatus::RUNNING);
  coroutine_->Yield();
}

NodeStatus CoroActionNode::executeTick() {
  if (!IsEngineCalling()) return TickThroughEngine();
  return coroutine_->Resume();
}

void CoroActionNode::halt() {
  coroutine_->Stop();
  resetStatus();
}

}  // namespace BT
