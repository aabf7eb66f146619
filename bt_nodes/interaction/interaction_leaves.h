// The leaf that speaks to people: Say.
#ifndef COPPICE_BT_NODES_INTERACTION_INTERACTION_LEAVES_H_
#define COPPICE_BT_NODES_INTERACTION_INTERACTION_LEAVES_H_

#include <string>

#include "bt_nodes/basics/capability_action.h"
#include "bt_nodes/interaction/interaction.h"

namespace coppice::leaves {

class Say : public CapabilityAction {
 public:
  static constexpr const char* kDescription = "Speaks a text; succeeds when it has been spoken.";
  explicit Say(Interaction& interaction) : interaction_(interaction) {}
  Input<std::string> text{this, "text", "what to say"};

 protected:
  void Begin(Sender<ActionResult> done) override { interaction_.Say(*text, "", done); }
  void Cancel() override { interaction_.CancelSpeech(); }
  Turn* turn() override { return &interaction_.turn; }

 private:
  Interaction& interaction_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_INTERACTION_INTERACTION_LEAVES_H_
