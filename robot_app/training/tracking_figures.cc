#include "robot_app/training/tracking_figures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>

#include "robot_app/perception/clouds/hidden.h"
#include "robot_app/training/labelled_scan.h"
#include "robot_app/training/moving_crowd.h"

namespace coppice::robot::training {
namespace {

using perception::MotPerson;
using perception::Track;
using simulation::Pose2;
using simulation::Vec2;

constexpr double kStep = 0.02;        // of the world [s]
constexpr double kArea = 5;           // of which all have to be followed, around the robot [m]
constexpr double kBorder = 0.5;       // beyond it who is there counts neither way [m]
constexpr double kLeastSeen = 0.3;    // of a person
constexpr double kHalfPerson = 0.25;  // m
constexpr double kWarmUp = 2;         // s

Eigen::Vector2d ToEigen(Vec2 point) { return {point.x, point.y}; }

std::vector<simulation::Figure> FiguresOf(const MovingCrowd& crowd) {
  std::vector<simulation::Figure> figures;
  for (const simulation::Stance& stance : crowd.people()) figures.push_back(MakeFigure(stance));
  return figures;
}

// What the sensor saw in a turn in which it turned by `turned` and ended at `sensor`, in the frame
// of the hall.
std::vector<perception::Detection> InHall(const std::vector<perception::SeenPerson>& people,
                                          const Pose2& sensor, double turned) {
  std::vector<perception::Detection> detections;
  for (const perception::SeenPerson& person : people) {
    const Eigen::Rotation2Dd turn(sensor.yaw - (1 - person.turn) * turned);
    perception::Detection detection;
    detection.position = turn * person.position.cast<double>() + ToEigen(sensor.position());
    detection.covariance =
        turn * person.covariance.cast<double>() * turn.inverse().toRotationMatrix();
    detection.probability = person.probability;
    detections.push_back(detection);
  }
  return detections;
}

// Whether all of somebody who stands there is in the picture.
bool IsInView(const Glance& glance, Vec2 at) {
  const Vec2 seen = simulation::Rotated(at - glance.lens.position(), -glance.lens.yaw);
  const double distance = simulation::Length(seen);
  if (distance <= kHalfPerson || distance > kArea) return false;
  return std::abs(std::atan2(seen.y, seen.x)) + std::asin(kHalfPerson / distance) <
         glance.half_angle;
}

class Experiment {
 public:
  Experiment(const Senses& senses, const TrackingScenario& scenario)
      : senses_(senses),
        scenario_(scenario),
        site_(TrackingHall()),
        crowd_(site_, scenario.people, {0, 0}, 0.8, scenario.seed),
        scene_(site_.still),
        lidar_({}, scenario.seed) {
    for (int i = 0; i < scenario.people; ++i) {
      looks_.push_back(simulation::RandomPersonLook(1000 * scenario.seed + i));
    }
  }

