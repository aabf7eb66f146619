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

bool LiveQueue::empty() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return letters_.all.empty();
}

void LiveQueue::Put(Letter letter) {
  bool was_empty = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    was_empty = letters_.all.empty();
    letters_.all.push_back(std::move(letter));
  }
  if (was_empty && wake_) wake_();
}

void LiveQueue::PutReply(LiveClient::ReplyHandler on_reply, LiveReply reply) {
  if (on_reply) Put(Reply{std::move(on_reply), std::move(reply)});
}

void LiveQueue::OnTick(const TickEvents& events) {
  bool was_empty = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    was_empty = letters_.all.empty();
    letters_.all.push_back(Tick{events, letters_.words.size()});
    letters_.words.insert(letters_.words.end(), events.words.data,
                          events.words.data + events.words.size);
  }
  if (was_empty && wake_) wake_();
}

void LiveQueue::Deliver(LiveListener& listener) {
  Letters letters;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::swap(letters, letters_);
  }
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
}

}  // namespace coppice::editor
