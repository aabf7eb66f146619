#include "bt_core/testing/leaf_harness.h"

#include <algorithm>

#include "bt_core/data/literal.h"

namespace coppice {

// What the children of the node under test do, and what they have been asked to do.
struct LeafHarness::Children {
  struct Child {
    std::vector<Status> results;
    std::size_t next = 0;
  };
  class Leaf;

  std::vector<Child> all;
  std::vector<std::string> events;
};

class LeafHarness::Children::Leaf final : public coppice::Leaf {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kAction;
  static constexpr const char* kDescription = "Does as the test says.";
  Leaf(Children* children, std::uint32_t number) : children_(*children), number_(number) {}

  Status Tick(bool starting) override {
    children_.events.push_back((starting ? "start " : "tick ") + std::to_string(number_));
    Child& child = children_.all[number_];
    if (child.results.empty()) return Status::kSuccess;
    const Status result = child.results[child.next];
    child.next = std::min(child.next + 1, child.results.size() - 1);
    return result;
  }
  void Halt() override { children_.events.push_back("halt " + std::to_string(number_)); }

 private:
  Children& children_;
  const std::uint32_t number_;
};

class LeafHarness::MessageSink : public TickSink {
 public:
  void OnTick(const TickEvents& events) override {
    for (NodeMessage& message : MessagesOf(events.words)) {
      messages.push_back(std::move(message.text));
    }
  }
  std::vector<std::string> messages;
};

namespace {

std::string ChildId(std::uint32_t k) { return "HarnessChild" + std::to_string(k); }

const Manifest& ManifestOf(const Registry& registry, const std::string& id) {
  const Registry::Entry* entry = registry.Find(id);
  if (!entry) {
    throw std::invalid_argument("no node type \"" + id + "\" " + DidYouMean(id, registry.Ids()));
  }
  return entry->manifest;
}

std::string TreeOf(const Manifest& manifest, std::uint32_t children) {
  std::string xml = R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><)" + manifest.id;
  for (const PortDeclaration& port : manifest.ports) {
    xml += " " + port.name + "=\"{" + port.name + "}\"";
  }
  xml += ">";
  for (std::uint32_t k = 0; k < children; ++k) xml += "<" + ChildId(k) + "/>";
  return xml + "</" + manifest.id + "></BehaviorTree></root>";
}

}  // namespace

LeafHarness::LeafHarness(std::shared_ptr<const Registry> given, const std::string& id,
                         std::uint32_t children)
    : clock_(std::make_unique<SimulatedClock>()),
      sink_(std::make_unique<MessageSink>()),
      children_(std::make_unique<Children>()) {
  auto registry = std::make_shared<Registry>(*given);
  children_->all.resize(children);
  for (std::uint32_t k = 0; k < children; ++k) {
    registry->Register<Children::Leaf>(ChildId(k), children_.get(), k);
  }
  const Manifest& manifest = ManifestOf(*registry, id);
  Diagnostics diagnostics;
  auto project = Project::FromText(TreeOf(manifest, children), "harness", diagnostics);
  if (!project) throw std::invalid_argument(diagnostics.ToString());
  const auto program =
      Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
  if (!program) throw std::invalid_argument(diagnostics.ToString());

  executor_ = std::make_unique<Executor>(program, *clock_);
  executor_->AddSink(sink_.get());
  for (const PortDeclaration& port : manifest.ports) {
    if (!port.default_text) continue;
    Value value = GuessValue(*port.default_text);
    if (port.type && !value.Parse(*port.type, *port.default_text)) continue;
    SetValue(port.name, std::move(value));
  }
}

LeafHarness::LeafHarness(LeafHarness&&) noexcept = default;
LeafHarness::~LeafHarness() = default;

bool LeafHarness::WasWritten(const std::string& port) const {
  const SlotIndex slot = executor_->program().layout.Find(kMainScope, port);
  return slot != kNoSlot && executor_->blackboard()[slot].writes > 0;
}

Status LeafHarness::Tick() {
  sink_->messages.clear();
  return executor_->Tick();
}

Status LeafHarness::TickUntilDone(Duration limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  Status status = Tick();
  while (status == Status::kRunning && std::chrono::steady_clock::now() < deadline) {
    if (next_tick() == kNever) {
      executor_->wake_up().WaitFor(deadline - std::chrono::steady_clock::now());
    } else {
      clock_->WaitUntil(next_tick(), executor_->wake_up());
    }
    status = Tick();
  }
  return status;
}

bool LeafHarness::WaitUntilStopped(Duration step) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  executor_->ServeDrains();
  while (executor_->is_draining() && std::chrono::steady_clock::now() < deadline) {
    if (step == Duration::zero()) executor_->wake_up().WaitFor(std::chrono::milliseconds(1));
    clock_->Advance(step);
    executor_->ServeDrains();
  }
  return !executor_->is_draining();
}

void LeafHarness::Halt() {
  sink_->messages.clear();
  executor_->Halt();
}

const std::vector<std::string>& LeafHarness::messages() const { return sink_->messages; }

void LeafHarness::SetChild(std::uint32_t k, std::vector<Status> results) {
  children_->all.at(k) = {std::move(results)};
}

Status LeafHarness::child_status(std::uint32_t k) const {
  if (k >= children_->all.size()) throw std::out_of_range("no such child");
  return executor_->statuses()[k + 1];  // they are leaves, right behind their parent
}

std::vector<std::string> LeafHarness::TakeChildEvents() {
  return std::exchange(children_->events, {});
}

SlotIndex LeafHarness::SlotOf(const std::string& port) const {
  const Layout& layout = executor_->program().layout;
  const SlotIndex slot = layout.Find(kMainScope, port);
  if (slot != kNoSlot) return slot;
  std::vector<std::string> ports;
  for (const SlotDefinition& known : layout.slots) ports.push_back(known.key);
  throw std::invalid_argument("the node has no port \"" + port + "\" " + DidYouMean(port, ports));
}

SlotIndex LeafHarness::SlotOf(const std::string& port, const Type& type) const {
  const Type* const expected = TypeOfPort(port);
  if (expected && expected != &type) {
    throw std::invalid_argument("port \"" + port + "\" is " + expected->name + ", not " +
                                type.name);
  }
  return SlotOf(port);
}

void LeafHarness::SetValue(const std::string& port, Value value) {
  const SlotIndex slot = SlotOf(port, *value.type());
  executor_->inbox()->Post(slot, 0, std::move(value));
}

const Type* LeafHarness::TypeOfPort(const std::string& port) const {
  return executor_->program().layout.slots[SlotOf(port)].type;
}

const Value& LeafHarness::ValueOf(const std::string& port) const {
  return executor_->blackboard()[SlotOf(port)].value;
}

}  // namespace coppice
