// Finds people in the clouds of a 3-D lidar.
//
//   PeopleFinder finder({}, std::move(*PersonClassifier::Load(file)));
//   for (const SeenPerson& person : finder.Find(cloud.points)) ...
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_PEOPLE_FINDER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_PEOPLE_FINDER_H_

#include <vector>

#include "robot_app/perception/clouds/candidates.h"
#include "robot_app/perception/clouds/person_classifier.h"

namespace coppice::robot::perception {

struct FinderOptions {
  CandidateOptions candidates;
  float least_probability = 0.5F;
  float farthest = 20;  ///< [m]
};

struct SeenPerson {
  Eigen::Vector2f position{0, 0};  ///< of the body's axis, from the sensor's foot [m]
  Eigen::Matrix2f covariance = Eigen::Matrix2f::Identity();  ///< [m^2]
  float turn = 0;             ///< when in the turn of the sensor the person was met, 0..1
  float top = 0;              ///< of what is seen of the person, above the floor [m]
  float probability = 0;      ///< 0..1
  std::uint32_t cluster = 0;  ///< which of the candidates it is
};

class PeopleFinder {
 public:
  PeopleFinder(const FinderOptions& options, PersonClassifier classifier);

  /// Who is seen in this turn, surest first; nobody twice. Valid until the next call.
  const std::vector<SeenPerson>& Find(const std::vector<LidarPoint>& points);

  /// How it came to that, of the last call.
  const CandidateFinder& candidates() const { return candidates_; }

 private:
  FinderOptions options_;
  PersonClassifier classifier_;
  CandidateFinder candidates_;
  std::vector<SeenPerson> sure_;
  std::vector<SeenPerson> people_;
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_PEOPLE_FINDER_H_
