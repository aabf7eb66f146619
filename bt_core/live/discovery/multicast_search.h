// Looks for robots by multicast DNS, in all networks of this computer. Asks after 1 s, 2 s, 4 s,
// then every 8 s, from ports of its own, on a thread of its own; while it rests nothing is sent.
#ifndef COPPICE_BT_CORE_LIVE_DISCOVERY_MULTICAST_SEARCH_H_
#define COPPICE_BT_CORE_LIVE_DISCOVERY_MULTICAST_SEARCH_H_

#include <functional>
#include <memory>
#include <string>

#include "bt_core/live/discovery/robot_search.h"

namespace coppice {

class MulticastSearch final : public RobotSearch {
 public:
  /// Rests. `wake`: called on its thread when there is news; must be quick. `address`: as
  /// InterfacesOf.
  explicit MulticastSearch(std::function<void()> wake = {}, const std::string& address = "*");
  ~MulticastSearch() override;

  std::vector<FoundRobot> Look() override;
  void Rest() override;
  bool has_news() const override;

 private:
  class Loop;

  std::unique_ptr<Loop> loop_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DISCOVERY_MULTICAST_SEARCH_H_
