// Ways on the real floor by the real planner: where the robot would drive, with the doors and fire
// doors that are closed now.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_FLOOR_WAYS_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_FLOOR_WAYS_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/navigation/costmap.h"
#include "robot_app/navigation/planner.h"
#include "robot_app/navigation/way_field.h"
#include "robot_app/simulation/floor.h"

namespace coppice::robot::deployment {

class FloorWays {
 public:
  using Way = std::vector<Point2D>;

  /// On cells of `resolution` [m]: half as fine as the robot's map is four times as fast.
  explicit FloorWays(simulation::Floor floor, double resolution = 0.1);

  /// Empty if there is none.
  const Way& Find(const Pose2D& from, const Pose2D& to);
  /// Of the way to the staging pose, whatever is closed [m]; nothing if none leads there.
  std::optional<double> LengthHome(const Pose2D& from) const;

  /// A door or a place of the floor that the way passes, farther than `ahead` [m] from its start;
  /// empty if there is none. `doors`: doors, else places.
  std::string PassedBy(const Way& way, double ahead, bool doors) const;
  void Close(const std::string& name);
  void Open(const std::string& name);

  const simulation::Floor& floor() const { return floor_; }

 private:
  struct Closable {
    std::string name;
    bool is_door = false;
    simulation::Rectangle shape;
  };
  std::vector<int> CellsOf(const Closable& closable) const;
  void Update();

  simulation::Floor floor_;
  OccupancyGrid map_;
  std::vector<Closable> closables_;
  std::vector<std::string> closed_;
  navigation::Costmap costmap_;
  std::optional<navigation::WayField> home_;
  std::map<std::vector<int>, Way> found_;  // by the cells of both ends, with what is closed now
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_WORLD_FLOOR_WAYS_H_
