#include "bt_core/testing/leaf_harness.h"

namespace coppice {
namespace {

std::shared_ptr<const Program> ProgramOf(std::shared_ptr<const Registry> registry) {
  std::string xml = R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Leaf)";
  for (const PortDeclaration& port : registry->Find("Leaf")->manifest.ports) {
    // A port with a default keeps it until the test sets the key.
    xml += " " + port.name + "=\"{" + port.name + "}\"";
  }
  xml += "/></BehaviorTree></root>";
  Diagnostics diagnostics;
  auto project = Project::FromText(xml, "harness", diagnostics);
  auto program =
      Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
  if (!program) throw std::logic_error(diagnostics.ToString());
  return program;
}

}  // namespace

class LeafHarness::MessageSink : public TickSink {
 public:
  void OnTick(const TickEvents& events) override {
    for (const NodeMessage& message : events.messages) messages.push_back(message.text);
  }
  std::vector<std::string> messages;
};

LeafHarness::LeafHarness(std::shared_ptr<const Registry> registry)
    : clock_(std::make_unique<SimulatedClock>()), sink_(std::make_unique<MessageSink>()) {
  const std::shared_ptr<const Program> program = ProgramOf(registry);
  executor_ = std::make_unique<Executor>(program, *clock_);
  executor_->AddSink(sink_.get());
  for (const PortDeclaration& port : registry->Find("Leaf")->manifest.ports) {
    if (!port.default_text) continue;
    Value value;
    if (!value.Parse(*port.type, *port.default_text)) continue;
    executor_->inbox()->Post(SlotOf(port.name, *port.type), 0, std::move(value));
  }
}

LeafHarness::LeafHarness(LeafHarness&&) noexcept = default;
LeafHarness::~LeafHarness() = default;

bool LeafHarness::WasWritten(const std::string& port) const {
  const SlotIndex slot = executor_->program().layout.Find(0, port);
  return slot != kNoSlot && executor_->blackboard()[slot].writes > 0;
}

Status LeafHarness::Tick() {
  sink_->messages.clear();
  return executor_->Tick();
}

void LeafHarness::Halt() {
  sink_->messages.clear();
  executor_->Halt();
}

const std::vector<std::string>& LeafHarness::messages() const { return sink_->messages; }

SlotIndex LeafHarness::SlotOf(const std::string& port, const Type& type) const {
  const Layout& layout = executor_->program().layout;
  const SlotIndex slot = layout.Find(0, port);
  if (slot == kNoSlot) throw std::invalid_argument("the leaf has no port \"" + port + "\"");
  if (layout.slots[slot].type != &type) {
    throw std::invalid_argument("port \"" + port + "\" is " + layout.slots[slot].type->name +
                                ", not " + type.name);
  }
  return slot;
}

}  // namespace coppice
