// What leaves need to reach the people who look after the robot. Implemented on the node of
// /assistance in robot_app/ros, and on test doubles.
//
// A request is known by its subject, for example "navigation" or "node /docking"; there is one
// request for each subject at most, and any number of subjects at the same time.
//
// All functions are called on the ticking thread and return at once.
#ifndef COPPICE_BT_NODES_OPERATORS_SUPERVISOR_CHANNEL_H_
#define COPPICE_BT_NODES_OPERATORS_SUPERVISOR_CHANNEL_H_

#include <string>

#include "bt_core/data/inbox.h"
#include "bt_nodes/basics/action_result.h"

namespace coppice::leaves {

class SupervisorChannel {
 public:
  virtual ~SupervisorChannel() = default;
  /// Opens a request about a subject, or joins the one that is open; the newest question and sender
  /// count. `done`, from any thread and once: ok when a person has confirmed that it is fixed; not
  /// ok when nobody could fix it or nobody answered in time. With the answer the request is closed.
  virtual void Ask(const std::string& subject, const std::string& question,
                   Sender<ActionResult> done) = 0;
  /// The fault has gone: closes the request, tells those who were asked (all-clear), and the sender
  /// is not used any more. Without effect if no request about the subject is open.
  virtual void Withdraw(const std::string& subject) = 0;
  /// A message that asks nothing and needs no answer.
  virtual void Tell(const std::string& subject, const std::string& message) = 0;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_OPERATORS_SUPERVISOR_CHANNEL_H_
