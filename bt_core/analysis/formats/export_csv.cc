#include "bt_core/analysis/formats/export.h"
#include "bt_core/analysis/why/run_walk.h"
#include "bt_core/base/json.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

std::string Quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

class CsvWriter final : public RunVisitor {
 public:
  explicit CsvWriter(const Recording& run) : run_(run) {
    csv_ = "time,tick,kind,subject,from,to,by\r\n";
  }

  void OnSection(const TreeDescription& tree, const Recording::Section&) override { tree_ = &tree; }
  void OnTickBegin(const TickEvents& events) override { AddAsides(events.start); }
  void OnChange(const StatusChange& change, const TickEvents& events) override {
    Add(events.start, events.tick, "change", tree_->nodes[change.node].path, ToString(change.from),
        ToString(change.to), "");
  }
  void OnEvent(const Event& event, const TickEvents& events) override {
    if (event.code == EventCode::kWrite || event.code == EventCode::kDelivery) {
      const DescribedSlot& slot = tree_->slots[event.index];
      const bool is_known = event.writer < tree_->nodes.size();
      Add(events.start, events.tick, event.code == EventCode::kWrite ? "write" : "delivery",
          slot.has_key ? slot.scope + "{" + slot.name + "}" : slot.name, "",
          PrintValueBytes(event.bytes), is_known ? tree_->nodes[event.writer].path : "");
    } else if (event.code == EventCode::kText) {
      AddText(event, events);
    }
  }

  std::string Finish() {
    AddAsides(kNever);
    return std::move(csv_);
  }

 private:
  void AddText(const Event& event, const TickEvents& events) {
    const char* kind = "message";
    std::string text(event.bytes);
    if (event.text == EventText::kException) kind = "exception";
    if (event.text == EventText::kInjected) {
      kind = "injected";
      if (!text.empty()) text = ToString(static_cast<Status>(text[0]));
    }
    Add(events.start, events.tick, kind, tree_->nodes[event.index].path, "", text, "");
  }

  // Gaps and notes, in the order of their times.
  void AddAsides(Time until) {
    while (true) {
      const bool has_gap = gap_ < run_.gaps().size() && run_.gaps()[gap_].gap.time <= until;
      const bool has_note = note_ < run_.notes().size() && run_.notes()[note_].note.time <= until;
      if (!has_gap && !has_note) return;
      if (has_gap && (!has_note || run_.gaps()[gap_].gap.time < run_.notes()[note_].note.time)) {
        AddGap(run_.gaps()[gap_++].gap);
      } else {
        AddNote(run_.notes()[note_++].note);
      }
    }
  }

  void AddGap(const HistoryGap& gap) {
    Add(gap.time, gap.last_tick, "gap", "", "", std::to_string(gap.lost_ticks) + " ticks", "");
  }

  void AddNote(const HistoryNote& note) { Add(note.time, 0, "note", note.kind, "", note.text, ""); }

  void Add(Time time, std::uint64_t tick, const char* kind, std::string_view subject,
           std::string_view from, std::string_view to, std::string_view by) {
    csv_ += JsonSeconds(time - run_.start()) + "," + std::to_string(tick) + "," + kind + "," +
            Quoted(subject) + "," + Quoted(from) + "," + Quoted(to) + "," + Quoted(by) + "\r\n";
  }

  const Recording& run_;
  const TreeDescription* tree_ = nullptr;
  std::size_t gap_ = 0;
  std::size_t note_ = 0;
  std::string csv_;
};

}  // namespace

std::string ToCsv(const Recording& run) {
  CsvWriter writer(run);
  WalkRun(run, writer);
  return writer.Finish();
}

}  // namespace coppice
