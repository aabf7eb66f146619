#include "bt_core/cli/replay_printer.h"

#include <algorithm>
#include <cstdio>

namespace coppice {
namespace {

std::string Seconds(Time time) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6f", static_cast<double>(time.count()) * 1e-9);
  return text;
}

class TextPrinter final : public ReplayPrinter {
 public:
  TextPrinter(std::ostream& out, const RecordHeader& header) : out_(out), header_(header) {}

  void Header(const RecordHeader& header) override {
    out_ << "tree " << header.main_tree << ": " << header.nodes.size() << " nodes, "
         << header.slots.size() << " slots\n";
    for (const RecordedDocument& document : header.documents) {
      out_ << "file " << document.file << "\n";
    }
    out_ << "recorded by " << header.writer << ", start " << Seconds(header.start)
         << " s of the tree's clock\n";
    for (const auto& [key, value] : header.metadata) out_ << key << ": " << value << "\n";
    out_ << "\n";
  }

  void Entry(const RecordedTick& tick) override {
    const std::string when = At(tick.time) + "tick " + std::to_string(tick.tick) + "  ";
    for (const RecordedWrite& write : tick.writes) {
      const RecordedSlot& slot = header_.slots[write.slot];
      out_ << when << slot.scope << "{" << slot.key << "} = " << write.value.value_or("(no value)")
           << "\n";
    }
    for (const StatusChange& change : tick.changes) {
      out_ << when << header_.nodes[change.node].path << "  " << ToString(change.from) << " -> "
           << ToString(change.to) << "\n";
    }
    for (const NodeMessage& message : tick.messages) {
      out_ << when << header_.nodes[message.node].path << ": " << message.text << "\n";
    }
  }

  void Entry(const RecordedNote& note) override {
    out_ << At(note.time) << "note [" << note.kind << "] " << note.text << "\n";
  }

  void Entry(const RecordedGap& gap) override {
    out_ << At(gap.time) << "GAP: " << gap.lost_ticks << " ticks";
    if (gap.lost_ticks > 0) out_ << " (" << gap.first_tick << " to " << gap.last_tick << ")";
    out_ << " and " << gap.lost_notes << " notes are missing\n";
  }

  void Entry(const RecordedEnd& end) override {
    out_ << At(end.time) << "end of the record, after tick " << end.ticks << "\n";
  }

  void Damage(const RecordDamage& damage) override {
    out_ << "DAMAGE at byte " << damage.offset << ": " << damage.what << "\n";
  }

  void Summary(const ReplaySummary& summary) override {
    out_ << "\n"
         << summary.ticks << " ticks with events in " << Seconds(summary.last - summary.first)
         << " s: " << summary.changes << " changes, " << summary.writes << " writes, "
         << summary.notes << " notes\n";
    for (std::size_t i = 0; i < summary.nodes.size(); ++i) {
      const ReplaySummary::Node& node = summary.nodes[i];
      if (node.successes + node.failures == 0) continue;
      out_ << "  " << header_.nodes[i].path << ": " << node.successes << " successes, "
           << node.failures << " failures\n";
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
    const std::string seconds = Seconds(time - header_.start);
    return std::string(seconds.size() < 14 ? 14 - seconds.size() : 0, ' ') + seconds + "  ";
  }

  std::ostream& out_;
  const RecordHeader& header_;
};

}  // namespace

ReplaySummary::ReplaySummary(const RecordHeader& header)
    : nodes(header.nodes.size()), first(header.start), last(header.start) {}

void ReplaySummary::Add(const RecordEntry& entry) {
  last = std::max(last, std::visit([](const auto& e) { return e.time; }, entry));
  if (const auto* tick = std::get_if<RecordedTick>(&entry)) {
    ++ticks;
    changes += tick->changes.size();
    writes += tick->writes.size();
    for (const StatusChange& change : tick->changes) {
      nodes[change.node].successes += change.to == Status::kSuccess;
      nodes[change.node].failures += change.to == Status::kFailure;
    }
  } else if (std::holds_alternative<RecordedNote>(entry)) {
    ++notes;
  } else if (const auto* gap = std::get_if<RecordedGap>(&entry)) {
    ++gaps;
    lost_ticks += gap->lost_ticks;
    lost_notes += gap->lost_notes;
  }
}

std::unique_ptr<ReplayPrinter> MakeTextPrinter(std::ostream& out, const RecordHeader& header) {
  return std::make_unique<TextPrinter>(out, header);
}

}  // namespace coppice
