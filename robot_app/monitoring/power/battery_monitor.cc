#include "robot_app/monitoring/power/battery_monitor.h"

#include <cmath>

namespace coppice::robot::monitoring {
namespace {

using leaves::BatteryReading;

constexpr char kMonitor[] = "battery";
constexpr double kHour = 3600;

std::vector<GaugeWatch> GaugesOf(const BatteryLimits& watch) {
  return {{kMonitor, "voltage", "", "V", watch.voltage},
          {kMonitor, "current", "", "A", watch.current},
          {kMonitor, "charge", "", "", watch.charge},
          {kMonitor, "coulombs", "", "Ah", watch.coulombs},
          {kMonitor, "unchanged", "", "s", watch.unchanged},
          {kMonitor, "since_charge", "", "s", watch.since_charge},
          {kMonitor, "margin", "", "Ah", watch.margin}};
}

}  // namespace

void CoulombCount::Begin(const BatteryReading& reading, Time now) {
  counted_ = reading.charge;
  changed_at_ = now;
}

void CoulombCount::OnReading(const BatteryReading& reading, double charging_above, Time now) {
  const bool charges = reading.current > charging_above;
  const bool jumped_back = last_ && now < last_at_;
  const bool is_full = reading.charger == leaves::ChargerState::kFull;
  if (!charged_at_ || charges || is_full || jumped_back) charged_at_ = now;
  const bool is_counted = !std::isnan(reading.current) && !std::isnan(counted_);
  const bool goes_on = last_ && is_counted && !jumped_back && now - last_at_ <= longest_gap_ &&
                       charges == (last_->current > charging_above);
  if (goes_on) {
    counted_ += (last_->current + reading.current) / 2 * InSeconds(now - last_at_) / kHour;
    const bool stands =
        reading.charge == last_->charge && std::abs(reading.current) > charging_above;
    if (!stands) changed_at_ = now;
  } else {
    Begin(reading, now);
  }
  deviation_ = reading.charge - counted_;
  unchanged_ = InSeconds(now - changed_at_);
  since_charge_ = InSeconds(now - *charged_at_);
  last_ = reading;
  last_at_ = now;
}

void BatteryMonitor::Watch(const std::optional<BatteryLimits>& watch) {
  if (!watch || !watch_ || watch->topic != watch_->topic) {
    freshness_.Reset();
    since_.reset();
    knows_station_ = false;
  }
  watch_ = watch;
  board_.Watch(watch ? GaugesOf(*watch) : std::vector<GaugeWatch>());
}

void BatteryMonitor::OnReading(const BatteryReading& reading, const Times& times) {
  if (!watch_) return;
  freshness_.OnMessage(times);
  const Time now = times.ros;
  if (!since_ || now < *since_) since_ = now;
  knows_station_ = knows_station_ || leaves::StandsOnStation(reading, watch_->model.charging_above);
  Tell("voltage", watch_->voltage, reading.voltage, now);
  Tell("current", watch_->current, reading.current, now);
  Tell("charge", watch_->charge, reading.level, now);
  count_.OnReading(reading, watch_->model.charging_above, now);
  board_.OnValue(kMonitor, "since_charge", count_.since_charge(), now);
  if (!std::isnan(count_.deviation())) {
    board_.OnValue(kMonitor, "coulombs", count_.deviation(), now);
    board_.OnValue(kMonitor, "unchanged", count_.unchanged(), now);
  }
  const double charge =
      std::isnan(reading.charge) ? reading.level * watch_->model.capacity : reading.charge;
  const double needed =
      leaves::ChargeToDrive(watch_->model, distance_) + leaves::ChargeReserve(watch_->model);
  Tell("margin", watch_->margin, charge - needed, now);
}

void BatteryMonitor::Tell(const char* subject, const Band& band, double value, Time now) {
  if (!std::isnan(value)) return board_.OnValue(kMonitor, subject, value, now);
  if (HasBounds(band)) board_.OnFailure(kMonitor, subject, "not measured", now);
}

std::vector<Finding> BatteryMonitor::Report(const ProcessTable& processes, const Times& now) {
  if (!watch_) return {};
  if (processes.IsStarting(watch_->node)) freshness_.Reset();
  std::vector<Finding> findings = board_.Report(now.ros, now.ros);
  findings.insert(findings.begin(), State(processes, now));
  return findings;
}

Finding BatteryMonitor::State(const ProcessTable& processes, const Times& now) {
  Finding state = freshness_.Assess({kMonitor, "state", watch_->node}, watch_->staleness,
                                    watch_->topic + ": no message", processes, now);
  const bool is_heard = state.message.empty();
  if (is_heard && since_ && !knows_station_ && now.ros - *since_ > watch_->staleness) {
    state.level = leaves::HealthLevel::kError;
    state.message = watch_->topic + " has never told whether the robot stands on its station";
  }
  return state;
}

}  // namespace coppice::robot::monitoring
