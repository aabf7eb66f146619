#include "robot_app/perception/tracking/clear_mot.h"

#include <cmath>

#include "robot_app/perception/tracking/assignment.h"

namespace coppice::robot::perception {

void ClearMot::Add(const std::vector<MotPerson>& truth, const std::vector<MotPerson>& tracked) {
  constexpr double kKept = 1e3;  // an old pair goes before any new one
  Eigen::MatrixXd costs(truth.size(), tracked.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto before = track_of_.find(truth[i].id);
    for (std::size_t j = 0; j < tracked.size(); ++j) {
      const double distance = (truth[i].position - tracked[j].position).norm();
      const bool was_pair = before != track_of_.end() && before->second == tracked[j].id;
      costs(i, j) = distance < same_ ? distance - (was_pair ? kKept : 0) : 2 * kKept;
    }
  }
  const std::vector<int> pairs_now = Assign(costs, kKept);
  std::vector<bool> is_somebody(tracked.size(), false);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    people += truth[i].is_optional ? 0 : 1;
    if (pairs_now[i] < 0) {
      missed += truth[i].is_optional ? 0 : 1;
      continue;
    }
    const MotPerson& track = tracked[pairs_now[i]];
    is_somebody[pairs_now[i]] = true;
    if (truth[i].is_optional) continue;
    const auto [known, is_new] = track_of_.try_emplace(truth[i].id, track.id);
    switches += !is_new && known->second != track.id ? 1 : 0;
    known->second = track.id;
    ++pairs;
    squares_ += (truth[i].position - track.position).squaredNorm();
  }
  for (std::size_t j = 0; j < tracked.size(); ++j) {
    extra += is_somebody[j] || tracked[j].is_optional ? 0 : 1;
  }
}

double ClearMot::mota() const {
  return people > 0 ? 1 - static_cast<double>(missed + extra + switches) / people : 0;
}

double ClearMot::position_error() const { return pairs > 0 ? std::sqrt(squares_ / pairs) : 0; }

}  // namespace coppice::robot::perception
