// The robot's battery: 24 V AGM, 75 Ah, with coulomb counting.
//
// The open voltage falls linearly with the charge, which is a good fit for lead-acid cells above
// the knee, and the terminal voltage sags (or rises) with the current over an inner resistance.
#ifndef COPPICE_ROBOT_APP_SIMULATION_BATTERY_H_
#define COPPICE_ROBOT_APP_SIMULATION_BATTERY_H_

namespace coppice::robot::simulation {

struct BatteryOptions {
  double capacity = 75;           ///< Ah
  double full_voltage = 25.4;     ///< V, without load
  double empty_voltage = 23.0;    ///< V, without load
  double resistance = 0.02;       ///< ohm
  double standby_current = 6.25;  ///< A, standing
  double slow_current = 15;       ///< A, driving as slowly as possible
  double fast_current = 18.75;    ///< A, driving at top speed
  double charging_current = 12;   ///< A, net, into the battery
  double efficiency = 0.7;        ///< of the motors
};

class Battery {
 public:
  explicit Battery(const BatteryOptions& options = {}, double state_of_charge = 1.0);

  /// Lets `dt` seconds pass. `effort` is 0 for standing, else the share (0..1] of the top speed;
  /// `contact` says that the charger feeds the robot;
  /// `climbing` is the power that lifts it [W], beyond what level ground takes.
  void Step(double dt, double effort, bool contact, double climbing = 0);

  /// Sets the charge, clamped to 0..1.
  void set_state_of_charge(double state_of_charge);

  double state_of_charge() const { return charge_ / options_.capacity; }  ///< 0..1
  double charge() const { return charge_; }                               ///< Ah
  double capacity() const { return options_.capacity; }                   ///< Ah
  double current() const { return current_; }  ///< A, negative when discharging (as sensor_msgs)
  double voltage() const;                      ///< V, at the terminals
  bool charging() const { return current_ > 0; }
  bool full() const { return charge_ >= options_.capacity; }
  bool empty() const { return charge_ <= 0; }

 private:
  BatteryOptions options_;
  double charge_;
  double current_ = 0;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_BATTERY_H_
