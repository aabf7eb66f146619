// Takes what a live client tells on its thread, and tells it again on another one.
#ifndef COPPICE_EDITOR_LIVE_LIVE_QUEUE_H_
#define COPPICE_EDITOR_LIVE_LIVE_QUEUE_H_

#include <functional>
#include <mutex>
#include <variant>
#include <vector>

#include "bt_core/live/client/client.h"

namespace coppice::editor {

class LiveQueue final : public LiveListener {
 public:
  /// `wake` is called on the client's thread when the box was empty and is so no more.
  explicit LiveQueue(std::function<void()> wake) : wake_(std::move(wake)) {}

  bool empty() const;
  /// Any thread but the client's.
  void Deliver(LiveListener& listener);

  /// Any thread: calls the handler in the next Deliver.
  void PutReply(LiveClient::ReplyHandler on_reply, LiveReply reply);

  void OnConnection(const LiveConnection& connection) override;
  void OnNotice(const LiveNotice& notice) override { Put(notice); }
  void OnForeignHooks(const std::vector<ForeignHook>& hooks) override { Put(hooks); }
  void OnPicture(const LivePicture& picture) override;
  void OnTree(const TreeDescription& tree) override { Put(tree); }
  void OnState(const HistoryState& state) override { Put(state); }
  void OnTick(const TickEvents& events) override;
  void OnGap(const HistoryGap& gap) override { Put(gap); }
  void OnNote(const HistoryNote& note) override { Put(note); }
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

  // Has it added under the lock, and wakes whoever may wait for it.
  template <class Add>
  void Change(const Add& add);
  void Put(Letter letter);
  static void Hand(const Letters& letters, LiveListener& listener);

  const std::function<void()> wake_;
  mutable std::mutex mutex_;
  Letters letters_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_LIVE_QUEUE_H_
