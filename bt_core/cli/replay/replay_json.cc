// The JSON face of `coppice replay`.
#include "bt_core/base/json.h"
#include "bt_core/cli/replay/replay_printer.h"

namespace coppice {
namespace {

class JsonPrinter final : public ReplayPrinter {
 public:
  explicit JsonPrinter(std::ostream& out) : out_(out) {}

  void Tree(const TreeDescription& tree) override { Print(EventJson(tree)); }
  void State(const TreeDescription& tree, const HistoryState& state) override {
    Print(EventJson(tree, state));
  }
  void Tick(const ToldTick& tick) override { Print(EventJson(tick)); }
  void Note(const HistoryNote& note) override { Print(EventJson(note)); }
  void Gap(const HistoryGap& gap) override { Print(EventJson(gap)); }
  void End(const HistoryEnd& end) override { Print(EventJson(end)); }

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
              .Add("nodes", nodes.Finish())
              .Finish());
  }

 private:
  void Print(const std::string& line) { out_ << line << "\n"; }

  std::ostream& out_;
};

}  // namespace

std::unique_ptr<ReplayPrinter> MakeJsonPrinter(std::ostream& out) {
  return std::make_unique<JsonPrinter>(out);
}

}  // namespace coppice
