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

constexpr double kKnownTurn = 0.5;  // rad: from so far off a registration finds it

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

std::vector<CloudPlaces::Candidate> CloudPlaces::Candidates(const KnownCloud& cloud,
                                                            const CloudQuestion& question) const {
  struct Near {
    float unlike;
    Candidate candidate;
  };
  std::vector<Near> near;
  for (std::size_t i = 0; i < clouds_.size(); ++i) {
    const auto guess = question(key_frames_[i]);
    if (guess) near.push_back({Unlike(clouds_[i].descriptor, cloud.descriptor), {i, *guess, 0}});
  }
  const std::size_t compared = std::min(settings_.compared, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(compared), near.end(),
                    [](const Near& a, const Near& b) {
                      return a.unlike != b.unlike ? a.unlike < b.unlike
                                                  : a.candidate.cloud < b.candidate.cloud;
                    });
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < compared; ++i) {
    Candidate& candidate = near[i].candidate;
    candidate.probability =
        classifier_.Probability(Compare(clouds_[candidate.cloud].descriptor, cloud.descriptor));
    if (candidate.probability >= settings_.least_probability) candidates.push_back(candidate);
  }
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.probability > b.probability; });
  candidates.resize(std::min(candidates.size(), settings_.candidates));
  return candidates;
}

// That a registration begins with.
std::vector<double> CloudPlaces::Turns(const Candidate& candidate, const KnownCloud& cloud) const {
  if (candidate.guess.doubt <= kKnownTurn) return {candidate.guess.turn};
  return LikelyTurns(clouds_[candidate.cloud].descriptor, cloud.descriptor, settings_.turns);
}

std::optional<CloudPlace> CloudPlaces::Find(const KnownCloud& cloud,
                                            const CloudQuestion& question) const {
  std::optional<CloudPlace> best;
  for (const Candidate& candidate : Candidates(cloud, question)) {
    const ThinCloud& known = clouds_[candidate.cloud].thin;
    for (const double turn : Turns(candidate, cloud)) {
      const auto registration =
          Register(known, cloud.thin, ToPose3({0, 0, turn}), settings_.registration);
      if (!registration) continue;
      const double off = ToPose2D(registration->relative).yaw - candidate.guess.turn;
      if (std::abs(std::remainder(off, 2 * M_PI)) > candidate.guess.doubt) continue;
      if (best && Fit(*registration) <= Fit(best->registration)) continue;
      best = CloudPlace{key_frames_[candidate.cloud], candidate.probability, *registration};
      if (IsSure(*registration, settings_.registration)) return best;
    }
  }
  return best;
}

}  // namespace coppice::robot::slam
