#include "bt_core/cli/replay/replay_printer.h"

#include <cstdio>

#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

std::string Seconds(Duration time) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6f", static_cast<double>(time.count()) * 1e-9);
  return text;
}

std::string Printed(const std::string& value) {
  return FormOfValue(value) == ValueForm::kEmpty ? "(no value)" : PrintValueBytes(value);
}

const char* PrefixOf(EventText kind) {
  if (kind == EventText::kException) return "threw: ";
  return kind == EventText::kInjected ? "injected " : "";
}

class TextPrinter final : public ReplayPrinter {
 public:
  TextPrinter(std::ostream& out, Time start) : out_(out), start_(start) {}

  void Tree(const TreeDescription& tree) override {
    out_ << "tree " << tree.main_tree << ": " << tree.nodes.size() << " nodes, "
         << tree.slots.size() << " slots\n";
    for (const DescribedDocument& document : tree.documents) {
      out_ << "file " << document.file << "\n";
    }
    out_ << "recorded by " << tree.writer << ", start " << Seconds(start_.time_since_epoch())
         << " s of the tree's clock\n";
    for (const auto& [key, value] : tree.info.metadata) out_ << key << ": " << value << "\n";
    out_ << "\n";
  }

  void Tick(const ToldTick& tick) override {
    const std::string when = At(tick.time) + "tick " + std::to_string(tick.number) + "  ";
    for (const ToldTick::Write& write : tick.writes) {
      out_ << when << write.scope << "{" << write.key << "} = " << Printed(write.value)
           << (write.writer.empty() ? "" : "  by " + write.writer) << "\n";
    }
    for (const ToldTick::Change& change : tick.changes) {
      out_ << when << change.node << "  " << ToString(change.from) << " -> " << ToString(change.to)
           << "\n";
    }
    for (const ToldTick::Message& message : tick.messages) {
      out_ << when << message.node << ": " << PrefixOf(message.kind) << message.text << "\n";
    }
  }

  void Note(const HistoryNote& note) override {
    out_ << At(note.time) << "note [" << note.kind << "] " << note.text << "\n";
  }

  void Gap(const HistoryGap& gap) override {
    out_ << At(gap.time) << "GAP: " << gap.lost_ticks << " ticks";
    if (gap.lost_ticks > 0) out_ << " (" << gap.first_tick << " to " << gap.last_tick << ")";
    out_ << " and " << gap.lost_notes << " notes are missing\n";
  }

  void End(const HistoryEnd& end) override {
    out_ << At(end.time) << "end of the record, after tick " << end.tick << "\n";
  }

  void Summary(const ReplaySummary& summary) override {
    out_ << "\n"
         << summary.ticks << " ticks with events in " << Seconds(summary.duration)
         << " s: " << summary.changes << " changes, " << summary.writes << " writes, "
         << summary.notes << " notes\n";
    for (const ReplaySummary::Node& node : summary.nodes) {
      if (node.successes + node.failures == 0) continue;
      out_ << "  " << node.path << ": " << node.successes << " successes, " << node.failures
           << " failures\n";
    }
    if (summary.gaps > 0) {
      out_ << summary.gaps << " gaps: " << summary.lost_ticks << " ticks and " << summary.lost_notes
           << " notes are missing\n";
    }
    if (summary.damages > 0) out_ << summary.damages << " damaged places\n";
    if (!summary.closed) out_ << "not closed: the recording ended abruptly or still goes on\n";
  }

 private:
  std::string At(Time time) const {
    const std::string seconds = Seconds(time - start_);
    return std::string(seconds.size() < 14 ? 14 - seconds.size() : 0, ' ') + seconds + "  ";
  }

  std::ostream& out_;
  const Time start_;
};

}  // namespace

std::unique_ptr<ReplayPrinter> MakeTextPrinter(std::ostream& out, Time start) {
  return std::make_unique<TextPrinter>(out, start);
}

}  // namespace coppice
