#include "editor/live/live_queue.h"

#include <utility>

namespace coppice::editor {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace

template <class Add>
void LiveQueue::Change(std::size_t bytes, const Add& add) {
  bool was_empty = false;
  {
    std::unique_lock<std::mutex> lock(mutex_);
    has_room_.wait(lock, [this] { return bytes_ < most_bytes_ || nobody_waits_; });
    was_empty = letters_.empty();
    bytes_ += sizeof(Letter) + bytes;
    add();
  }
  if (was_empty && wake_) wake_();
}

void LiveQueue::StopWaiting() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    nobody_waits_ = true;
  }
  has_room_.notify_all();
}

bool LiveQueue::empty() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return letters_.empty();
}

void LiveQueue::Put(Letter letter, std::size_t bytes) {
  Change(bytes, [&] { letters_.all.push_back(std::move(letter)); });
}

void LiveQueue::PutReply(LiveClient::ReplyHandler on_reply, LiveReply reply) {
  if (on_reply) Put(Reply{std::move(on_reply), std::move(reply)});
}

void LiveQueue::OnNotice(const LiveNotice& notice) {
  Put(notice, notice.path.size() + notice.event.reason.size());
}

void LiveQueue::OnForeignHooks(const std::vector<ForeignHook>& hooks) {
  std::size_t bytes = 0;
  for (const ForeignHook& hook : hooks) bytes += sizeof(hook) + hook.hook.path.size();
  Put(hooks, bytes);
}

// What a robot showed that is gone, nobody needs to see.
void LiveQueue::OnConnection(const LiveConnection& connection) {
  Change(connection.problem.size(), [&] {
    if (!connection.is_live) letters_.pictures.Clear();
    letters_.all.emplace_back(connection);
  });
}

// What is too much beside the others is of a robot that keeps no limits.
void LiveQueue::OnPicture(const LivePicture& picture) {
  Change(0, [&] { static_cast<void>(letters_.pictures.Put(picture)); });
}

void LiveQueue::OnTick(const TickEvents& events) {
  Change(events.words.size * sizeof(std::uint32_t), [&] {
    letters_.all.push_back(Tick{events, letters_.words.size()});
    letters_.words.insert(letters_.words.end(), events.words.data,
                          events.words.data + events.words.size);
  });
}

void LiveQueue::Deliver(LiveListener& listener) {
  Letters letters;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::swap(letters, letters_);
    bytes_ = 0;
  }
  has_room_.notify_all();
  Hand(letters, listener);
}

void LiveQueue::Hand(const Letters& letters, LiveListener& listener) {
  const auto hand =
      Overloaded{[&](const Tick& tick) {
                   TickEvents events = tick.events;
                   events.words.data = letters.words.data() + tick.first_word;
                   listener.OnTick(events);
                 },
                 [&](const LiveConnection& connection) { listener.OnConnection(connection); },
                 [&](const LiveNotice& notice) { listener.OnNotice(notice); },
                 [&](const std::vector<ForeignHook>& hooks) { listener.OnForeignHooks(hooks); },
                 [&](const TreeDescription& tree) { listener.OnTree(tree); },
                 [&](const HistoryState& state) { listener.OnState(state); },
                 [&](const HistoryGap& gap) { listener.OnGap(gap); },
                 [&](const HistoryNote& note) { listener.OnNote(note); },
                 [&](const HistoryEnd& end) { listener.OnEnd(end); },
                 [](const Reply& reply) { reply.handler(reply.reply); }};
  for (const Letter& letter : letters.all) std::visit(hand, letter);
  for (const auto& [name, picture] : letters.pictures.all()) listener.OnPicture(picture);
}

}  // namespace coppice::editor
