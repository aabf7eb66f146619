// How fast the simulated time may pass: as fast as was asked for, but faster than real time only as
// long as the robot keeps up. A robot that is late because the computer has too much to do would be
// late for its own monitors, and what it does then says nothing about it.
//
//   Pace pace(6);                          // times real time
//   pace.Heard("odom", stamp, wall);       // with every transform that the robot publishes
//   wait_until(last_step + pace.Seconds(0.02, now, wall));
#ifndef COPPICE_ROBOT_APP_SIMULATION_PACE_H_
#define COPPICE_ROBOT_APP_SIMULATION_PACE_H_

#include <algorithm>
#include <map>
#include <string>

namespace coppice::robot::simulation {

/// For one thread.
class Pace {
 public:
  static constexpr double kLate = 0.3;    ///< so far behind the simulated time nobody need be [s]
  static constexpr double kSilent = 2.0;  ///< after this wall time without a word it is dead [s]

  /// `speed`: times real time; 0: as fast as possible.
  explicit Pace(double speed) : speed_(speed) {}

  /// As in the constructor, from the next step on.
  void set_speed(double speed) { speed_ = speed; }
  double speed() const { return speed_; }
  /// Whether a simulated second may be shorter than a real one.
  bool is_fast() const { return speed_ <= 0 || speed_ > 1; }

  /// Something the robot works out was true at `stamp` (simulated) and came at `wall` [s].
  /// `source` says what.
  void Heard(const std::string& source, double stamp, double wall) {
    sources_[source] = {stamp, wall};
  }

  /// The wall time that a step of `step` simulated seconds takes at `time` (simulated, as the
  /// stamps) and `wall` [s]. Whom nothing has been heard of for a while is not waited for.
  double Seconds(double step, double time, double wall) const {
    if (!is_fast()) return step / speed_;
    const bool is_late = std::any_of(sources_.begin(), sources_.end(), [&](const auto& source) {
      const Word& word = source.second;
      return wall - word.wall < kSilent && time - word.stamp > kLate;
    });
    if (is_late) return step;
    return speed_ > 0 ? step / speed_ : 0;
  }

 private:
  struct Word {
    double stamp, wall;
  };
  double speed_;
  std::map<std::string, Word> sources_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_PACE_H_
