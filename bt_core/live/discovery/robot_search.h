// Robots of the network that say that they are there (bt_core/live/discovery/announcer.h), for a
// screen that offers them: looked for as long as the screen looks, found a moment later.
//
//   MulticastSearch search(wake);              // where there are sockets
//   for (const FoundRobot& robot : search.Look()) Offer(robot);
//   search.Rest();                             // the screen shows something else now
//
// Whoever is in the network can say such things. So a name is only a name, an address is the one
// from which it was said, there is an end to how many are kept, and nothing connects by itself.
#ifndef COPPICE_BT_CORE_LIVE_DISCOVERY_ROBOT_SEARCH_H_
#define COPPICE_BT_CORE_LIVE_DISCOVERY_ROBOT_SEARCH_H_

#include <string>
#include <vector>

namespace coppice {

struct FoundRobot {
  std::string endpoint;  ///< "HOST:PORT"
  std::string host;      ///< what the robot calls its computer, and the tree; fit to be shown
  std::string tree;
  bool needs_token = false;
};

/// Any thread.
class RobotSearch {
 public:
  virtual ~RobotSearch() = default;

  /// Those that are there, the first that was heard first. Goes on looking until Rest().
  virtual std::vector<FoundRobot> Look() = 0;
  virtual void Rest() = 0;
  /// Whether the next Look() shows something else than the last one.
  virtual bool has_news() const = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DISCOVERY_ROBOT_SEARCH_H_
