// Leaves that address people, and the interface that they need of a robot.
#ifndef COPPICE_BT_NODES_INTERACTION_INTERACTION_LEAVES_H_
#define COPPICE_BT_NODES_INTERACTION_INTERACTION_LEAVES_H_

#include <string>

#include "bt_nodes/basics/capability_action.h"

namespace coppice {

/// Called on the ticking thread; returns at once.
class Interaction {
 public:
  virtual ~Interaction() = default;
  /// Speaks a text. Reported as done when it has been spoken.
  virtual void Say(const std::string& text, Sender<ActionResult> done) = 0;
  virtual void CancelSpeech() = 0;
  /// Shows a facial expression until the next one: NEUTRAL, SAD, SLEEP, LAUGHING, ...
  virtual void SetExpression(const std::string& expression) = 0;
};

class Say : public CapabilityAction {
 public:
  static constexpr const char* kDescription = "Speaks a text; succeeds when it has been spoken.";
  explicit Say(Interaction& interaction) : interaction_(interaction) {}
  Input<std::string> text{this, "text", "what to say"};

 protected:
  void Begin(Sender<ActionResult> done) override { interaction_.Say(*text, done); }
  void Cancel() override { interaction_.CancelSpeech(); }

 private:
  Interaction& interaction_;
};

class SetExpression : public SyncAction {
 public:
  static constexpr const char* kDescription = "Shows a facial expression.";
  explicit SetExpression(Interaction& interaction) : interaction_(interaction) {}
  Input<std::string> expression{this, "expression", "NEUTRAL, SAD, SLEEP, LAUGHING, CURIOUS, ..."};
  Status Run() override {
    interaction_.SetExpression(*expression);
    return Status::kSuccess;
  }

 private:
  Interaction& interaction_;
};

}  // namespace coppice

#endif  // COPPICE_BT_NODES_INTERACTION_INTERACTION_LEAVES_H_
