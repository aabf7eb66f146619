#include "editor/live/run_log.h"

#include <algorithm>
#include <utility>

#include "bt_core/analysis/play/played_value.h"
#include "bt_core/data/value_bytes.h"
#include "bt_core/live/debug/hook_condition.h"
#include "bt_core/live/debug/scope_keys.h"

namespace coppice::editor {
namespace {

// The slot of the record that a name means at a node: of a port, or else of a key; kNoSlot: none.
SlotIndex SlotOf(const RecordedTree& tree, NodeIndex node, const std::string& name) {
  for (const DescribedPort& port : tree.description->nodes[node].ports) {
    if (port.name == name) return port.slot;
  }
  if (!tree.program) return kNoSlot;
  const SlotIndex slot = FindKey(*tree.program, tree.program->info[node].scope, name);
  return slot == kNoSlot ? kNoSlot : tree.recorded_slots[slot];
}

}  // namespace

struct RunLog::Watch {
  // What stands in the text: words, and behind them a value.
  struct Piece {
    std::string words;
    SlotIndex slot = kNoSlot;
    bool has_value = false;
  };

  std::uint32_t point = 0;
  NodeIndex node{0};
  std::uint32_t from_hit = 1;
  std::vector<Piece> pieces;
  bool has_condition = false;
  std::optional<Script> condition;

  void ReadText(const RecordedTree& tree, const std::string& text) {
    std::size_t at = 0;
    for (;;) {
      const std::size_t open = text.find('{', at);
      const std::size_t close = open == std::string::npos ? open : text.find('}', open);
      if (close == std::string::npos) break;
      pieces.push_back({text.substr(at, open - at),
                        SlotOf(tree, node, text.substr(open + 1, close - open - 1)), true});
      at = close + 1;
    }
    pieces.push_back({text.substr(at), kNoSlot, false});
  }

  std::string Print(const std::vector<std::string>& values) const {
    std::string text;
    for (const Piece& piece : pieces) {
      text += piece.words;
      if (!piece.has_value) continue;
      const bool known =
          piece.slot < values.size() && FormOfValue(values[piece.slot]) != ValueForm::kEmpty;
      text += known ? PrintValueBytes(values[piece.slot]) : "?";
    }
    return text;
  }
};

RunLog::RunLog() = default;
RunLog::~RunLog() = default;
RunLog::RunLog(RunLog&&) noexcept = default;
RunLog& RunLog::operator=(RunLog&&) noexcept = default;

void RunLog::Update(const Run& run, const std::string& name, const LogPoints& points,
                    std::size_t most_ticks) {
  if (run_ != &run || version_ != points.version()) Restart(run, name, points);
  if (!is_wanted_) return;
  for (std::size_t i = 0; i < most_ticks && next_ < run.size(); ++i, ++next_) {
    EnterSections(run);
    if (follower_) Look(run, run.recording().EventsOf(next_));
  }
  while (lines_.size() > kMostLines) lines_.pop_front();
}

void RunLog::Restart(const Run& run, const std::string& name, const LogPoints& points) {
  *this = RunLog();
  run_ = &run;
  version_ = points.version();
  for (const LogPoint& point : points.all()) {
    if (point.enabled && (point.run.empty() || point.run == name)) points_.push_back(point);
  }
  is_wanted_ = !points_.empty();
}

void RunLog::EnterSections(const Run& run) {
  const auto& sections = run.recording().sections();
  for (; section_ < sections.size() && sections[section_].first_tick <= next_; ++section_) {
    const Recording::Section& section = sections[section_];
    if (!tree_ || tree_number_ != section.tree) {
      tree_number_ = section.tree;
      EnterTree(run.recording().trees()[section.tree]);
      follower_.emplace(tree_->shape, section.state);
    } else if (!FollowsOn(section)) {
      follower_->Set(section.state);
    }
  }
}

void RunLog::EnterTree(const TreeDescription& tree) {
  Diagnostics ignored;  // without a program there are no conditions and no keys, only ports
  tree_ = CompileRecorded(tree, std::make_shared<Registry>(), ignored);
  watches_.clear();
  is_watched_.assign(tree.nodes.size(), false);
  for (NodeIndex node{0}; node < tree.nodes.size(); ++node) {
    for (const LogPoint& point : points_) {
      if (point.path != tree.nodes[node].path) continue;
      Watch watch;
      watch.point = point.number;
      watch.node = node;
      watch.from_hit = point.from_hit;
      watch.ReadText(*tree_, point.text);
      watch.has_condition = !point.condition.empty();
      if (watch.has_condition) {
        Expected<Script> condition = Problem{"the tree cannot be compiled here"};
        if (tree_->program) {
          const ScopeIndex scope = tree_->program->info[node].scope;
          condition = CompileCondition(point.condition, *tree_->program, scope);
        }
        if (!condition) problems_[point.number] = condition.problem();
        if (condition) watch.condition = *std::move(condition);
      }
      watches_.push_back(std::move(watch));
      is_watched_[node] = true;
    }
  }
}

void RunLog::Look(const Run&, const TickEvents& events) {
  if (watches_.empty()) return follower_->Apply(events);
  follower_->Apply(
      events, [](const StatusChange&) {},
      [&](const Event& event) {
        const bool is_seen =
            event.is_result() && event.index < is_watched_.size() && is_watched_[event.index];
        if (is_seen) OnResult(event, next_);
      });
}

void RunLog::OnResult(const Event& event, std::size_t tick) {
  const Status status = event.status();
  if (status == Status::kRunning && follower_->status(event.node()) == Status::kRunning) return;
  for (Watch& watch : watches_) {
    if (watch.node != event.node() || !IsHit(watch)) continue;
    lines_.push_back({tick, event.node(), tree_->PathOf(event.node()), status,
                      watch.Print(follower_->values())});
  }
}

bool RunLog::IsHit(Watch& watch) {
  if (watch.has_condition) {
    if (!watch.condition) return false;
    Blackboard blackboard = MakeBlackboard(tree_->program->layout);
    for (const SlotIndex slot : watch.condition->reads()) {
      const SlotIndex recorded = tree_->recorded_slots[slot];
      if (recorded == kNoSlot) continue;
      blackboard[slot].value =
          PlayedValue(follower_->values()[recorded], tree_->program->layout.slots[slot].type);
    }
    try {
      if (!watch.condition->Test(blackboard)) return false;
    } catch (const ScriptError& error) {
      problems_[watch.point] = error.what();
      return false;
    }
  }
  return ++hits_[watch.point] >= watch.from_hit;
}

std::uint32_t RunLog::HitsOf(std::uint32_t point) const {
  const auto at = hits_.find(point);
  return at == hits_.end() ? 0 : at->second;
}

std::string RunLog::ProblemOf(std::uint32_t point) const {
  const auto at = problems_.find(point);
  return at == problems_.end() ? "" : at->second;
}

}  // namespace coppice::editor
