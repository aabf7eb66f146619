#include "bt_core/cli/event_json.h"

#include "bt_core/base/json.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

const char* NameOf(EventText text) {
  switch (text) {
    case EventText::kException:
      return "exception";
    case EventText::kInjected:
      return "injected";
    default:
      return "message";
  }
}

const char* NameOf(HistoryState::Cause cause) {
  switch (cause) {
    case HistoryState::Cause::kBegin:
      return "begin";
    case HistoryState::Cause::kLost:
      return "lost";
    case HistoryState::Cause::kJump:
      return "jump";
    default:
      return "keyframe";
  }
}

JsonObject Begin(const char* type) {
  JsonObject object;
  object.AddText("type", type);
  return object;
}

JsonObject Begin(const char* type, Time time) {
  return Begin(type).Add("time_ns", std::to_string(ToNanoseconds(time)));
}

std::string ToJson(const ToldTick::Change& change) {
  return JsonObject()
      .AddText("node", change.node)
      .AddText("from", ToString(change.from))
      .AddText("to", ToString(change.to))
      .Finish();
}

std::string ToJson(const ToldTick::Write& write) {
  JsonObject object;
  object.AddText("scope", write.scope).AddText("key", write.key);
  object.Add("value", ValueBytesToJson(write.value));
  if (!write.writer.empty()) object.AddText("writer", write.writer);
  return object.Finish();
}

std::string ToJson(const ToldTick::Message& message) {
  return JsonObject()
      .AddText("node", message.node)
      .AddText("kind", NameOf(message.kind))
      .AddText("text", message.text)
      .Finish();
}

template <class Item>
std::string ArrayOf(const std::vector<Item>& items) {
  return JsonArray(items, [](const Item& item) { return ToJson(item); });
}

}  // namespace

std::string EventJson(const TreeDescription& tree) {
  JsonObject metadata;
  for (const auto& [key, value] : tree.info.metadata) metadata.AddText(key, value);
  return Begin("tree")
      .AddText("tree", tree.main_tree)
      .AddText("writer", tree.writer)
      .AddText("run", ToString(tree.info.run))
      .AddText("clock", tree.info.clock)
      .Add("start_ns", std::to_string(ToNanoseconds(tree.info.start)))
      .Add("metadata", metadata.Finish())
      .Add("files", JsonArray(tree.documents, [](const auto& d) { return JsonString(d.file); }))
      .Add("nodes", JsonArray(tree.nodes, [](const auto& node) { return JsonString(node.path); }))
      .Finish();
}

std::string EventJson(const TreeDescription& tree, const HistoryState& state) {
  JsonObject statuses;
  for (NodeIndex i{0}; i < state.statuses.size(); ++i) {
    if (state.statuses[i] == Status::kIdle) continue;
    statuses.AddText(tree.nodes[i].path, ToString(state.statuses[i]));
  }
  return Begin("state", state.time)
      .Add("tick", state.tick)
      .AddText("cause", NameOf(state.cause))
      .Add("statuses", statuses.Finish())
      .Finish();
}

std::string EventJson(const ToldTick& tick) {
  return Begin("tick", tick.time)
      .Add("tick", tick.number)
      .Add("duration_ns", std::to_string(tick.duration.count()))
      .AddText("result", ToString(tick.result))
      .AddBool("whole", tick.is_whole)
      .Add("changes", ArrayOf(tick.changes))
      .Add("writes", ArrayOf(tick.writes))
      .Add("messages", ArrayOf(tick.messages))
      .Finish();
}

std::string EventJson(const HistoryGap& gap) {
  return Begin("gap", gap.time)
      .Add("lost_ticks", gap.lost_ticks)
      .Add("first_tick", gap.first_tick)
      .Add("last_tick", gap.last_tick)
      .Add("lost_notes", gap.lost_notes)
      .Finish();
}

std::string EventJson(const HistoryNote& note) {
  return Begin("note", note.time).AddText("kind", note.kind).AddText("text", note.text).Finish();
}

std::string EventJson(const HistoryEnd& end) {
  return Begin("end", end.time).Add("tick", end.tick).Finish();
}

}  // namespace coppice
