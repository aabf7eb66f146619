// How the store is, in words and figures: what it says of itself on /diagnostics and /store/status.
#ifndef COPPICE_ROBOT_APP_STORAGE_STORE_STATUS_H_
#define COPPICE_ROBOT_APP_STORAGE_STORE_STATUS_H_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/storage/server/shipper.h"
#include "robot_app/storage/spool/intake.h"
#include "robot_app/storage/spool/spool.h"

namespace coppice::robot::storage {

struct StoreState {
  IntakeState intake;
  Backlog backlog;
  ShipperState shipper;
};

struct StatusLine {
  enum class Level : std::uint8_t { kOk, kWarn, kError };
  std::string name;
  Level level = Level::kOk;
  std::string message;
  std::vector<std::pair<std::string, std::string>> values;
};

/// Remembers when something was lost last. One thread.
class StoreStatus {
 public:
  /// A loss is an error for that long.
  static constexpr Duration kLossLasts = std::chrono::minutes(1);

  /// The spool and the server. An error is what loses messages: a spool that cannot be written, or
  /// is full. That the server is away is a warning. `now`: since 1970.
  std::vector<StatusLine> Judge(const StoreState& state, WallTime now);

 private:
  StatusLine OfSpool(const StoreState& state, WallTime now);

  std::int64_t lost_ = -1;  // before the first look
  WallTime lost_at_ = WallTime::min();
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_STORE_STATUS_H_
