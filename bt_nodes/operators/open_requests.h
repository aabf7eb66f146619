// The open requests for help of one tree, as a desired state: a leaf asserts its request in every
// tick in which help is wanted, and what is no longer asserted is withdrawn. So a request that
// waits for a person is no RUNNING node, and the tree goes on to other faults.
//
// For the ticking thread of one tree.
#ifndef COPPICE_BT_NODES_OPERATORS_OPEN_REQUESTS_H_
#define COPPICE_BT_NODES_OPERATORS_OPEN_REQUESTS_H_

#include <functional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/data/inbox.h"
#include "bt_nodes/monitoring/health.h"
#include "bt_nodes/operators/supervisor_channel.h"

namespace coppice::leaves {

/// What is asked of people.
struct WantedHelp {
  std::string subject;   ///< one open request for each
  std::string question;  ///< what is wrong and what to do
  /// Kinds of monitors, separated by semicolons: while one of them reports an error the request
  /// stays open, also when a more urgent fault keeps the tree from asserting it.
  std::string faults;
};

class OpenRequests {
 public:
  explicit OpenRequests(SupervisorChannel& channel) : channel_(channel) {}

  bool IsOpen(const std::string& subject) const;

  /// The request is wanted at `now`. Asks if it is not open or its question is another than before;
  /// only then a sender for the answer is made.
  void Assert(const WantedHelp& request, Time now,
              const std::function<Sender<ActionResult>()>& new_sender);

  /// The request was answered: the channel has closed it.
  void Forget(const std::string& subject);

  /// Withdraws what was not asserted for longer than `linger`, unless `health` (may be null) says
  /// that its fault is still there.
  void Settle(Time now, Duration linger, const Health* health);

 private:
  struct Open {
    WantedHelp request;
    Time asserted;
  };
  std::vector<Open>::iterator Find(const std::string& subject);

  SupervisorChannel& channel_;
  std::vector<Open> open_;
};

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_OPERATORS_OPEN_REQUESTS_H_
