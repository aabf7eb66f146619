#include "bt_core/cli/live/live_json.h"

#include <nlohmann/json.hpp>

#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

using Json = nlohmann::ordered_json;

// In one line, whatever bytes the texts are made of.
void PrintLine(std::ostream& out, const Json& json) {
  out << json.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
}

Json ValueOf(std::string_view bytes) {
  Json value = Json::parse(ValueBytesToJson(bytes), nullptr, false);
  return value.is_discarded() ? Json(PrintValueBytes(bytes)) : value;
}

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

const char* NameOf(DebugEvent::Kind kind) {
  switch (kind) {
    case DebugEvent::Kind::kStopped:
      return "stopped";
    case DebugEvent::Kind::kResumed:
      return "resumed";
    case DebugEvent::Kind::kReplaced:
      return "replaced";
    default:
      return "refused";
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

}  // namespace

void LiveJsonPrinter::Print(const LiveConnection& connection) {
  Json json = {{"type", "connection"}, {"live", connection.is_live}};
  if (!connection.is_live) {
    json["problem"] = connection.problem;
  } else {
    json["protocol"] =
        connection.protocol == LiveConnection::Protocol::kGroot2 ? "groot2" : "coppice";
    json["run"] = ToString(connection.run);
    json["trees"] = connection.trees;
    if (!connection.refusal.empty()) json["refusal"] = connection.refusal;
  }
  PrintLine(out_, json);
}

void LiveJsonPrinter::Print(const TreeDescription& tree) {
  tree_ = tree;
  follower_.reset();
  has_state_ = false;
  Json nodes = Json::array();
  for (const DescribedNode& node : tree.nodes) nodes.push_back(node.path);
  PrintLine(out_, {{"type", "tree"}, {"tree", tree.main_tree}, {"nodes", nodes}});
}

void LiveJsonPrinter::Print(const HistoryState& state) {
  if (follower_) {
    follower_->Set(state);
  } else {
    follower_.emplace(ShapeOf(tree_), state);
  }
  if (state.cause == HistoryState::Cause::kKeyframe && has_state_) return;
  has_state_ = true;
  Json statuses = Json::object();
  for (NodeIndex i = 0; i < state.statuses.size(); ++i) {
    if (state.statuses[i] != Status::kIdle) {
      statuses[tree_.nodes[i].path] = ToString(state.statuses[i]);
    }
  }
  PrintLine(out_, {{"type", "state"},
                   {"cause", NameOf(state.cause)},
                   {"time_ns", state.time.count()},
                   {"tick", state.tick},
                   {"statuses", statuses}});
}

void LiveJsonPrinter::Print(const TickEvents& events) {
  Json changes = Json::array();
  Json writes = Json::array();
  Json messages = Json::array();
  const auto on_change = [&](const StatusChange& change) {
    changes.push_back({{"node", tree_.nodes[change.node].path},
                       {"from", ToString(change.from)},
                       {"to", ToString(change.to)}});
  };
  const auto on_event = [&](const Event& event) {
    if (event.code == EventCode::kWrite || event.code == EventCode::kDelivery) {
      const DescribedSlot& slot = tree_.slots[event.index];
      Json write = {{"scope", slot.scope}, {"key", slot.name}, {"value", ValueOf(event.bytes)}};
      if (event.code == EventCode::kWrite && event.writer < tree_.nodes.size()) {
        write["writer"] = tree_.nodes[event.writer].path;
      }
      writes.push_back(write);
    } else if (event.code == EventCode::kText) {
      Json message = {{"node", tree_.nodes[event.index].path}, {"kind", NameOf(event.text)}};
      if (event.text != EventText::kInjected) message["text"] = event.bytes;
      messages.push_back(message);
    }
  };
  follower_->Apply(events, on_change, on_event);
  PrintLine(out_, {{"type", "tick"},
                   {"time_ns", events.start.count()},
                   {"tick", events.tick},
                   {"duration_ns", events.duration.count()},
                   {"result", ToString(events.result)},
                   {"whole", events.is_whole},
                   {"changes", changes},
                   {"writes", writes},
                   {"messages", messages}});
}

void LiveJsonPrinter::Print(const HistoryGap& gap) {
  PrintLine(out_, {{"type", "gap"},
                   {"time_ns", gap.time.count()},
                   {"lost_ticks", gap.lost_ticks},
                   {"first_tick", gap.first_tick},
                   {"last_tick", gap.last_tick}});
}

void LiveJsonPrinter::Print(const HistoryNote& note) {
  PrintLine(
      out_,
      {{"type", "note"}, {"time_ns", note.time.count()}, {"kind", note.kind}, {"text", note.text}});
}

void LiveJsonPrinter::Print(const HistoryEnd& end) {
  PrintLine(out_, {{"type", "end"}, {"time_ns", end.time.count()}, {"tick", end.tick}});
}

void LiveJsonPrinter::Print(const LiveNotice& notice) {
  const DebugEvent& event = notice.event;
  Json json = {{"type", NameOf(event.kind)}};
  if (!notice.path.empty()) json["node"] = notice.path;
  if (event.stop.where == DebugStop::Where::kBefore) json["position"] = "before";
  if (event.stop.where == DebugStop::Where::kAfter) json["position"] = "after";
  if (event.stop.result != Status::kIdle) json["result"] = ToString(event.stop.result);
  if (event.stop.hook != kNoHook) json["hook"] = event.stop.hook;
  if (!event.reason.empty()) json["text"] = event.reason;
  PrintLine(out_, json);
}

}  // namespace coppice
