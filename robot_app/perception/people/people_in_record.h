// Who was there in a record (rosbag) of a robot: the same that coppice-people does with what comes,
// done with what came, as fast as it goes and without a ROS master.
//
//   const auto figures = FollowInRecord("run.bag", {}, std::move(*classifiers), draw);
//   if (!figures) return Fail(figures.problem());
//
// Read are /velodyne_points, /people/sightings (what coppice-camera saw), /scan (while there are no
// clouds), /tf and /tf_static.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_PEOPLE_IN_RECORD_H_
#define COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_PEOPLE_IN_RECORD_H_

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/perception/people/people_follower.h"

namespace coppice::robot::perception {

/// Somebody who was followed.
struct PersonInRecord {
  double first_seen = 0, last_seen = 0;  ///< since the beginning of the record [s]
  std::optional<bool> has_mask;
  std::vector<Eigen::Vector2d> trail;  ///< in the frame in which people are followed [m]
};

struct RecordFigures {
  int clouds = 0;
  int pictures = 0;                                ///< messages of /people/sightings
  int scans = 0;                                   ///< that were looked at
  int refused = 0;                                 ///< messages with which something is wrong
  std::string problem;                             ///< of the first of them
  double seconds = 0;                              ///< that the record lasts
  std::map<std::uint32_t, PersonInRecord> people;  ///< by number
};

/// Called after each message that tells of people; `time` is since the beginning of the record [s].
using OnLook =
    std::function<void(double time, const PeopleFollower& follower, const RecordFigures& so_far)>;

/// A problem if the file is no record, or damaged. Messages that nobody can use are counted.
Expected<RecordFigures> FollowInRecord(const std::string& file, const FollowerOptions& options,
                                       Classifiers classifiers, const OnLook& on_look = {});

/// For people: how much was read, and a line for each person.
std::string Table(const RecordFigures& figures);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_PEOPLE_PEOPLE_IN_RECORD_H_