  TrackingFigures Run() {
    for (double time = 0; time < scenario_.seconds; time += kStep) Step(time);
    return figures_;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void Step(double time) {
    crowd_.Step(kStep);
    figures_of_people_ = FiguresOf(crowd_);
    scene_.SetFigures(figures_of_people_);
    lidar_.Turn(time, kStep, robot_, scene_);
    robot_.yaw = simulation::NormalAngle(robot_.yaw + scenario_.turning * kStep);
    if (senses_.cameras != nullptr) LookAtPictures(time);
    if (lidar_.cloud().points.empty() || lidar_.cloud().time == cloud_time_) return;
    cloud_time_ = lidar_.cloud().time;
    if (senses_.lidar != nullptr) LookAtCloud(time);
  }

  void LookAtCloud(double time) {
    const auto points = ToPoints(lidar_.cloud());
    const auto begin = Clock::now();
    const auto detections =
        InHall(senses_.lidar->Find(points), robot_, scenario_.turning * lidar_.options().period);
    tracker_.Update(time, detections, [this](const Eigen::Vector2d& at) {
      const Vec2 local = simulation::Rotated({at.x() - robot_.x, at.y() - robot_.y}, -robot_.yaw);
      return perception::IsHidden(senses_.lidar->candidates().image(),
                                  ToEigen(local).cast<float>());
    });
    Count(time, lidar_.options().period, begin, nullptr);
  }

  // The lidar has gone on meanwhile; without it what is told is of the time of the picture.
  void LookAtPictures(double time) {
    std::vector<simulation::SeenPerson> people;
    for (std::size_t i = 0; i < looks_.size(); ++i) {
      people.push_back({crowd_.people()[i], looks_[i]});
    }
    const auto begin = Clock::now();
    if (auto glance = senses_.cameras->Look(time, scene_, people, robot_)) {
      pictures_.push_back(*std::move(glance));
    }
    if (pictures_.empty()) return;
    const double delay = senses_.lidar != nullptr ? scenario_.delay : 0;
    const Glance glance = pictures_.front();
    if (time + 1e-9 < glance.time + delay) return;
    pictures_.pop_front();
    tracker_.Update(glance.time, glance.people, [&](const Eigen::Vector2d& at) {
      return senses_.lidar != nullptr || !IsInView(glance, {at.x(), at.y()});
    });
    if (senses_.lidar == nullptr) Count(time, senses_.cameras->periods().depth / 2, begin, &glance);
  }

  // `glance`: only who is in that picture had to be seen.
  std::vector<MotPerson> Truth(const Glance* glance) const {
    std::vector<MotPerson> truth;
    for (std::size_t i = 0; i < figures_of_people_.size(); ++i) {
      const Vec2 at = figures_of_people_[i].bounds.center;
      const bool is_optional = simulation::Length(at - robot_.position()) > kArea ||
                               (glance != nullptr && !IsInView(*glance, at)) ||
                               VisibleShare(figures_of_people_[i], scene_, robot_, {}) < kLeastSeen;
      truth.push_back({static_cast<std::uint32_t>(i), ToEigen(at), is_optional});
    }
    return truth;
  }

  std::vector<MotPerson> Tracked(double time) const {
    std::vector<MotPerson> tracked;
    for (const Track& track : tracker_.tracks()) {
      if (!track.is_confirmed) continue;
      const bool is_outside =
          (track.position() - ToEigen(robot_.position())).norm() > kArea + kBorder;
      const bool is_guess = track.last_seen < time;  // where somebody hidden may be
      tracked.push_back({track.id, track.position(), is_outside || is_guess});
    }
    return tracked;
  }

  void Count(double time, double period, Clock::time_point begin, const Glance* glance) {
    figures_.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
    ++figures_.turns;
    if (scenario_.on_look) scenario_.on_look(time, tracker_);
    if (time < kWarmUp) return;
    figures_.mot.Add(Truth(glance), Tracked(time));
    if (glance != nullptr) figures_.all_round.Add(Truth(nullptr), Tracked(time));
    figures_.person_minutes += scenario_.people * period / 60;
  }

  Senses senses_;
  TrackingScenario scenario_;
  Site site_;
  MovingCrowd crowd_;
  std::vector<simulation::PersonLook> looks_;
  simulation::Scene scene_;
  std::vector<simulation::Figure> figures_of_people_;
  simulation::Lidar3d lidar_;
  std::deque<Glance> pictures_;  // not yet told
  Pose2 robot_;
  double cloud_time_ = -1;
  perception::Tracker tracker_;
  TrackingFigures figures_;
};

}  // namespace

Site TrackingHall() {
  Site site;
  site.area = {{0, 0}, {12, 12}, 0};
  site.still.ceiling = 3;
  site.still.AddBox({{0, 0}, {12.4, 12.4}, 0}, 3, simulation::Material::kWall);
  site.still.roofs.clear();  // the box is the walls of the hall, seen from inside
  site.still.AddBox({{2.5, 2}, {0.4, 0.4}, 0}, 3, simulation::Material::kWall);
  site.still.AddBox({{-2, -3}, {0.4, 0.4}, 0.5}, 3, simulation::Material::kWall);
  site.still.AddBox({{4.5, -4}, {0.8, 1.6}, 0}, 0.75, simulation::Material::kFurniture);
  return site;
}

TrackingFigures MeasureTracking(const Senses& senses, const TrackingScenario& scenario) {
  return Experiment(senses, scenario).Run();
}

std::string Summary(const TrackingFigures& figures) {
  char text[256];
  std::snprintf(text, sizeof(text),
                "MOTA %.3f (%d of %d missed, %d extra), %.2f identity switches a person-minute, "
                "position %.2f m, %.1f ms a turn\n",
                figures.mot.mota(), figures.mot.missed, figures.mot.people, figures.mot.extra,
                figures.switches_per_person_minute(), figures.mot.position_error(),
                1e3 * figures.seconds / std::max(figures.turns, 1));
  if (figures.all_round.people == 0) return text;
  char all_round[64];
  std::snprintf(all_round, sizeof(all_round), "; of all around the robot MOTA %.3f\n",
                figures.all_round.mota());
  return std::string(text, std::strlen(text) - 1) + all_round;
}

}  // namespace coppice::robot::training
