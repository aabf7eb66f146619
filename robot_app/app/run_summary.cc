#include "robot_app/app/run_summary.h"

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "bt_core/data/value_bytes.h"
#include "bt_core/engine/events/status_follower.h"
#include "bt_core/record/record_cursor.h"

namespace coppice::robot {
namespace {

using leaves::RecoveryCount;
using leaves::RecoveryEvent;
using leaves::RecoveryPhase;

struct Kind {
  const char* name;
  const char* subject;
  const char* path;  // of the node in trees/monitor/monitor.xml
};
constexpr Kind kKinds[] = {
    {"restart node", "nodes", "as_published/restart_node/restart_nodes/restart"},
    {"restart node: ask", "nodes", "as_published/restart_node/restart_nodes/ask"},
    {"wait and retry", "navigation",
     "as_published/recover_navigation/free_navigation/wait_and_retry"},
    {"move backwards", "navigation",
     "as_published/recover_navigation/free_navigation/move_backwards"},
    {"navigation: ask", "navigation", "as_published/recover_navigation/free_navigation/ask"},
    {"slow rotate", "localization", "as_published/recover_localization/find_position/rotate"},
    {"restart and rotate", "localization",
     "as_published/recover_localization/find_position/restart_and_rotate"},
    {"localization: ask", "localization", "as_published/recover_localization/find_position/ask"},
};

std::optional<NodeIndex> FindNode(const RecordedEvents& recording, const std::string& path) {
  const auto& nodes = recording.tree.nodes;
  const auto found = std::find_if(nodes.begin(), nodes.end(),
                                  [&](const DescribedNode& node) { return node.path == path; });
  if (found == nodes.end()) return std::nullopt;
  return static_cast<NodeIndex>(found - nodes.begin());
}

int CountSuccesses(const RecordedEvents& recording, const std::string& path) {
  const std::optional<NodeIndex> node = FindNode(recording, path);
  int count = 0;
  for (const auto& [time, change] : recording.changes) {
    count += change.node == node && change.to == Status::kSuccess;
  }
  return count;
}

TickStatistics CountTicks(const RecordedEvents& recording) {
  const std::chrono::duration<double> time = recording.end - recording.begin;
  return {recording.ticks, recording.changes.size(), time.count()};
}

void AddOnce(std::vector<std::string>& texts, const std::string& text) {
  if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
}

// The text of the messages of all fault conditions.
std::vector<std::string> FaultsSeen(const RecordedEvents& monitor) {
  std::vector<std::string> faults;
  for (const NodeMessage& message : monitor.messages) {
    const std::string& id = monitor.tree.nodes[message.node].id;
    const bool is_fault = id.size() > 5 && id.compare(id.size() - 5, 5, "Fault") == 0;
    if (is_fault) AddOnce(faults, message.text);
  }
  return faults;
}

std::optional<leaves::Pose2D> PoseAt(const RecordedEvents& recording, Time time) {
  const auto after =
      std::upper_bound(recording.stays.begin(), recording.stays.end(), time,
                       [](Time one, const RecordedEvents::Stay& stay) { return one < stay.since; });
  if (after == recording.stays.begin()) return std::nullopt;
  return std::prev(after)->pose;
}

std::optional<RecoveryPhase> PhaseOf(const StatusChange& change) {
  if (change.to == Status::kRunning) return RecoveryPhase::kBegun;
  if (change.to == Status::kSuccess) return RecoveryPhase::kSucceeded;
  if (change.to == Status::kFailure) return RecoveryPhase::kFailed;
  if (change.from == Status::kRunning) return RecoveryPhase::kInterrupted;
  return std::nullopt;  // it has ended before
}

// What the nodes of the recoveries did, as they would have reported it.
std::vector<RecoveryEvent> RecoveryEvents(const RecordedEvents& monitor) {
  std::map<NodeIndex, const Kind*> kinds;
  for (const Kind& kind : kKinds) {
    if (const auto node = FindNode(monitor, kind.path)) kinds[*node] = &kind;
  }
  std::vector<RecoveryEvent> events;
  for (const auto& [time, change] : monitor.changes) {
    const auto kind = kinds.find(change.node);
    const std::optional<RecoveryPhase> phase = PhaseOf(change);
    if (kind == kinds.end() || !phase) continue;
    RecoveryEvent event{kind->second->name,
                        kind->second->subject,
                        RecoveryPhase::kBegun,
                        1,
                        time,
                        PoseAt(monitor, time),
                        ""};
    const bool ends_at_once = *phase != RecoveryPhase::kBegun && change.from != Status::kRunning;
    if (ends_at_once) events.push_back(event);
    event.phase = *phase;
    events.push_back(event);
  }
  return events;
}

void AddTick(const TickEvents& events, StatusFollower& follower, RecordedEvents& recording) {
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

// The slot that the robot's pose is fed into.
std::optional<std::size_t> PoseSlot(const TreeDescription& tree) {
  for (std::size_t slot = 0; slot < tree.slots.size(); ++slot) {
    const DescribedSlot& one = tree.slots[slot];
    if (one.has_key && one.name == "pose" && one.scope == tree.main_tree) return slot;
  }
  return std::nullopt;
}

void AddStay(const std::string& bytes, Time now, std::vector<RecordedEvents::Stay>& stays) {
  Value pose;
  const bool is_pose = ReadValueBytes(bytes, TypeOf<leaves::Pose2D>(), pose);
  if (is_pose) stays.push_back({now, pose.Get<leaves::Pose2D>()});
}

RecordedEvents ReadAll(const RecordReader& record) {
  RecordedEvents recording;
  recording.tree = record.tree();
  recording.begin = record.begin();
  recording.end = record.end();
  recording.ticks = record.last_tick();
  RecordCursor cursor(record);
  const std::optional<std::size_t> pose = PoseSlot(record.tree());
  std::string last_pose;
  StatusFollower follower(ShapeOf(record.tree()), cursor.state().statuses());
  for (RecordItem item = cursor.Next(); item != RecordItem::kNone; item = cursor.Next()) {
    if (item == RecordItem::kState) {  // behind a gap
      follower = StatusFollower(ShapeOf(cursor.tree()), cursor.state().statuses());
    }
    if (item == RecordItem::kTick) {
      const std::string now = pose ? cursor.state().values()[*pose] : "";
      if (now != last_pose) AddStay(now, cursor.events().start, recording.stays);
      last_pose = now;
      AddTick(cursor.events(), follower, recording);
    }
    if (item == RecordItem::kNote) recording.notes.push_back(cursor.note());
  }
  return recording;
}

std::optional<RecordedEvents> Read(const std::string& path, std::vector<std::string>& problems) {
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
    if (count.recovery == kind) return count;
  }
  return {kind};
}

RunSummary Summarize(const RecordedEvents& application, const RecordedEvents& monitor) {
  RunSummary summary;
  summary.rounds = CountSuccesses(application, "round");
  summary.stops = CountSuccesses(application, "patrol_round/stop");
  summary.docked = CountSuccesses(application, "go_home") > 0;
  for (const HistoryNote& note : monitor.notes) {
    if (note.text.rfind("fault injected", 0) == 0) AddOnce(summary.injected, note.text);
  }
  summary.faults = FaultsSeen(monitor);
  summary.recoveries = leaves::CountRecoveries(RecoveryEvents(monitor));
  summary.application = CountTicks(application);
  summary.monitor = CountTicks(monitor);
  return summary;
}

RunSummary SummarizeFiles(const std::string& application_record,
                          const std::string& monitor_record) {
  std::vector<std::string> problems;
  const std::optional<RecordedEvents> application = Read(application_record, problems);
  const std::optional<RecordedEvents> monitor = Read(monitor_record, problems);
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
  table << "\nrecovery              begun   succeeded   helped   helped strictly\n";
  for (const RecoveryCount& count : summary.recoveries) {
    table << std::left << std::setw(20) << count.recovery << std::right << std::setw(7)
          << count.begun << std::setw(12) << count.succeeded << std::setw(9) << count.helped
          << std::setw(18) << count.helped_strictly << "\n";
  }
  table << "helped: no other for it within 60 s (navigation: and 1 m); strictly: nor within 1 m\n";
  table << "\n"
        << Line("application     ", summary.application)
        << Line("monitor         ", summary.monitor);
  return table.str();
}

}  // namespace coppice::robot
