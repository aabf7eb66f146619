#include "bt_core/cli/live/live_scene.h"

#include <utility>

namespace coppice {
namespace {

constexpr std::size_t kTexts = 5;

std::string NameOfStatus(char byte) {
  const bool is_status = byte >= 0 && byte <= static_cast<char>(Status::kSkipped);
  return is_status ? ToString(static_cast<Status>(byte)) : "a result";
}

std::string DescribeText(const Event& event, const TreeDescription& tree) {
  const std::string& node = tree.nodes[event.index].path;
  switch (event.text) {
    case EventText::kInjected:
      return node + ": " + (event.bytes.empty() ? "a result" : NameOfStatus(event.bytes[0])) +
             " was put in its place";
    case EventText::kException:
      return node + " threw: " + std::string(event.bytes);
    default:
      return node + ": " + std::string(event.bytes);
  }
}

}  // namespace

std::string Describe(const LiveNotice& notice) {
  const DebugStop& stop = notice.event.stop;
  switch (notice.event.kind) {
    case DebugEvent::Kind::kResumed:
      return "goes on";
    case DebugEvent::Kind::kReplaced:
      return notice.path + ": " + ToString(stop.result) + " was put in its place";
    case DebugEvent::Kind::kRefused:
      return "not stopped: " + notice.event.reason;
    case DebugEvent::Kind::kStopped:
      break;
  }
  if (stop.where == DebugStop::Where::kBetweenTicks) {
    return "paused after tick " + std::to_string(stop.tick);
  }
  const bool is_before = stop.where == DebugStop::Where::kBefore;
  return std::string("stands ") + (is_before ? "before " : "after ") + notice.path +
         (is_before ? "" : std::string(", which returned ") + ToString(stop.result));
}

bool LiveSceneKeeper::Wait(std::uint64_t changes, Duration at_most) {
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, at_most, [&] { return scene_.changes != changes; });
}

void LiveSceneKeeper::Say(std::string text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  AddText(std::move(text));
  Changed();
}

void LiveSceneKeeper::OnConnection(const LiveConnection& connection) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scene_.connection = connection;
  if (!connection.is_live) {
    scene_.stop.clear();
    scene_.foreign_hooks.clear();
  }
  Changed();
}

void LiveSceneKeeper::OnTree(const TreeDescription& tree) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scene_.run.Set(tree);
  Changed();
}

void LiveSceneKeeper::OnState(const HistoryState& state) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scene_.run.Set(state);
  scene_.result = state.statuses.empty() ? Status::kIdle : state.statuses[0];
  Changed();
}

void LiveSceneKeeper::OnTick(const TickEvents& events) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scene_.run.Apply(
      events, [](const StatusChange&) {},
      [this](const Event& event) {
        if (event.code == EventCode::kText) AddText(DescribeText(event, scene_.run.tree()));
      });
  scene_.result = events.result;
  scene_.duration = events.duration;
  Changed();
}

void LiveSceneKeeper::OnGap(const HistoryGap& gap) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scene_.lost_ticks += gap.lost_ticks;
  Changed();
}

void LiveSceneKeeper::OnNotice(const LiveNotice& notice) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string text = Describe(notice);
  if (notice.event.kind == DebugEvent::Kind::kStopped) {
    scene_.stop = text;
  } else if (notice.event.kind == DebugEvent::Kind::kResumed) {
    scene_.stop.clear();
  } else if (notice.event.kind == DebugEvent::Kind::kRefused) {
    AddText(text);  // what was replaced is in the history too
  }
  Changed();
}

void LiveSceneKeeper::OnForeignHooks(const std::vector<ForeignHook>& hooks) {
  const std::lock_guard<std::mutex> lock(mutex_);
  scene_.foreign_hooks = hooks;
  Changed();
}

void LiveSceneKeeper::AddText(std::string text) {
  scene_.texts.push_back(std::move(text));
  if (scene_.texts.size() > kTexts) scene_.texts.pop_front();
}

void LiveSceneKeeper::Changed() {
  ++scene_.changes;
  changed_.notify_all();
}

}  // namespace coppice
