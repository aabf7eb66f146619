#include "tests/conformance/oracle.h"

#include <chrono>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace coppice::conformance {

std::string Shape::Text(std::string_view name, const char* otherwise) const {
  const std::string* text = Find(name);
  return text != nullptr ? *text : otherwise;
}

int Shape::Number(std::string_view name, int otherwise) const {
  const std::string* text = Find(name);
  return text != nullptr ? std::stoi(*text) : otherwise;
}

Status Shape::Result(std::string_view name, Status otherwise) const {
  const std::string* text = Find(name);
  if (text == nullptr) return otherwise;
  for (const Status status : {Status::kSuccess, Status::kFailure, Status::kRunning}) {
    if (*text == ToString(status)) return status;
  }
  return Status::kSkipped;
}

std::optional<std::string> World::Read(const std::string& text) const {
  if (text.empty() || text.front() != '{') return text;
  const auto found = blackboard.find(text);
  if (found == blackboard.end()) return std::nullopt;
  return found->second;
}

void World::Write(const std::string& text, std::optional<std::string> value) {
  if (text.empty()) return;
  ++writes[text];
  blackboard.erase(text);
  if (value) blackboard[text] = *value;
}

bool OracleNode::Guard(std::string_view name, bool otherwise) const {
  const std::string* text = shape_.Find(name);
  if (text == nullptr) return otherwise;
  std::istringstream script(*text);
  std::string key;
  std::string relation;
  std::string number;
  if (!(script >> key >> relation >> number)) return otherwise;
  return (world_.Read("{" + key + "}") == number) == (relation == "==");
}

void OracleNode::Hook(std::string_view name) {
  const std::string* script = shape_.Find(name);
  if (script == nullptr) return;
  const std::string key = "{" + script->substr(0, script->find(' ')) + "}";
  const std::size_t text = script->find('\'') + 1;
  world_.Write(key, *world_.Read(key) + script->substr(text, script->size() - 1 - text));
}

Status OracleNode::Tick() {
  const Status decided = AskGuards();
  const Status result = decided == Status::kIdle ? TickUnguarded() : decided;
  status_ = result;
  if (result == Status::kSuccess) Hook("_onSuccess");
  if (result == Status::kFailure) Hook("_onFailure");
  if (IsCompleted(result)) Hook("_post");
  return result;
}

Status OracleNode::AskGuards() {
  if (!was_running()) {
    if (Guard("_failureIf", false)) return Status::kFailure;
    if (Guard("_successIf", false)) return Status::kSuccess;
    if (Guard("_skipIf", false)) return Status::kSkipped;
    if (!Guard("_onlyIf", true)) return Status::kSkipped;
  }
  if (!Guard("_while", true)) {
    Halt();
    return Status::kSkipped;
  }
  if (!is_told_) Hook("_onStart");
  return Status::kIdle;
}

Status OracleNode::TickUnguarded() {
  const Status result = Run();
  if (result == Status::kRunning) has_begun_ = true;
  if (result == Status::kSkipped) has_begun_ |= !children.empty();
  if (IsCompleted(result)) has_begun_ = false;
  is_told_ = result == Status::kRunning || (result == Status::kSkipped && RemembersWhenSkipped());
  if (result != Status::kRunning && !is_told_) Forget();
  return result;
}

void OracleNode::Halt() {
  if (has_begun_) {
    OnHalt();
    ResetChildren();
    Forget();
  }
  if (is_told_) Hook("_onHalted");
  is_told_ = has_begun_ = false;
  status_ = Status::kIdle;
}

void OracleNode::LetGo() {
  const Status status = is_told_ ? Status::kIdle : status_;
  Halt();
  status_ = status;
}

void OracleNode::ResetChildren() {
  for (const auto& child : children) child->Halt();
}

void OracleNode::LeaveChildren() {
  for (const auto& child : children) child->status_ = Status::kIdle;
}

Status OracleNode::End(Status result) {
  ResetChildren();
  return result;
}

Status OracleNode::PassOn(Status result) {
  if (IsCompleted(result)) ResetChildren();
  if (result == Status::kSkipped) LeaveChildren();
  return result;
}

namespace {

class Leaf : public OracleNode {
 public:
  Leaf(World& world, const Shape& shape, int number) : OracleNode(world, shape), number_(number) {}

 private:
  Status Run() override { return world_.tick_leaf(number_, !has_begun()); }
  void OnHalt() override { world_.halt_leaf(number_); }
  bool RemembersWhenSkipped() const override { return has_begun(); }

  int number_;
};

class Constant : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    return shape_.type == "AlwaysSuccess" ? Status::kSuccess : Status::kFailure;
  }
};

// Sleep and TestNode: RUNNING for some time, then a result.
class Wait : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    const int msec = shape_.Number("msec", 0) + shape_.Number("async_delay", 0);
    if (!end_) end_ = world_.now + std::chrono::milliseconds(msec);
    if (world_.now >= *end_) return shape_.Result("return_status", Status::kSuccess);
    world_.WakeAt(*end_);
    return Status::kRunning;
  }
  void Forget() override { end_.reset(); }
  std::optional<Time> end_;
};

std::unique_ptr<OracleNode> Make(const Shape& shape, World& world, int& next_leaf) {
  const std::string& type = shape.type;
  if (type == "Leaf") return std::make_unique<Leaf>(world, shape, next_leaf++);
  if (type == "AlwaysSuccess" || type == "AlwaysFailure") {
    return std::make_unique<Constant>(world, shape);
  }
  if (type == "Sleep" || type == "TestNode") return std::make_unique<Wait>(world, shape);
  std::unique_ptr<OracleNode> node = MakeControl(shape, world);
  if (!node) node = MakeDecorator(shape, world);
  if (!node) node = MakeBlackboardNode(shape, world);
  if (!node) throw std::logic_error("no such node: " + type);
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
