// How well people are followed: CLEAR-MOT (K. Bernardin and R. Stiefelhagen, "Evaluating Multiple
// Object Tracking Performance: The CLEAR MOT Metrics", EURASIP JIVP 2008).
#ifndef COPPICE_ROBOT_APP_PERCEPTION_TRACKING_CLEAR_MOT_H_
#define COPPICE_ROBOT_APP_PERCEPTION_TRACKING_CLEAR_MOT_H_

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

namespace coppice::robot::perception {

/// Somebody, in truth or as tracked.
struct MotPerson {
  std::uint32_t id = 0;
  Eigen::Vector2d position{0, 0};
  /// Neither missed nor false: hidden, or outside the area that is looked at.
  bool is_optional = false;
};

class ClearMot {
 public:
  /// Within this distance [m] a track is taken for a person.
  explicit ClearMot(double same = 0.5) : same_(same) {}

  /// One moment: who is there, and who is tracked. A pair of the moment before is kept while it is
  /// near enough; the rest is paired so that the distances are least.
  void Add(const std::vector<MotPerson>& truth, const std::vector<MotPerson>& tracked);

  int people = 0;    ///< moments of people who had to be found
  int missed = 0;    ///< of them not found
  int extra = 0;     ///< moments of tracks that are nobody
  int switches = 0;  ///< another track than when the person had to be found last
  int pairs = 0;

  double mota() const;            ///< 1 - (missed + extra + switches) / people
  double position_error() const;  ///< root of mean square of the pairs [m]

 private:
  double same_;
  double squares_ = 0;
  std::map<std::uint32_t, std::uint32_t> track_of_;  // person -> the last track
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_TRACKING_CLEAR_MOT_H_
