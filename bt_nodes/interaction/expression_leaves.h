// How trees make the robot look: SetExpression for what lasts, Express around what it belongs to.
//
//   <Express expression="GREETING">
//     <Say text="Good morning."/>
//   </Express>
#ifndef COPPICE_BT_NODES_INTERACTION_EXPRESSION_LEAVES_H_
#define COPPICE_BT_NODES_INTERACTION_EXPRESSION_LEAVES_H_

#include "bt_core/nodes/user_control.h"
#include "bt_nodes/interaction/expression.h"

namespace coppice::leaves {

class SetExpression : public SyncAction {
 public:
  static constexpr const char* kDescription = "Looks like that until told otherwise.";
  explicit SetExpression(Face& face) : face_(face) {}
  Input<Expression> expression{this, "expression", "how"};
  Status Run() override {
    face_.SetExpression(*expression);
    return Status::kSuccess;
  }

 private:
  Face& face_;
};

class Express : public UserDecorator {
 public:
  static constexpr const char* kDescription =
      "Looks like that as long as the child is active, unless something more important is shown. "
      "The result is the child's.";
  explicit Express(Face& face) : face_(face) {}
  Input<Expression> expression{this, "expression", "how"};

  Status Tick(Children& child, bool starting) override {
    if (starting) face_.Hold(held_ = *expression);
    const Status result = child.Tick(0);
    if (result != Status::kRunning) face_.Release(held_);
    return result;
  }
  void OnHalted() override { face_.Release(held_); }

 private:
  Face& face_;
  Expression held_ = Expression::NEUTRAL;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_INTERACTION_EXPRESSION_LEAVES_H_
