#include "bt_core/cli/live/live_json.h"

#include "bt_core/base/json.h"
#include "bt_core/cli/event_json.h"

namespace coppice {
namespace {

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

}  // namespace

void LiveJsonPrinter::Print(const LiveConnection& connection) {
  JsonObject json;
  json.AddText("type", "connection").AddBool("live", connection.is_live);
  if (connection.is_live) {
    const bool is_groot2 = connection.protocol == LiveConnection::Protocol::kGroot2;
    json.AddText("protocol", is_groot2 ? "groot2" : "coppice");
    json.AddText("run", ToString(connection.run));
    json.Add("trees", JsonArray(connection.trees, JsonString));
    if (!connection.refusal.empty()) json.AddText("refusal", connection.refusal);
  } else {
    json.AddText("problem", connection.problem);
  }
  PrintLine(json.Finish());
}

void LiveJsonPrinter::Print(const TreeDescription& tree) {
  run_.Set(tree);
  has_state_ = false;
  PrintLine(EventJson(tree));
}

void LiveJsonPrinter::Print(const HistoryState& state) {
  run_.Set(state);
  if (state.cause == HistoryState::Cause::kKeyframe && has_state_) return;
  has_state_ = true;
  PrintLine(EventJson(run_.tree(), state));
}

void LiveJsonPrinter::Print(const TickEvents& events) {
  if (run_.state()) PrintLine(EventJson(TellTick(run_.tree(), *run_.state(), events)));
}

void LiveJsonPrinter::Print(const HistoryGap& gap) { PrintLine(EventJson(gap)); }
void LiveJsonPrinter::Print(const HistoryNote& note) { PrintLine(EventJson(note)); }
void LiveJsonPrinter::Print(const HistoryEnd& end) { PrintLine(EventJson(end)); }

void LiveJsonPrinter::Print(const LiveNotice& notice) {
  const DebugEvent& event = notice.event;
  JsonObject json;
  json.AddText("type", NameOf(event.kind));
  if (!notice.path.empty()) json.AddText("node", notice.path);
  if (event.stop.where == DebugStop::Where::kBefore) json.AddText("position", "before");
  if (event.stop.where == DebugStop::Where::kAfter) json.AddText("position", "after");
  if (event.stop.result != Status::kIdle) json.AddText("result", ToString(event.stop.result));
  if (event.stop.hook != kNoHook) json.Add("hook", std::uint64_t{event.stop.hook});
  if (!event.reason.empty()) json.AddText("text", event.reason);
  PrintLine(json.Finish());
}

void LiveJsonPrinter::Print(const std::vector<ForeignHook>& hooks) {
  const auto print = [](const ForeignHook& foreign) {
    return JsonObject()
        .AddText("node", foreign.hook.path)
        .AddText("text", ToString(foreign.hook))
        .AddBool("enabled", foreign.hook.enabled)
        .Finish();
  };
  PrintLine(
      JsonObject().AddText("type", "foreign_hooks").Add("hooks", JsonArray(hooks, print)).Finish());
}

}  // namespace coppice
