// What leaves that speak to people need of a robot. Implemented on ROS topics in robot_app/ros, and
// on test doubles.
//
// All functions are called on the ticking thread and return at once.
#ifndef COPPICE_BT_NODES_INTERACTION_INTERACTION_H_
#define COPPICE_BT_NODES_INTERACTION_INTERACTION_H_

#include <string>

#include "bt_core/data/inbox.h"
#include "bt_nodes/basics/action_result.h"
#include "bt_nodes/basics/turn.h"

namespace coppice::leaves {

class Interaction {
 public:
  virtual ~Interaction() = default;
  /// Speaks a text, with a voice of its language: en, de ...; empty: the one that is spoken now.
  /// Reported as done when it has been spoken.
  virtual void Say(const std::string& text, const std::string& language,
                   Sender<ActionResult> done) = 0;
  virtual void CancelSpeech() = 0;

  Turn turn;  ///< of Say
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_INTERACTION_INTERACTION_H_
