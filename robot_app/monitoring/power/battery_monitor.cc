#include "robot_app/monitoring/power/battery_monitor.h"

#include <cmath>

namespace coppice::robot {
namespace {

constexpr char kMonitor[] = "battery";
constexpr double kHour = 3600;

double InSeconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

std::vector<GaugeWatch> GaugesOf(const BatteryWatch& watch) {
  return {{kMonitor, "voltage", "", "V", watch.voltage},
          {kMonitor, "current", "", "A", watch.current},
          {kMonitor, "charge", "", "", watch.charge},
          {kMonitor, "coulombs", "", "Ah", watch.coulombs},
          {kMonitor, "unchanged", "", "s", watch.unchanged},
          {kMonitor, "since_charge", "", "s", watch.since_charge},
          {kMonitor, "margin", "", "Ah", watch.margin}};
}

}  // namespace

void CoulombCount::Begin(const BatterySample& sample, Time now) {
  counted_ = sample.charge;
  changed_at_ = now;
}

void CoulombCount::OnSample(const BatterySample& sample, double charging_above, Time now) {
  const bool charges = sample.current > charging_above;
  const bool jumped_back = last_ && now < last_at_;
  if (!charged_at_ || charges || jumped_back) charged_at_ = now;
  const bool goes_on = last_ && !jumped_back && now - last_at_ <= longest_gap_ &&
                       charges == (last_->current > charging_above);
  if (goes_on) {
    counted_ += (last_->current + sample.current) / 2 * InSeconds(now - last_at_) / kHour;
    const bool stands = sample.charge == last_->charge && std::abs(sample.current) > charging_above;
    if (!stands) changed_at_ = now;
  } else {
    Begin(sample, now);
  }
  deviation_ = sample.charge - counted_;
  unchanged_ = InSeconds(now - changed_at_);
  since_charge_ = InSeconds(now - *charged_at_);
  last_ = sample;
  last_at_ = now;
}

void BatteryMonitor::Watch(const std::optional<BatteryWatch>& watch) {
  if (!watch || !watch_ || watch->topic != watch_->topic) heard_at_.reset();
  watch_ = watch;
  board_.Watch(watch ? GaugesOf(*watch) : std::vector<GaugeWatch>());
}

void BatteryMonitor::OnSample(const BatterySample& sample, Time now) {
  if (!watch_) return;
  heard_at_ = now;
  const auto tell = [&](const char* subject, double value) {
    if (!std::isnan(value)) board_.OnValue(kMonitor, subject, value, now);
  };
  tell("voltage", sample.voltage);
  tell("current", sample.current);
  tell("charge", sample.level);
  count_.OnSample(sample, watch_->model.charging_above, now);
  tell("since_charge", count_.since_charge());
  if (!std::isnan(sample.charge)) {
    tell("coulombs", count_.deviation());
    tell("unchanged", count_.unchanged());
  }
  const double charge =
      std::isnan(sample.charge) ? sample.level * watch_->model.capacity : sample.charge;
  tell("margin", charge - ChargeToDrive(watch_->model, distance_) - ChargeReserve(watch_->model));
}

std::vector<Finding> BatteryMonitor::Report(const ProcessTable& processes, const Times& now) {
  if (!watch_) return {};
  if (processes.IsStarting(watch_->node)) heard_at_.reset();
  if (!heard_at_ || now.ros < *heard_at_) heard_at_ = now.ros;
  std::vector<Finding> findings = board_.Report(now.ros, now.ros);
  Finding state = State(now.ros);
  freshness_.Apply(state, now.wall, patience_);
  ApplyGrace(processes, watch_->node, state);
  findings.insert(findings.begin(), std::move(state));
  return findings;
}

Finding BatteryMonitor::State(Time now) const {
  const double silence = InSeconds(now - *heard_at_);
  Finding finding{kMonitor, "state", watch_->node, HealthLevel::kOk, silence, "s", "", now};
  if (now - *heard_at_ > watch_->staleness) {
    finding.level = HealthLevel::kError;
    finding.message = watch_->topic + ": no message for " + ToText(silence) + " s";
  }
  return finding;
}

}  // namespace coppice::robot
