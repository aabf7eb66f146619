// A person drives the robot from the page: who holds the wheel, and what the robot is told.
//
// At most one person drives. Their command counts for 300 ms, so the robot stops when the finger is
// lifted, the page is hidden or the connection breaks or is slow; it still belongs to that person
// then, and nothing else moves it, until the wheel is given back or nobody has touched it for a
// while. Time is handed in. Not for several threads.
#ifndef COPPICE_ROBOT_APP_TELEOPERATION_TELEOPERATION_H_
#define COPPICE_ROBOT_APP_TELEOPERATION_TELEOPERATION_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/teleoperation/obstacle_guard.h"

namespace coppice::robot::teleoperation {

struct TeleoperationSettings {
  double most_linear = 0.4;   ///< [m/s]
  double most_angular = 0.8;  ///< [rad/s]
  GuardSettings guard;
  Duration dead_man = std::chrono::milliseconds(300);
  Duration most_delay = std::chrono::milliseconds(500);  ///< there and back; then it is a stop
  Duration idle = std::chrono::seconds(30);              ///< then the wheel is free again
  Duration scan_lifetime = std::chrono::seconds(1);  ///< without a newer scan the robot only turns
};

class Teleoperation {
 public:
  explicit Teleoperation(TeleoperationSettings settings) : settings_(settings) {}

  /// Takes the wheel; from somebody else only if `take_over`. False: somebody else has it.
  bool Take(std::uint64_t client, const std::string& name, bool take_over, Time now);
  void Leave(std::uint64_t client);

  /// A wish of a person who has the wheel; without effect from others. Values that are no numbers
  /// count as zero. `seen`: the newest time of the robot that the page knew when it was said; a
  /// wish that has been on its way for too long is one to stop.
  void Drive(std::uint64_t client, const Velocity2D& wish, Time seen, Time now);

  /// What the laser sees, in base_link.
  void SetObstacles(std::vector<Point2D> points, Time now);

  /// What the robot is to do now: zero once when the wheel has become free, then nothing as long as
  /// nobody has it. Call it 20 times a second.
  std::optional<Velocity2D> Command(Time now);

  std::uint64_t driver() const { return driver_; }  ///< 0: nobody
  const std::string& driver_name() const { return name_; }
  /// Why the robot does not do what is wished, for people; empty: it does.
  const std::string& held() const { return held_; }

 private:
  Velocity2D Limited(const Velocity2D& wish) const;

  const TeleoperationSettings settings_;
  std::uint64_t driver_ = 0;
  std::string name_;
  Velocity2D wish_;
  Time wished_at_{};
  Time used_at_{};
  bool is_late_ = false;       // the wish was, and so is none
  bool must_release_ = false;  // the base is still to hear the zero of who has left
  std::vector<Point2D> obstacles_;
  Time obstacles_at_{};
  std::string held_;
};

}  // namespace coppice::robot::teleoperation

#endif  // COPPICE_ROBOT_APP_TELEOPERATION_TELEOPERATION_H_
