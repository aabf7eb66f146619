#include "robot_app/localization/particle_filter.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace coppice::robot::localization {
namespace {

constexpr double kFreshDeviation = 0.1;      // of particles at a place that was found [m]
constexpr double kFreshYawDeviation = 0.05;  // rad
constexpr double kStillNoise = 0.002;        // m and rad; keeps particles apart after resampling
constexpr double kBin = 0.25;                // of KLD sampling and of groups [m]
constexpr double kYawBin = M_PI / 18;        // rad
constexpr double kGroupRadius = 1.0;         // m
constexpr double kGroupYaw = 0.5;            // rad

std::uint64_t BinOf(const Pose2D& pose, double size, double yaw_size) {
  const auto part = [](double value, double step) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / step)) &
                                      0x1fffff);
  };
  return part(pose.x, size) << 42 | part(pose.y, size) << 21 | part(pose.yaw, yaw_size);
}

}  // namespace

double Belief::deviation() const { return std::sqrt(std::max(0.0, variance_x + variance_y)); }

Pose2D ParticleFilter::Near(const Pose2D& pose, double deviation, double yaw_deviation) {
  return {pose.x + Normal(deviation), pose.y + Normal(deviation),
          NormalizeAngle(pose.yaw + Normal(yaw_deviation))};
}

void ParticleFilter::Set(const Pose2D& pose, double deviation, double yaw_deviation) {
  particles_.resize(settings_.most);
  const double weight = 1.0 / settings_.most;
  for (Particle& particle : particles_) {
    particle = {Near(pose, deviation, yaw_deviation), weight};
  }
  slow_ = fast_ = 0;
}

void ParticleFilter::Inject(const std::vector<FittingPlace>& places, double share) {
  if (places.empty()) return;
  share = particles_.empty() ? 1 : std::clamp(share, 0.0, 1.0);
  for (Particle& particle : particles_) particle.weight *= 1 - share;
  std::vector<double> scores;
  for (const FittingPlace& place : places) scores.push_back(place.agreement.share());
  std::discrete_distribution<std::size_t> pick(scores.begin(), scores.end());
  const auto count = static_cast<int>(std::ceil(share * settings_.most));
  for (int i = 0; i < count; ++i) {
    const Pose2D& place = places[pick(random_)].pose;
    particles_.push_back({Near(place, kFreshDeviation, kFreshYawDeviation), share / count});
  }
  Normalize();
}

void ParticleFilter::Spread(double deviation, double yaw_deviation) {
  for (Particle& particle : particles_) {
    particle.pose = Near(particle.pose, deviation, yaw_deviation);
  }
}

void ParticleFilter::Move(const Pose2D& motion) {
  const double way = std::hypot(motion.x, motion.y);
  const double turn = std::abs(motion.yaw);
  const double way_noise = settings_.way_noise * way + settings_.drift * turn + kStillNoise;
  const double turn_noise = settings_.turn_noise * turn + settings_.drift * way + kStillNoise;
  for (Particle& particle : particles_) {
    particle.pose = Compose(particle.pose, Near(motion, way_noise, turn_noise));
  }
}

void ParticleFilter::Weigh(const LikelihoodField& field, const std::vector<Beam>& beams) {
  std::vector<Point2D> ends;
  for (const Beam& beam : beams) {
    if (beam.hit) ends.push_back(beam.to);
  }
  if (ends.empty() || particles_.empty()) return;
  const double every = std::max(1.0, static_cast<double>(ends.size()) / settings_.beams);
  const double used = std::ceil(static_cast<double>(ends.size()) / every);
  const double power = std::min(1.0, settings_.independent / used);
  const double scale = -1 / (2 * settings_.end_noise * settings_.end_noise);
  double sum = 0;
  for (Particle& particle : particles_) {
    const PointComposer in_map(particle.pose);
    double likelihood = 1;  // of 60 beams at least random_share to the power of 60: no underflow
    for (double i = 0; i < static_cast<double>(ends.size()); i += every) {
      const Point2D end = in_map(ends[static_cast<std::size_t>(i)]);
      const double distance = field.Distance(end.x, end.y);
      likelihood *= (1 - settings_.random_share) * std::exp(scale * distance * distance) +
                    settings_.random_share;
    }
    const double logarithm = std::log(likelihood);
    sum += std::exp(logarithm / used) * particle.weight;
    particle.weight *= std::exp(power * logarithm);
    if (!field.Free(particle.pose.x, particle.pose.y)) particle.weight *= 0.1;
  }
  slow_ = slow_ == 0 ? sum : slow_ + settings_.slow * (sum - slow_);
  fast_ = fast_ == 0 ? sum : fast_ + settings_.fast * (sum - fast_);
  Normalize();
  Resample();
}

