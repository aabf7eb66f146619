#include "robot_app/app/run_summary.h"

#include <algorithm>
#include <iomanip>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "bt_core/engine/events/status_follower.h"
#include "bt_core/record/record_cursor.h"

namespace coppice::robot {
namespace {

constexpr Duration kSuccessWindow = std::chrono::seconds(60);

struct Kind {
  const char* name;
  const char* path;  // of the node in trees/monitor/monitor.xml
};
constexpr Kind kKinds[] = {
    {"restart node", "as_published/restart_node/restart_nodes/restart"},
    {"restart node: ask", "as_published/restart_node/restart_nodes/ask"},
    {"wait and retry", "as_published/recover_navigation/free_navigation/wait_and_retry"},
    {"move backwards", "as_published/recover_navigation/free_navigation/move_backwards"},
    {"navigation: ask", "as_published/recover_navigation/free_navigation/ask"},
    {"slow rotate", "as_published/recover_localization/find_position/rotate"},
    {"restart and rotate", "as_published/recover_localization/find_position/restart_and_rotate"},
    {"localization: ask", "as_published/recover_localization/find_position/ask"},
};

// One activation of a recovery.
struct Activation {
  std::size_t kind;
  Time start;
  std::optional<Time> end;
  bool ended_well = false;
};

std::optional<NodeIndex> FindNode(const Recording& recording, const std::string& path) {
  const auto& nodes = recording.tree.nodes;
  const auto found = std::find_if(nodes.begin(), nodes.end(),
                                  [&](const DescribedNode& node) { return node.path == path; });
  if (found == nodes.end()) return std::nullopt;
  return static_cast<NodeIndex>(found - nodes.begin());
}

int CountSuccesses(const Recording& recording, const std::string& path) {
  const std::optional<NodeIndex> node = FindNode(recording, path);
  int count = 0;
  for (const auto& [time, change] : recording.changes) {
    count += change.node == node && change.to == Status::kSuccess;
  }
  return count;
}

TickStatistics CountTicks(const Recording& recording) {
  const std::chrono::duration<double> time = recording.end - recording.begin;
  return {recording.ticks, recording.changes.size(), time.count()};
}

void AddOnce(std::vector<std::string>& texts, const std::string& text) {
  if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
}

// The text of the messages of all fault conditions.
std::vector<std::string> FaultsSeen(const Recording& monitor) {
  std::vector<std::string> faults;
  for (const NodeMessage& message : monitor.messages) {
    const std::string& id = monitor.tree.nodes[message.node].id;
    const bool is_fault = id.size() > 5 && id.compare(id.size() - 5, 5, "Fault") == 0;
    if (is_fault) AddOnce(faults, message.text);
  }
  return faults;
}

std::vector<Activation> Activations(const Recording& monitor) {
  std::vector<std::optional<NodeIndex>> nodes;
  for (const Kind& kind : kKinds) nodes.push_back(FindNode(monitor, kind.path));
  std::vector<Activation> activations;
  const auto apply = [&](Time time, const StatusChange& change) {
    for (std::size_t kind = 0; kind < nodes.size(); ++kind) {
      if (nodes[kind] != change.node) continue;
      const bool was_active = change.from == Status::kRunning;
      if (!was_active && change.to != Status::kIdle) activations.push_back({kind, time, {}, false});
      if (change.to == Status::kRunning || activations.empty()) continue;
      if (!was_active && change.to == Status::kIdle) continue;
      activations.back().end = time;
      activations.back().ended_well = change.to == Status::kSuccess;
    }
  };
  for (const auto& [time, change] : monitor.changes) apply(time, change);
  return activations;
}

std::vector<RecoveryCount> CountRecoveries(const Recording& monitor) {
  std::vector<RecoveryCount> counts;
  for (const Kind& kind : kKinds) counts.push_back({kind.name, 0, 0, 0});
  const std::vector<Activation> activations = Activations(monitor);
  for (std::size_t i = 0; i < activations.size(); ++i) {
    const Activation& one = activations[i];
    RecoveryCount& count = counts[one.kind];
    ++count.started;
    count.ended_well += one.ended_well;
    const bool last = i + 1 == activations.size();
    const bool quiet =
        last || activations[i + 1].start - one.end.value_or(one.start) > kSuccessWindow;
    count.successful += one.ended_well && quiet;
  }
  return counts;
}

void AddTick(const TickEvents& events, StatusFollower& follower, Recording& recording) {
  EventReader reader(events.words);
  for (Event event; reader.Next(event);) {
    follower.Apply(event, [&](const StatusChange& change) {
      recording.changes.push_back({events.start, change});
    });
  }
  for (NodeMessage& message : MessagesOf(events.words)) {
    recording.messages.push_back(std::move(message));
  }
}

Recording ReadAll(const RecordReader& record) {
  Recording recording;
  recording.tree = record.tree();
  recording.begin = record.begin();
  recording.end = record.end();
  recording.ticks = record.last_tick();
  RecordCursor cursor(record);
  StatusFollower follower(ShapeOf(record.tree()), cursor.state().statuses());
  for (RecordItem item = cursor.Next(); item != RecordItem::kNone; item = cursor.Next()) {
    if (item == RecordItem::kState) {  // behind a gap
      follower = StatusFollower(ShapeOf(cursor.tree()), cursor.state().statuses());
    }
    if (item == RecordItem::kTick) AddTick(cursor.events(), follower, recording);
    if (item == RecordItem::kNote) recording.notes.push_back(cursor.note());
  }
  return recording;
}

std::optional<Recording> Read(const std::string& path, std::vector<std::string>& problems) {
  Diagnostics diagnostics;
  const std::unique_ptr<RecordReader> record = RecordReader::Open(path, diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.all()) problems.push_back(ToString(diagnostic));
  if (!record) return std::nullopt;
  for (const RecordDamage& damage : record->damages()) {
    problems.push_back(path + " at byte " + std::to_string(damage.offset) + ": " + damage.what);
  }
  if (!record->closed()) problems.push_back(path + " was not closed in order");
  return ReadAll(*record);
}

std::string Line(const std::string& label, const TickStatistics& statistics) {
  std::ostringstream text;
  text << label << statistics.ticks << " ticks in " << std::fixed << std::setprecision(0)
       << statistics.seconds << " s, " << statistics.status_changes << " changes of status\n";
  return text.str();
}

}  // namespace

RecoveryCount RunSummary::Recovery(const std::string& kind) const {
  for (const RecoveryCount& count : recoveries) {
    if (count.kind == kind) return count;
  }
  return {kind, 0, 0, 0};
}

RunSummary Summarize(const Recording& application, const Recording& monitor) {
  RunSummary summary;
  summary.rounds = CountSuccesses(application, "round");
  summary.stops = CountSuccesses(application, "patrol_round/stop");
  summary.docked = CountSuccesses(application, "go_home") > 0;
  for (const HistoryNote& note : monitor.notes) {
    if (note.text.rfind("fault injected", 0) == 0) AddOnce(summary.injected, note.text);
  }
  summary.faults = FaultsSeen(monitor);
  summary.recoveries = CountRecoveries(monitor);
  summary.application = CountTicks(application);
  summary.monitor = CountTicks(monitor);
  return summary;
}

RunSummary SummarizeFiles(const std::string& application_record,
                          const std::string& monitor_record) {
  std::vector<std::string> problems;
  const std::optional<Recording> application = Read(application_record, problems);
  const std::optional<Recording> monitor = Read(monitor_record, problems);
  RunSummary summary;
  if (application && monitor) summary = Summarize(*application, *monitor);
  summary.problems = problems;
  return summary;
}

std::string ToTable(const RunSummary& summary, double distance) {
  std::ostringstream table;
  table << "rounds          " << summary.rounds << "\n"
        << "places reached  " << summary.stops << "\n"
        << "came home       " << (summary.docked ? "yes" : "no") << "\n"
        << "distance        " << std::fixed << std::setprecision(1) << distance << " m\n";
  for (const std::string& fault : summary.injected) table << "injected        " << fault << "\n";
  for (const std::string& fault : summary.faults) table << "monitors saw    " << fault << "\n";
  table << "\nrecovery              started   ended well   no other within 60 s\n";
  for (const RecoveryCount& count : summary.recoveries) {
    if (count.started == 0) continue;
    table << std::left << std::setw(22) << count.kind << std::right << std::setw(7) << count.started
          << std::setw(13) << count.ended_well << std::setw(23) << count.successful << "\n";
  }
  table << "\n"
        << Line("application     ", summary.application)
        << Line("monitor         ", summary.monitor);
  return table.str();
}

}  // namespace coppice::robot
