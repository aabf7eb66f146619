#include "tests/conformance/oracle.h"

#include <chrono>
#include <optional>
#include <stdexcept>

namespace coppice::conformance {

std::string Shape::Text(const std::string& name, const std::string& otherwise) const {
  for (const auto& [key, text] : attributes) {
    if (key == name) return text;
  }
  return otherwise;
}

int Shape::Number(const std::string& name, int otherwise) const {
  return std::stoi(Text(name, std::to_string(otherwise)));
}

Status Shape::Result(const std::string& name, Status otherwise) const {
  const std::string text = Text(name, ToString(otherwise));
  for (const Status status : {Status::kSuccess, Status::kFailure, Status::kRunning}) {
    if (text == ToString(status)) return status;
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

Status OracleNode::Tick() {
  const Status result = Run();
  if (result == Status::kRunning) has_begun_ = true;
  if (result == Status::kSkipped) has_begun_ |= !children.empty();
  if (IsCompleted(result)) has_begun_ = false;
  if (IsCompleted(result) || (result == Status::kSkipped && !RemembersWhenSkipped())) Forget();
  status_ = result;
  return result;
}

void OracleNode::Halt() {
  if (has_begun_) {
    OnHalt();
    ResetChildren();
    Forget();
  }
  has_begun_ = false;
  status_ = Status::kIdle;
}

void OracleNode::LetGo() {
  const Status status = status_;
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
