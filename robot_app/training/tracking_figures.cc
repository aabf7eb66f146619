#include "robot_app/training/tracking_figures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <deque>

#include "robot_app/perception/clouds/hidden.h"
#include "robot_app/perception/sightings/leg_detections.h"
#include "robot_app/training/labelled_sweep.h"
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

constexpr double kSlack = 1e-9;  // s; time is a sum of steps

Eigen::Vector2d ToEigen(Vec2 point) { return {point.x, point.y}; }
Pose2D ToPose2D(const Pose2& pose) { return {pose.x, pose.y, pose.yaw}; }

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

// Whether all of somebody who stands there is where the laser looks.
bool IsInScan(const simulation::LidarOptions& laser, const Pose2& robot, Vec2 at) {
  const Vec2 seen = Compose(Inverse(Compose(robot, laser.mounting)), {at.x, at.y, 0}).position();
  const double distance = simulation::Length(seen);
  if (distance <= kHalfPerson) return false;
  return std::abs(std::atan2(seen.y, seen.x)) + std::asin(kHalfPerson / distance) <
         laser.field_of_view / 2;
}

class Experiment {
 public:
  Experiment(const Senses& senses, const TrackingScenario& scenario)
      : senses_(senses),
        scenario_(scenario),
        site_(TrackingHall()),
        crowd_(site_, scenario.people, {0, 0}, 0.8, scenario.seed),
        scene_(site_.still),
        lidar_({}, scenario.seed),
        laser_({}, scenario.seed),
        walls_(EdgesFrom(laser_.options().height, site_.still)) {
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
    const bool needs_laser = senses_.lidar == nullptr && senses_.legs != nullptr;
    if (needs_laser && time + kSlack >= next_scan_) LookAtScan(time);
    if (lidar_.cloud().points.empty() || lidar_.cloud().time == cloud_time_) return;
    cloud_time_ = lidar_.cloud().time;
    if (senses_.lidar != nullptr) LookAtCloud(time);
  }

  void LookAtCloud(double time) {
    const auto points = ToPoints(lidar_.cloud());
    const auto begin = Clock::now();
    cloud_pose_ = robot_;
    Update(time, InHall(senses_.lidar->Find(points), robot_,
                        scenario_.turning * lidar_.options().period));
    AddTime(begin);
    Count(time, lidar_.options().period, {});
  }

  void LookAtScan(double time) {
    next_scan_ += laser_.options().period;
    laser_.Measure(time, robot_, walls_,
                   simulation::SlicesAt(laser_.options().height, figures_of_people_));
    const auto begin = Clock::now();
    scan_ = ToLaserScan(laser_);
    laser_pose_ = ToPose2D(Compose(robot_, laser_.options().mounting));
    std::vector<perception::Detection> detections;
    for (const perception::SeenLegs& person : senses_.legs->Find(scan_)) {
      detections.push_back(ToDetection(person, laser_pose_));
    }
    Update(time, detections);
    AddTime(begin);
    Count(time, laser_.options().period,
          [&](Vec2 at) { return IsInScan(laser_.options(), robot_, at) || IsInPicture(at); });
  }

  // While something else gives the beat, it has gone on when a picture is told; else what is told
  // is of the time of the picture.
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
    const bool is_beat = senses_.lidar == nullptr && senses_.legs == nullptr;
    const Glance glance = pictures_.front();
    if (time + kSlack < glance.time + (is_beat ? 0 : scenario_.delay)) return;
    pictures_.pop_front();
    glances_[told_++ % glances_.size()] = glance;
    Update(glance.time, glance.people);
    AddTime(begin);
    if (!is_beat) return;
    Count(time, senses_.cameras->periods().depth / 2,
          [&](Vec2 at) { return IsInView(glance, at); });
  }

  void Update(double time, const std::vector<perception::Detection>& detections) {
    tracker_.Update(time, detections, [this](const Eigen::Vector2d& at) {
      return IsOutOfSight({at.x(), at.y()});
    });
  }

  // Of the front and the rear camera, which look in turn.
  bool IsInPicture(Vec2 at) const {
    return std::any_of(glances_.begin(), glances_.end(),
                       [&](const Glance& glance) { return IsInView(glance, at); });
  }

  // As the robot's program reckons.
  bool IsOutOfSight(Vec2 at) const {
    if (senses_.lidar != nullptr) {
      const Vec2 local = Compose(Inverse(cloud_pose_), {at.x, at.y, 0}).position();
      return perception::IsHidden(senses_.lidar->candidates().image(),
                                  ToEigen(local).cast<float>());
    }
    if (IsInPicture(at)) return false;
    if (senses_.legs == nullptr) return true;
    const Point2D local = RelativeTo(laser_pose_, Point2D{at.x, at.y});
    return perception::IsHidden(scan_, senses_.legs->options().farthest, {local.x, local.y});
  }

  // Who is not `covered` need not be seen; empty: everybody is.
  std::vector<MotPerson> Truth(const std::function<bool(Vec2)>& covered) const {
    std::vector<MotPerson> truth;
    for (std::size_t i = 0; i < figures_of_people_.size(); ++i) {
      const Vec2 at = figures_of_people_[i].bounds.center;
      const bool is_optional = simulation::Length(at - robot_.position()) > kArea ||
                               (covered && !covered(at)) ||
                               VisibleShare(figures_of_people_[i], scene_, robot_, {}) < kLeastSeen;
      truth.push_back({static_cast<std::uint32_t>(i), ToEigen(at), is_optional});
    }
    return truth;
  }

  // So long ago somebody was seen whom a camera still sees: without the lidar others give the beat.
  double Patience() const {
    const bool waits = senses_.lidar == nullptr && senses_.legs != nullptr;
    return waits && senses_.cameras != nullptr ? scenario_.delay + senses_.cameras->periods().depth
                                               : 0;
  }

  std::vector<MotPerson> Tracked(double time) const {
    std::vector<MotPerson> tracked;
    for (const Track& track : tracker_.tracks()) {
      if (!track.is_confirmed) continue;
      const bool is_outside =
          (track.position() - ToEigen(robot_.position())).norm() > kArea + kBorder;
      const bool is_guess = track.last_seen < time - Patience();  // where somebody hidden may be
      tracked.push_back({track.id, track.position(), is_outside || is_guess});
    }
    return tracked;
  }

  void AddTime(Clock::time_point begin) {
    figures_.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
  }

  void Count(double time, double period, const std::function<bool(Vec2)>& covered) {
    ++figures_.turns;
    if (scenario_.on_look) scenario_.on_look(time, tracker_);
    if (time < kWarmUp) return;
    figures_.mot.Add(Truth(covered), Tracked(time));
    if (covered) figures_.all_round.Add(Truth({}), Tracked(time));
    figures_.person_minutes += scenario_.people * period / 60;
  }

  Senses senses_;
  TrackingScenario scenario_;
  Site site_;
  MovingCrowd crowd_;
  std::vector<simulation::PersonLook> looks_;
  simulation::Scene scene_;
  std::vector<simulation::Figure> figures_of_people_;
  Pose2 robot_;
  simulation::Lidar3d lidar_;
  double cloud_time_ = -1;
  Pose2 cloud_pose_;
  simulation::Lidar laser_;
  simulation::RayCaster walls_;  // as the laser sees them
  LaserScan scan_;
  Pose2D laser_pose_;
  double next_scan_ = 0;
  std::deque<Glance> pictures_;      // not yet told
  std::array<Glance, 2> glances_{};  // told last; before that they see nothing
  std::size_t told_ = 0;
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
