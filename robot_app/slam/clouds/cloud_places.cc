#include "robot_app/slam/clouds/cloud_places.h"

#include <algorithm>
#include <cmath>

#include "robot_app/slam/graph/floor_pose.h"

namespace coppice::robot::slam {
namespace {

// A first impression: how much the scalars differ, each in shares of itself.
float Unlike(const CloudDescriptor& a, const CloudDescriptor& b) {
  float sum = 0;
  for (std::size_t i = 0; i < kScalars; ++i) {
    const float size = std::abs(a.scalars[i]) + std::abs(b.scalars[i]) + 1e-3F;
    sum += std::abs(a.scalars[i] - b.scalars[i]) / size;
  }
  return sum;
}

// How well it fits; what only slides along walls does not fit where those end.
double Fit(const Registration& registration) {
  return registration.overlap + registration.hold_share;
}

}  // namespace

KnownCloud Keep(const CloudPoints& points, double range) {
  return {Describe(points), ThinOut(points, 0.2, range)};
}

void CloudPlaces::Add(std::uint32_t key_frame, KnownCloud cloud) {
  clouds_.push_back(std::move(cloud));
  key_frames_.push_back(key_frame);
}

void CloudPlaces::Remove(std::uint32_t key_frame) {
  for (std::size_t i = key_frames_.size(); i-- > 0;) {
    if (key_frames_[i] != key_frame) continue;
    clouds_[i] = std::move(clouds_.back());
    key_frames_[i] = key_frames_.back();
    clouds_.pop_back();
    key_frames_.pop_back();
  }
}

std::vector<CloudPlaces::Candidate> CloudPlaces::Candidates(
    const KnownCloud& cloud, const std::function<bool(std::uint32_t)>& is_asked) const {
  std::vector<std::pair<float, std::size_t>> near;
  for (std::size_t i = 0; i < clouds_.size(); ++i) {
    if (is_asked(key_frames_[i]))
      near.push_back({Unlike(clouds_[i].descriptor, cloud.descriptor), i});
  }
  const std::size_t compared = std::min(settings_.compared, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(compared), near.end());
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < compared; ++i) {
    const std::size_t known = near[i].second;
    const float probability =
        classifier_.Probability(Compare(clouds_[known].descriptor, cloud.descriptor));
    if (probability >= settings_.least_probability) candidates.push_back({known, probability});
  }
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.probability > b.probability; });
  candidates.resize(std::min(candidates.size(), settings_.candidates));
  return candidates;
}

std::optional<CloudPlace> CloudPlaces::Find(
    const KnownCloud& cloud, const std::function<bool(std::uint32_t)>& is_asked) const {
  std::optional<CloudPlace> best;
  for (const Candidate& candidate : Candidates(cloud, is_asked)) {
    const KnownCloud& known = clouds_[candidate.cloud];
    for (const double turn : LikelyTurns(known.descriptor, cloud.descriptor, settings_.turns)) {
      const auto registration =
          Register(known.thin, cloud.thin, ToPose3({0, 0, turn}), settings_.registration);
      if (!registration) continue;
      if (best && Fit(*registration) <= Fit(best->registration)) continue;
      best = CloudPlace{key_frames_[candidate.cloud], candidate.probability, *registration};
      if (IsSure(*registration, settings_.registration)) return best;
    }
  }
  return best;
}

}  // namespace coppice::robot::slam
