// The JSON face of `coppice replay`.
#include "bt_core/cli/replay/replay_printer.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

class JsonPrinter final : public ReplayPrinter {
 public:
  JsonPrinter(std::ostream& out, Time start) : out_(out), start_(start) {}

  void Tree(const TreeDescription& tree) override {
    JsonObject metadata;
    for (const auto& [key, value] : tree.info.metadata) metadata.AddText(key, value);
    Print(
        JsonObject()
            .AddText("type", "header")
            .AddText("writer", tree.writer)
            .AddText("run", ToString(tree.info.run))
            .AddText("clock", tree.info.clock)
            .AddText("tree", tree.main_tree)
            .Add("start_ns", std::to_string(start_.count()))
            .Add("metadata", metadata.Finish())
            .Add("files", JsonArray(tree.documents, [](const auto& d) { return JsonText(d.file); }))
            .Add("nodes", JsonArray(tree.nodes, [](const auto& n) { return JsonText(n.path); })));
  }

  void Tick(const PrintedTick& tick) override {
    const auto change = [](const PrintedTick::Change& c) {
      return JsonObject()
          .AddText("node", c.node)
          .AddText("from", ToString(c.from))
          .AddText("to", ToString(c.to))
          .Finish();
    };
    const auto write = [](const PrintedTick::Write& w) {
      JsonObject object;
      object.AddText("scope", w.scope).AddText("key", w.key);
      object.Add("value", ValueBytesToJson(w.value));
      if (!w.writer.empty()) object.AddText("by", w.writer);
      return object.Finish();
    };
    const auto message = [](const PrintedTick::Message& m) {
      return JsonObject().AddText("node", m.node).AddText("text", m.text).Finish();
    };
    Print(Begin("tick", tick.time)
              .Add("tick", tick.number)
              .AddText("result", ToString(tick.result))
              .Add("duration", JsonSeconds(tick.duration))
              .Add("changes", JsonArray(tick.changes, change))
              .Add("writes", JsonArray(tick.writes, write))
              .Add("messages", JsonArray(tick.messages, message)));
  }

  void Note(const HistoryNote& note) override {
    Print(Begin("note", note.time).AddText("kind", note.kind).AddText("text", note.text));
  }

  void Gap(const HistoryGap& gap) override {
    Print(Begin("gap", gap.time)
              .Add("lost_ticks", gap.lost_ticks)
              .Add("first_tick", gap.first_tick)
              .Add("last_tick", gap.last_tick)
              .Add("lost_notes", gap.lost_notes));
  }

  void End(const HistoryEnd& end) override { Print(Begin("end", end.time).Add("ticks", end.tick)); }

  void Summary(const ReplaySummary& summary) override {
    JsonObject nodes;
    for (const ReplaySummary::Node& node : summary.nodes) {
      if (node.successes + node.failures == 0) continue;
      nodes.Add(
          node.path,
          JsonObject().Add("successes", node.successes).Add("failures", node.failures).Finish());
    }
    Print(JsonObject()
              .AddText("type", "summary")
              .Add("ticks", summary.ticks)
              .Add("seconds", JsonSeconds(summary.duration))
              .Add("changes", summary.changes)
              .Add("writes", summary.writes)
              .Add("notes", summary.notes)
              .Add("gaps", summary.gaps)
              .Add("lost_ticks", summary.lost_ticks)
              .Add("lost_notes", summary.lost_notes)
              .Add("damages", summary.damages)
              .AddBool("closed", summary.closed)
              .Add("nodes", nodes.Finish()));
  }

 private:
  JsonObject Begin(std::string_view type, Time time) const {
    JsonObject object;
    object.AddText("type", type).Add("time", JsonSeconds(time - start_));
    return object;
  }
  void Print(const JsonObject& object) { out_ << object.Finish() << "\n"; }

  std::ostream& out_;
  const Time start_;
};

}  // namespace

std::unique_ptr<ReplayPrinter> MakeJsonPrinter(std::ostream& out, Time start) {
  return std::make_unique<JsonPrinter>(out, start);
}

}  // namespace coppice
