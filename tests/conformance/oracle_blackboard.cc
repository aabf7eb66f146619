// The nodes of the oracle that read or write the blackboard. All keys hold texts.
#include <algorithm>
#include <optional>
#include <sstream>

#include "tests/conformance/oracle.h"

namespace coppice::conformance {
namespace {

constexpr Status kSuccess = Status::kSuccess;
constexpr Status kFailure = Status::kFailure;
constexpr Status kRunning = Status::kRunning;
constexpr Status kSkipped = Status::kSkipped;

std::vector<std::string> Split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ';');) parts.push_back(part);
  return parts;
}

class SetBlackboard : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    const std::optional<std::string> value = world_.Read(shape_.Text("value", ""));
    if (!value) return kFailure;
    world_.Write(shape_.Text("output_key", ""), value);
    return kSuccess;
  }
};

class UnsetBlackboard : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    world_.Write(shape_.Text("key", ""), std::nullopt);
    return kSuccess;
  }
};

// The only scripts there are: key := 'text' and key == 'text'.
class Script : public OracleNode {
 protected:
  using OracleNode::OracleNode;
  std::string Part(const std::string& port, std::size_t k) const {
    std::istringstream stream(shape_.Text(port, ""));
    std::string part;
    for (std::size_t i = 0; i <= k; ++i) stream >> part;
    return part;
  }
  // Nothing if the key is empty.
  std::optional<bool> Test(const std::string& port) const {
    const auto value = world_.Read("{" + Part(port, 0) + "}");
    if (!value) return std::nullopt;
    return "'" + *value + "'" == Part(port, 2);
  }

 private:
  Status Run() override {
    if (shape_.type == "ScriptCondition") return Test("code").value_or(false) ? kSuccess : kFailure;
    const std::string text = Part("code", 2);
    world_.Write("{" + Part("code", 0) + "}", text.substr(1, text.size() - 2));
    return kSuccess;
  }
};

class Precondition : public Script {
  using Script::Script;
  Status Run() override {
    if (child().status() != kRunning) {
      const std::optional<bool> answer = Test("if");
      if (!answer) return kFailure;
      if (!*answer) return shape_.Result("else", kFailure);
    }
    return PassOn(child().Tick());
  }
};

// WasEntryUpdated, SkipUnlessUpdated, WaitValueUpdate.
class Updated : public OracleNode {
 public:
  Updated(World& world, const Shape& shape, Status otherwise)
      : OracleNode(world, shape), otherwise_(otherwise) {}

 private:
  Status Run() override {
    if (children.empty()) return Ask() ? kSuccess : otherwise_;
    if (child().status() != kRunning && !Ask()) return otherwise_;
    return PassOn(child().Tick());
  }
  bool Ask() {
    const std::string key = shape_.Text("entry", "");
    if (!world_.Read(key)) return false;
    return std::exchange(seen_, world_.writes[key]) != world_.writes[key];
  }

  const Status otherwise_;
  int seen_ = 0;
};

class Hysteresis : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    const auto value = world_.Read(shape_.Text("value", ""));
    const double low = std::stod(shape_.Text("low", ""));
    const double high = std::stod(shape_.Text("high", ""));
    if (!value || low > high) return kFailure;
    const double number = std::stod(*value);
    if (number <= low) {
      is_high_ = false;
    } else if (number >= high) {
      is_high_ = true;
    }
    return is_high_ ? kSuccess : kFailure;
  }

  bool is_high_ = false;
};

class Switch : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    std::vector<std::string> cases = Split(shape_.Text("cases", ""));
    for (int k = 1; shape_.type != "Switch" && k < count(); ++k) {
      cases.push_back(shape_.Text("case_" + std::to_string(k), "?"));
    }
    const auto value = world_.Read(shape_.Text("variable", ""));
    auto choice = cases.size();
    if (value) {
      const auto found = std::find(cases.begin(), cases.end(), *value);
      choice = static_cast<std::size_t>(found - cases.begin());
    }
    if (running_ && *running_ != choice) children[*running_]->Halt();
    const Status result = children[choice]->Tick();
    running_.reset();
    if (result == kRunning) running_ = choice;
    return PassOn(result);
  }
  void Forget() override { running_.reset(); }

  std::optional<std::size_t> running_;
};

class PersistentSequence : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    const std::string key = shape_.Text("current_child_idx", "");
    int place = std::stoi(world_.Read(key).value_or("0"));
    if (!was_running()) began_at_ = place;
    while (place < count()) {
      const Status result = children[static_cast<std::size_t>(place)]->Tick();
      if (result == kRunning) return result;
      place = result == kFailure ? 0 : place + 1;
      world_.Write(key, std::to_string(place));
      if (result == kFailure) return End(result);
      if (result == kSkipped) ++skipped_;
    }
    world_.Write(key, "0");
    return End(began_at_ == 0 && skipped_ == count() ? kSkipped : kSuccess);
  }
  void Forget() override { skipped_ = 0; }

  int began_at_ = 0;
  int skipped_ = 0;
};

// LoopInt, LoopString, ...
class LoopOver : public OracleNode {
  using OracleNode::OracleNode;
  Status Run() override {
    if (child().status() != kRunning) {
      const std::vector<std::string> list = Split(shape_.Text("queue", ""));
      if (taken_ == list.size()) return shape_.Result("if_empty", kSuccess);
      world_.Write(shape_.Text("value", ""), list[taken_++]);
    }
    const Status result = child().Tick();
    if (result == kRunning) return result;
    ResetChildren();
    if (result == kFailure) return result;
    world_.tick_again = true;
    return kRunning;
  }
  void Forget() override { taken_ = 0; }
  bool RemembersWhenSkipped() const override { return taken_ > 0; }

  std::size_t taken_ = 0;
};

}  // namespace

std::unique_ptr<OracleNode> MakeBlackboardNode(const Shape& shape, World& world) {
  const std::string& type = shape.type;
  if (type == "SetBlackboard") return std::make_unique<SetBlackboard>(world, shape);
  if (type == "UnsetBlackboard") return std::make_unique<UnsetBlackboard>(world, shape);
  if (type == "Script" || type == "ScriptCondition") return std::make_unique<Script>(world, shape);
  if (type == "Precondition") return std::make_unique<Precondition>(world, shape);
  if (type == "WasEntryUpdated") return std::make_unique<Updated>(world, shape, kFailure);
  if (type == "SkipUnlessUpdated") return std::make_unique<Updated>(world, shape, kSkipped);
  if (type == "WaitValueUpdate") return std::make_unique<Updated>(world, shape, kRunning);
  if (type == "PersistentSequence") return std::make_unique<PersistentSequence>(world, shape);
  if (type == "Hysteresis") return std::make_unique<Hysteresis>(world, shape);
  if (type.rfind("Switch", 0) == 0) return std::make_unique<Switch>(world, shape);
  if (type.rfind("Loop", 0) == 0) return std::make_unique<LoopOver>(world, shape);
  return nullptr;
}

}  // namespace coppice::conformance
