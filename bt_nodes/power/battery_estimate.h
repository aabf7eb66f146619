// How much charge a robot has left and how much it needs to reach its charging station. Pure
// functions of a battery's raw readings, for whoever must not believe a ready-made decision: the
// battery watchdog of the monitor tree and the battery monitor.
//
// Charge in Ah, current in A (negative: discharging, as sensor_msgs/BatteryState), voltage in V,
// distance in m, times in s.
#ifndef COPPICE_BT_NODES_POWER_BATTERY_ESTIMATE_H_
#define COPPICE_BT_NODES_POWER_BATTERY_ESTIMATE_H_

namespace coppice::leaves {

/// The battery and what the robot draws from it. The defaults are Sobi's: 24 V AGM, 75 Ah
/// (Stuede et al., ECMR 2021).
struct BatteryModel {
  double capacity = 75;         ///< Ah
  double full_voltage = 25.4;   ///< V, without load
  double empty_voltage = 23.0;  ///< V, without load
  double resistance = 0.02;     ///< ohm, inner
  double driving_current = 15;  ///< A, drawn while driving; positive
  double driving_speed = 0.28;  ///< m/s, mean on the way with its stops
  double charging_above = 0.5;  ///< A; a current into the battery counts from here on
  int docking_attempts = 3;     ///< that must still be possible on arrival
  double attempt_time = 120;    ///< s, of one of them
  double help_time = 1800;      ///< s, until a person who was asked is there
};

/// State of charge 0..1 from the voltage at the terminals, with the current's share taken out.
/// Linear between empty and full; a battery that has just been charged or loaded hard reads up to
/// a tenth too much or too little.
double LevelFromVoltage(const BatteryModel& model, double voltage, double current);

/// Charge that the way to the station takes [Ah], from the length of the path.
double ChargeToDrive(const BatteryModel& model, double distance);

/// Charge that must be left on arrival [Ah]: for all docking attempts, and for waiting until a
/// person has come when they all fail.
double ChargeReserve(const BatteryModel& model);

/// How long the charge lasts at the driving current [s]; 0 if there is none.
double TimeLeft(const BatteryModel& model, double charge);

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_POWER_BATTERY_ESTIMATE_H_
