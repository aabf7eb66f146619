#include "robot_app/storage/store_status.h"

#include <cstdio>

namespace coppice::robot::storage {
namespace {

using Level = StatusLine::Level;

double AgeOf(const Backlog& backlog, WallTime now) {
  if (backlog.oldest == 0) return 0;
  return std::chrono::duration<double>(now.time_since_epoch() - Duration(backlog.oldest)).count();
}

std::string Seconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f", seconds);
  return text;
}

std::string Waiting(const Backlog& backlog, WallTime now) {
  if (backlog.documents == 0) return "all messages are sent";
  return std::to_string(backlog.documents) + " messages wait, the oldest for " +
         Seconds(AgeOf(backlog, now)) + " s";
}

StatusLine OfServer(const StoreState& state, WallTime now) {
  StatusLine line{"server", Level::kOk, Waiting(state.backlog, now), {}};
  line.values = {{"sent", std::to_string(state.shipper.sent)},
                 {"refused", std::to_string(state.backlog.refused)}};
  if (state.backlog.refused > 0) {
    line.level = Level::kWarn;
    line.message = "the server has refused " + std::to_string(state.backlog.refused) + " messages";
  }
  if (!state.shipper.problem.empty()) {
    line.level = Level::kWarn;
    line.message = Waiting(state.backlog, now) + ": " + state.shipper.problem;
  }
  return line;
}

}  // namespace

StatusLine StoreStatus::OfSpool(const StoreState& state, WallTime now) {
  const std::int64_t lost = state.backlog.lost;
  if (lost_ >= 0 && lost > 0 && lost != lost_) lost_at_ = now;  // fewer: of a new spool
  lost_ = lost;
  StatusLine line{"spool", Level::kOk, "messages are kept on the disk", {}};
  line.values = {{"documents", std::to_string(state.backlog.documents)},
                 {"bytes", std::to_string(state.backlog.bytes)},
                 {"oldest", Seconds(AgeOf(state.backlog, now))},
                 {"stored", std::to_string(state.intake.stored)},
                 {"in memory", std::to_string(state.intake.documents)},
                 {"lost", std::to_string(lost)}};
  if (lost_at_ != WallTime::min() && now - lost_at_ < kLossLasts) {
    line.level = Level::kError;
    line.message = std::to_string(lost) + " messages were lost, the last ones just now";
  }
  if (!state.intake.problem.empty()) {
    line.level = Level::kError;
    line.message = "the spool cannot be written: " + state.intake.problem;
  }
  return line;
}

std::vector<StatusLine> StoreStatus::Judge(const StoreState& state, WallTime now) {
  return {OfSpool(state, now), OfServer(state, now)};
}

}  // namespace coppice::robot::storage
