// Where a run comes from: a robot, or a file. Whatever threads are behind it, its owner gets
// everything on his own thread, when he asks for it.
#ifndef COPPICE_EDITOR_LIVE_RUN_SOURCE_H_
#define COPPICE_EDITOR_LIVE_RUN_SOURCE_H_

#include <cstddef>
#include <string>

#include "bt_core/analysis/load_recording.h"
#include "bt_core/live/client/client.h"

namespace coppice::editor {

class RunSource {
 public:
  virtual ~RunSource() = default;

  /// "127.0.0.1:1667", or the path of a file.
  virtual const std::string& name() const = 0;
  virtual bool is_robot() const = 0;
  /// Played by the editor itself.
  virtual bool is_simulation() const { return false; }

  /// Hands over, in order, what has come since the last call, and calls the handlers of replies.
  virtual void Pump(LiveListener& listener) = 0;
  /// True if Pump has something to hand over.
  virtual bool has_news() const = 0;
  /// Of a file: it is being read for the first time.
  virtual bool is_loading() const { return false; }
  /// Of a file: looks whether it has grown. Costs little.
  virtual void Refresh() {}
  /// Of a file: somebody may still be writing it.
  virtual bool may_grow() const { return false; }
  /// Of a file: the part that was handed over, in [0, 1].
  virtual double progress() const { return 1; }
  /// That its run may take in memory, about [bytes]; then it is followed, or read, no further.
  virtual std::size_t most_bytes() const { return kMostRunBytes; }

  /// Nothing more is wanted but what has come until now. Of a robot, `why` becomes the problem of
  /// the connection.
  virtual void HangUp(const std::string& /*why*/) {}

  /// A file answers that it cannot.
  virtual void Send(LiveCommand command, LiveClient::ReplyHandler on_reply) = 0;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_RUN_SOURCE_H_
