#include "robot_app/perception/tracking/tracker.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "robot_app/perception/tracking/assignment.h"

namespace coppice::robot::perception {
namespace {

constexpr double kNewRecord = 5;       // time runs back by more: begin anew [s]
constexpr double kRecently = 1;        // a sensor that saw somebody within is named [s]
constexpr double kMostEvidence = 10;   // nobody is surer than that
constexpr double kSurest = 0.98;       // of one detection
constexpr double kDoubtAfterMiss = 1;  // per second in which nobody was seen
constexpr int kSureOfMask = 2;         // votes
constexpr int kMostVotes = 4;          // so that who takes a mask off is believed soon

// Who is out of sight for longer has often stopped there, with somebody else.
constexpr double kGuess = 0.3;    // s
constexpr double kSlowing = 0.5;  // time constant [s]

double Evidence(double probability) {
  const double p = std::clamp(probability, 0.02, kSurest);
  return std::log(p / (1 - p));
}

std::size_t Index(Modality modality) {
  const auto found = std::find(kModalities.begin(), kModalities.end(), modality);
  return static_cast<std::size_t>(found - kModalities.begin());
}

// What a sensor tells of a person now that saw him `age` ago: where he was then.
Eigen::Matrix<double, 2, 4> Measured(double age) {
  Eigen::Matrix<double, 2, 4> measured;
  measured << Eigen::Matrix2d::Identity(), -age * Eigen::Matrix2d::Identity();
  return measured;
}

// Of a detection against a track: the square of the Mahalanobis distance, and that plus the
// logarithm of the spread, so that a vague track does not take what belongs to a sure one.
struct Fit {
  double distance = 0;
  double cost = 0;
};

Fit FitOf(const Track& track, const Detection& detection, double age) {
  const Eigen::Matrix<double, 2, 4> measured = Measured(age);
  const Eigen::Matrix2d spread =
      measured * track.covariance * measured.transpose() + detection.covariance;
  const Eigen::Vector2d off = detection.position - measured * track.state;
  const double distance = off.dot(spread.ldlt().solve(off));
  return {distance, distance + std::log(std::max(spread.determinant(), 1e-12))};
}

void Vote(const std::optional<bool>& has_mask, Track& track) {
  if (!has_mask) return;
  track.mask_votes = std::clamp(track.mask_votes + (*has_mask ? 1 : -1), -kMostVotes, kMostVotes);
  if (std::abs(track.mask_votes) >= kSureOfMask) track.has_mask = track.mask_votes > 0;
}

}  // namespace

void Tracker::Update(double time, const std::vector<Detection>& detections,
                     const IsHidden& is_hidden) {
  if (time < time_ - kNewRecord) {
    tracks_.clear();
    time_ = time;
  }
  const double age = std::max(time_ - time, 0.0);
  if (age > kMostDelay) return;
  if (age == 0) {
    Predict(tracks_.empty() ? 0 : time - time_);
    time_ = time;
  }

  const std::vector<int> matches = Match(detections, age);
  std::vector<bool> is_taken(detections.size(), false);
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (matches[i] < 0) continue;
    is_taken[matches[i]] = true;
    Correct(tracks_[i], detections[matches[i]], age);
  }
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(),
                               [&](const Track& track) { return IsGone(track, is_hidden); }),
                tracks_.end());
  for (std::size_t i = 0; i < detections.size(); ++i) {
    if (!is_taken[i]) Begin(detections[i], age);
  }
}

// Constant velocity with white acceleration.
void Tracker::Predict(double dt) {
  Eigen::Matrix4d step = Eigen::Matrix4d::Identity();
  step.topRightCorner<2, 2>() = Eigen::Matrix2d::Identity() * dt;
  Eigen::Matrix<double, 4, 2> push;
  push << Eigen::Matrix2d::Identity() * (dt * dt / 2), Eigen::Matrix2d::Identity() * dt;
  const Eigen::Matrix4d noise =
      push * push.transpose() * (options_.acceleration * options_.acceleration);
  for (Track& track : tracks_) {
    track.state = step * track.state;
    if (time_ - track.last_seen > kGuess) track.state.tail<2>() *= std::exp(-dt / kSlowing);
    track.covariance = step * track.covariance * step.transpose() + noise;
    track.evidence -= kDoubtAfterMiss * dt;
  }
}

std::vector<int> Tracker::Match(const std::vector<Detection>& detections, double age) const {
  constexpr double kNever = 1e6;
  Eigen::MatrixXd costs(tracks_.size(), detections.size());
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    for (std::size_t j = 0; j < detections.size(); ++j) {
      const Fit fit = FitOf(tracks_[i], detections[j], age);
      // Somebody who is known goes before who is only suspected.
      const double doubt = tracks_[i].is_confirmed ? 0 : options_.gate / 2;
      costs(i, j) = fit.distance < options_.gate ? fit.cost + doubt : kNever;
    }
  }
  return Assign(costs, kNever);
}

void Tracker::Correct(Track& track, const Detection& detection, double age) const {
  const Eigen::Matrix<double, 2, 4> measured = Measured(age);
  const Eigen::Matrix<double, 4, 2> with = track.covariance * measured.transpose();
  const Eigen::Matrix2d spread = measured * with + detection.covariance;
  const Eigen::Matrix<double, 4, 2> gain = with * spread.inverse();
  track.state += gain * (detection.position - measured * track.state);
  track.covariance -= gain * with.transpose();
  track.covariance = (track.covariance + track.covariance.transpose()) / 2;
  track.evidence = std::min(track.evidence + Evidence(detection.probability), kMostEvidence);
  track.is_confirmed = track.is_confirmed || track.evidence >= options_.confirmed;
  double& seen = track.seen_by[Index(detection.modality)];
  seen = std::max(seen, time_ - age);
  track.last_seen = std::max(track.last_seen, seen);
  track.modalities = 0;
  for (const Modality modality : kModalities) {
    if (time_ - track.seen_by[Index(modality)] <= kRecently) {
      track.modalities |= static_cast<std::uint8_t>(modality);
    }
  }
  Vote(detection.has_mask, track);
}

void Tracker::Begin(const Detection& detection, double age) {
  Track track;
  track.id = next_id_++;
  track.state << detection.position, 0, 0;
  track.covariance.setZero();
  track.covariance.topLeftCorner<2, 2>() = detection.covariance;
  track.covariance.bottomRightCorner<2, 2>() =
      Eigen::Matrix2d::Identity() * (options_.start_speed * options_.start_speed);
  // Meanwhile the person may have gone on.
  track.covariance.topLeftCorner<2, 2>() +=
      Eigen::Matrix2d::Identity() * std::pow(age * options_.start_speed, 2);
  track.first_seen = track.last_seen = time_ - age;
  track.seen_by[Index(detection.modality)] = time_ - age;
  track.modalities = static_cast<std::uint8_t>(detection.modality);
  track.evidence = Evidence(detection.probability);
  Vote(detection.has_mask, track);
  tracks_.push_back(track);
}

bool Tracker::IsGone(const Track& track, const IsHidden& is_hidden) const {
  const double unseen = time_ - track.last_seen;
  if (!track.is_confirmed) {
    const bool in_pictures = track.modalities == static_cast<std::uint8_t>(Modality::kCamera);
    return unseen > (in_pictures ? options_.tentative_in_pictures : options_.tentative);
  }
  if (unseen <= options_.forgotten) return false;
  return unseen > options_.hidden || !is_hidden(track.position());
}

}  // namespace coppice::robot::perception
