// A run from a file: a record of Coppice, which may still grow, or a .btlog of BehaviorTree.CPP.
// It is read piece by piece, so the window stays usable while a long one is opened.
#ifndef COPPICE_EDITOR_LIVE_RECORD_SOURCE_H_
#define COPPICE_EDITOR_LIVE_RECORD_SOURCE_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "bt_core/analysis/recording.h"
#include "bt_core/record/record_cursor.h"
#include "editor/live/run_source.h"

namespace coppice::editor {

/// Whether the name of a file is one of a record: ".coppice" or ".btlog".
bool IsRecordName(const std::string& path);

class RecordSource final : public RunSource {
 public:
  /// Null if the file is no record; `diagnostics` say why.
  static std::unique_ptr<RecordSource> Open(const std::string& path, Diagnostics& diagnostics);

  const std::string& name() const override { return path_; }
  bool is_robot() const override { return false; }
  void Pump(LiveListener& listener) override;
  bool has_news() const override { return !is_done_; }
  bool is_loading() const override { return !was_done_; }
  /// Until its recorder has closed it.
  bool may_grow() const override { return record_ && !has_ended_; }
  void Refresh() override;
  void HangUp(const std::string& /*why*/) override { is_cut_ = is_done_ = was_done_ = true; }
  double progress() const override;
  /// By the size of its files.
  std::size_t most_bytes() const override;
  void Send(LiveCommand command, LiveClient::ReplyHandler on_reply) override;

 private:
  explicit RecordSource(std::string path) : path_(std::move(path)) {}
  void Begin(LiveListener& listener);
  bool Take(RecordItem item, LiveListener& listener);
  void TakeTick(TickEvents events, LiveListener& listener);

  const std::string path_;
  std::optional<Recording> log_;  // of a .btlog
  std::unique_ptr<RecordReader> record_;
  std::optional<RecordCursor> cursor_;
  const TreeDescription* tree_ = nullptr;
  bool has_begun_ = false;
  bool is_cut_ = false;   // the rest is not wanted
  bool is_done_ = false;  // all that is there was told
  bool was_done_ = false;
  bool has_ended_ = false;
  bool is_lost_ = false;       // something is missing before the next state
  std::uint64_t part_of_ = 0;  // number of the tick that is not whole yet
  std::size_t known_words_ = 0;
};

/// Tells a run in memory again.
void Tell(const Recording& run, HistoryHandler& handler);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_RECORD_SOURCE_H_
