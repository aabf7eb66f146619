// The places of a site as leaves call them: the WaypointMap of a patrol, and the Routes between the
// places, with what has been learnt of them.
//
// Any thread: several trees tick at a time. What is learnt is written on a thread of its own, so
// that no tick waits for a disk.
#ifndef COPPICE_ROBOT_APP_COMMON_PLACES_SITE_PLACES_H_
#define COPPICE_ROBOT_APP_COMMON_PLACES_SITE_PLACES_H_

#include <functional>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "bt_core/base/clock.h"
#include "bt_nodes/navigation/routes.h"
#include "bt_nodes/navigation/waypoint_map.h"
#include "robot_app/common/places/route_guide.h"
#include "robot_app/common/service_caller.h"

namespace coppice::robot {

class SitePlaces : public leaves::WaypointMap, public leaves::Routes {
 public:
  /// Reads a file of places. The seed fixes the random order of the patrol. `memory`: the file of
  /// what is learnt of the edges; empty: it is forgotten with the program. Throws
  /// std::runtime_error with file:line and the reason if the places are not good; a broken memory
  /// is told on stderr.
  SitePlaces(const std::string& path, unsigned seed, const Clock& clock, std::string memory = {});
  ~SitePlaces() override;  // what is learnt is in the file then

  leaves::Waypoint ChooseForPatrol() override;
  bool Find(const std::string& name, leaves::Waypoint& waypoint) const override;

  Expected<std::optional<leaves::RouteLeg>> NextLeg(const Pose2D& robot, const std::string& place,
                                                    const std::string& language) override;
  bool IsAt(const Pose2D& robot, const std::string& place) override;
  void Ended(const std::string& leg, bool travelled, const Pose2D& robot) override;
  Expected<std::string> Nearest(const Pose2D& robot, const std::string& category) override;
  Expected<Description> Describe(const Pose2D& robot, const std::string& place,
                                 const std::string& language) override;

  /// `show` is called now, and after each leg on the thread that ends it, which must not wait: what
  /// is known of the edges has changed. Not while trees tick.
  void ShowWays(std::function<void(const RouteGuide&)> show);

  /// Not while trees tick.
  const RouteGuide& guide() const { return guide_; }

 private:
  Expected<int> Index(const std::string& place) const;
  const Place& At(int index) const;
  void Write(const std::string& text) const;
  void Save();

  std::mutex mutex_;  // of all that follows, but for the map
  RouteGuide guide_;
  std::mt19937 random_;
  int last_ = -1;  // of the patrol
  const Clock& clock_;
  std::string memory_;
  std::string leg_;  // that the robot is on, since
  Time since_{};
  std::function<void(const RouteGuide&)> show_;  // may be empty
  std::optional<ServiceCaller> writer_{std::in_place};
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PLACES_SITE_PLACES_H_
