// Brings what lies in the spool to the server, on a thread of its own: as fast as the server takes
// it, and with a growing pause while it does not answer. A document leaves the spool only after the
// server has committed it, and may come twice, which the server notices by its key: so none is lost
// and none is there twice, whenever either end is killed.
#ifndef COPPICE_ROBOT_APP_STORAGE_SERVER_SHIPPER_H_
#define COPPICE_ROBOT_APP_STORAGE_SERVER_SHIPPER_H_

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "bt_core/base/clock.h"
#include "bt_core/base/wake_up.h"
#include "robot_app/storage/server/document_server.h"
#include "robot_app/storage/spool/spool.h"

namespace coppice::robot::storage {

struct ShipperOptions {
  std::string robot;
  BatchLimits batch;
  Duration first_pause = std::chrono::seconds(1);  ///< doubles from failure to failure
  Duration longest_pause = std::chrono::seconds(30);
  Duration patience = std::chrono::seconds(60);  ///< with an answer of the server
};

struct ShipperState {
  std::uint64_t sent = 0;  ///< documents, since the start
  std::string problem;     ///< why the server has not taken the last ones, or empty
};

/// One step: sends the next documents. True if there may be more to send at once. `state` gets what
/// came of it. Documents that the server refuses are sent one by one to find those that it means,
/// which are put aside. Throws as the spool does.
bool ShipNext(Spool& spool, DocumentServer& server, const ShipperOptions& options,
              ShipperState& state);

class Shipper {
 public:
  /// Spool and server must live longer.
  Shipper(Spool& spool, DocumentServer& server, ShipperOptions options);
  ~Shipper();

  /// There is something in the spool. Any thread.
  void Wake() { wake_up_.Notify(); }
  /// To be called every second or so: gives up waiting for a server that has not answered in
  /// `patience`.
  void Watch();

  ShipperState Look() const;

 private:
  void Run();
  bool Step(ShipperState& state);
  Duration PauseAfter(const ShipperState& state, bool is_more);

  Spool& spool_;
  DocumentServer& server_;
  const ShipperOptions options_;
  Duration pause_;
  WakeUp wake_up_;
  WakeUp has_ended_;
  std::atomic<bool> is_ending_{false};
  std::atomic<std::int64_t> asked_at_{0};  // of the wall clock [ns]; 0: the server is not asked
  mutable std::mutex mutex_;               // of the state
  ShipperState state_;
  std::thread thread_;
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SERVER_SHIPPER_H_
