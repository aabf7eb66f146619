// Takes what a live client tells on its thread, and tells it again on another one. Who tells faster
// than the other takes it waits, and so does the robot behind him.
#ifndef COPPICE_EDITOR_LIVE_LIVE_QUEUE_H_
#define COPPICE_EDITOR_LIVE_LIVE_QUEUE_H_

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <variant>
#include <vector>

#include "bt_core/frames/history_size.h"
#include "bt_core/live/client/client.h"

namespace coppice::editor {

class LiveQueue final : public LiveListener {
 public:
  /// `wake` is called on the client's thread when the box was empty and is so no more. Behind about
  /// `most_bytes` that thread waits for Deliver.
  explicit LiveQueue(std::function<void()> wake, std::size_t most_bytes = SIZE_MAX)
      : wake_(std::move(wake)), most_bytes_(most_bytes) {}

  /// Any thread. Nobody waits any more: before the client is ended.
  void StopWaiting();

  bool empty() const;
  /// Any thread but the client's.
  void Deliver(LiveListener& listener);

  /// Any thread: calls the handler in the next Deliver.
  void PutReply(LiveClient::ReplyHandler on_reply, LiveReply reply);

  void OnConnection(const LiveConnection& connection) override;
  void OnNotice(const LiveNotice& notice) override;
  void OnForeignHooks(const std::vector<ForeignHook>& hooks) override;
  void OnPicture(const LivePicture& picture) override;
  void OnTree(const TreeDescription& tree) override { Put(tree, BytesOf(tree)); }
  void OnState(const HistoryState& state) override { Put(state, BytesOf(state)); }
  void OnTick(const TickEvents& events) override;
  void OnGap(const HistoryGap& gap) override { Put(gap); }
  void OnNote(const HistoryNote& note) override { Put(note, BytesOf(note)); }
  void OnEnd(const HistoryEnd& end) override { Put(end); }

 private:
  struct Reply {
    LiveClient::ReplyHandler handler;
    LiveReply reply;
  };
  struct Tick {
    TickEvents events;
    std::size_t first_word;  // of Letters::words
  };
  using Letter =
      std::variant<Tick, LiveConnection, LiveNotice, std::vector<ForeignHook>, TreeDescription,
                   HistoryState, HistoryGap, HistoryNote, HistoryEnd, Reply>;
  struct Letters {
    std::vector<Letter> all;
    std::vector<std::uint32_t> words;
    PictureSet pictures;  // the newest; handed behind the others

    bool empty() const { return all.empty() && pictures.empty(); }
  };

  // Has it added under the lock, when there is room, and wakes whoever may wait for it. `bytes`:
  // that it takes beside a letter.
  template <class Add>
  void Change(std::size_t bytes, const Add& add);
  void Put(Letter letter, std::size_t bytes = 0);
  static void Hand(const Letters& letters, LiveListener& listener);

  const std::function<void()> wake_;
  const std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable has_room_;
  Letters letters_;
  std::size_t bytes_ = 0;  // of the letters
  bool nobody_waits_ = false;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_LIVE_QUEUE_H_