void ParticleFilter::Normalize() {
  double sum = 0;
  for (const Particle& particle : particles_) sum += particle.weight;
  const double even = 1.0 / static_cast<double>(particles_.size());
  for (Particle& particle : particles_) particle.weight = sum > 0 ? particle.weight / sum : even;
}

// As many as needed so that the distance of the sampled from the true distribution (Kullback and
// Leibler) is below 0.05 with probability 0.99 (Probabilistic Robotics, table 8.4).
std::size_t ParticleFilter::Needed(std::size_t bins) const {
  constexpr double kDistance = 0.05;
  constexpr double kQuantile = 2.326;
  const double k = static_cast<double>(std::max<std::size_t>(bins, 2)) - 1;
  const double b = 2 / (9 * k);
  const double root = 1 - b + std::sqrt(b) * kQuantile;
  const double needed = k / (2 * kDistance) * root * root * root;
  return static_cast<std::size_t>(std::clamp(needed, static_cast<double>(settings_.fewest),
                                             static_cast<double>(settings_.most)));
}

void ParticleFilter::Resample() {
  double squares = 0;
  std::unordered_set<std::uint64_t> bins;
  for (const Particle& particle : particles_) {
    squares += particle.weight * particle.weight;
    if (particle.weight * static_cast<double>(particles_.size()) > 0.01) {
      bins.insert(BinOf(particle.pose, kBin, kYawBin));
    }
  }
  const std::size_t count = Needed(bins.size());
  const bool few_carry_it = 1 / squares < static_cast<double>(particles_.size()) / 2;
  if (!few_carry_it && count * 3 / 2 > particles_.size()) return;
  std::vector<Particle> next;
  next.reserve(count);
  const double step = 1.0 / static_cast<double>(count);
  double mark = std::uniform_real_distribution<double>(0, step)(random_);
  double sum = particles_.front().weight;
  for (std::size_t i = 0; next.size() < count; mark += step) {
    while (mark > sum && i + 1 < particles_.size()) sum += particles_[++i].weight;
    next.push_back({particles_[i].pose, step});
  }
  particles_ = std::move(next);
}

double ParticleFilter::FreshShare() const {
  return slow_ > 0 ? std::clamp(1 - fast_ / slow_, 0.0, 1.0) : 0;
}

Belief ParticleFilter::belief() const {
  Belief belief;
  if (particles_.empty()) return belief;
  std::unordered_map<std::uint64_t, double> weights;
  const Particle* heaviest = nullptr;
  double most = -1;
  for (const Particle& particle : particles_) {
    double& weight = weights[BinOf(particle.pose, 2 * kBin, 2 * kYawBin)];
    weight += particle.weight;
    if (weight > most) {
      most = weight;
      heaviest = &particle;
    }
  }
  belief.pose = heaviest->pose;
  for (int round = 0; round < 3; ++round) {  // the mean shift settles at the middle of the group
    const Pose2D middle = belief.pose;
    double share = 0, x = 0, y = 0, yaw = 0, xx = 0, yy = 0, xy = 0, yaw2 = 0;
    for (const Particle& particle : particles_) {
      const double dx = particle.pose.x - middle.x;
      const double dy = particle.pose.y - middle.y;
      const double turn = NormalizeAngle(particle.pose.yaw - middle.yaw);
      if (std::hypot(dx, dy) > kGroupRadius || std::abs(turn) > kGroupYaw) continue;
      const double w = particle.weight;
      share += w;
      x += w * dx;
      y += w * dy;
      yaw += w * turn;
      xx += w * dx * dx;
      yy += w * dy * dy;
      xy += w * dx * dy;
      yaw2 += w * turn * turn;
    }
    if (!(share > 0)) break;
    x /= share, y /= share, yaw /= share;
    belief = {{middle.x + x, middle.y + y, NormalizeAngle(middle.yaw + yaw)},
              xx / share - x * x,
              yy / share - y * y,
              xy / share - x * y,
              yaw2 / share - yaw * yaw,
              share};
  }
  return belief;
}

}  // namespace coppice::robot::localization
