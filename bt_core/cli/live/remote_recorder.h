// Records a robot from elsewhere: what a live client gets becomes the file that a recorder on the
// robot would have written.
#ifndef COPPICE_BT_CORE_CLI_LIVE_REMOTE_RECORDER_H_
#define COPPICE_BT_CORE_CLI_LIVE_REMOTE_RECORDER_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "bt_core/base/outcome.h"
#include "bt_core/frames/history_encoder.h"
#include "bt_core/live/client/client.h"
#include "bt_core/record/record_series.h"

namespace coppice {

struct RemoteRecorderOptions {
  std::uint64_t max_file_bytes = 0;  ///< as RecorderOptions
  std::uint32_t keep_files = 0;
};

/// A run that begins anew is another record: demo.coppice, then demo.run2.coppice, demo.run3...
/// Connections that were lost are noted.
class RemoteRecorder final : public LiveListener, private FrameSink {
 public:
  /// Throws std::runtime_error if the file cannot be written or is there already.
  RemoteRecorder(const std::string& path, const RemoteRecorderOptions& options);

  /// When the client has ended: closes the record in order.
  void Close();

  struct Counts {
    std::uint64_t ticks = 0;
    std::uint64_t lost_ticks = 0;
    std::uint64_t bytes = 0;
    std::uint64_t runs = 0;
  };
  /// Any thread.
  Counts counts() const;
  /// Any thread: what went wrong with the disk last, or empty.
  std::string error() const;
  /// Any thread: how things stand, for people.
  LiveConnection connection() const;

  void OnConnection(const LiveConnection& connection) override;
  void OnTree(const TreeDescription& tree) override;
  void OnState(const HistoryState& state) override;
  void OnTick(const TickEvents& events) override;
  void OnGap(const HistoryGap& gap) override;
  void OnFrame(const std::uint8_t* frame, std::size_t size) override;

 private:
  void OnFrame(const Frame& frame) override;
  void Take(const std::uint8_t* frame, std::size_t size);
  void Append(const Bytes& bytes);
  void BeginFile();
  void BeginRecord();
  void Note(const std::string& text);
  void Write();
  void Report(const Outcome& outcome);

  const std::string path_;
  const RemoteRecorderOptions options_;
  std::unique_ptr<RecordSeries> series_;
  int records_ = 1;
  Bytes pending_;     // not yet in the kernel
  Bytes tree_frame_;  // the last one
  std::uint64_t file_bytes_ = 0;
  bool has_frames_ = false;  // of this run, in this file
  bool has_ended_ = false;   // the last frame is an end
  RunId run_{};
  bool is_groot2_ = false;
  bool was_live_ = false;
  std::optional<TreeDescription> described_;  // Groot2: waits for its state
  std::unique_ptr<HistoryEncoder> encoder_;   // Groot2
  Time time_{};                               // of the last tick
  std::uint64_t tick_ = 0;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();

  mutable std::mutex mutex_;  // for what follows
  Counts counts_;
  std::string error_;
  LiveConnection connection_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_LIVE_REMOTE_RECORDER_H_
