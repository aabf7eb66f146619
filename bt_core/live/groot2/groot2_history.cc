#include "bt_core/live/groot2/groot2_history.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <nlohmann/json.hpp>

#include "bt_core/base/json_library.h"
#include "bt_core/data/value.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

constexpr std::size_t kBytesPerStatus = 3;
constexpr std::size_t kBytesPerTransition = 9;
constexpr std::uint8_t kWasOffset = 10;  // added to the last status of an idle node
constexpr Duration kPauseBetweenTicks = std::chrono::milliseconds(2);
// BehaviorTree.CPP keeps so many transitions and drops older ones without a word.
constexpr std::size_t kRecordingLimit = 1000;

std::uint64_t ReadLittleEndian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = count; i-- > 0;) {
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return number;
}

// True if it is one.
bool ReadStatus(std::uint8_t byte, Status& status) {
  if (byte > kWasOffset) byte = byte <= kWasOffset + 4 ? 0 : byte;
  if (byte > static_cast<std::uint8_t>(Status::kSkipped)) return false;
  status = static_cast<Status>(byte);
  return true;
}

std::string ValueBytesOf(const nlohmann::json& json) {
  std::string bytes;
  if (json.is_null()) return bytes;
  if (json.is_boolean()) {
    AppendValueBytes(Value(json.get<bool>()), bytes);
  } else if (json.is_number_unsigned()) {
    AppendValueBytes(Value(json.get<std::uint64_t>()), bytes);
  } else if (json.is_number_integer()) {
    AppendValueBytes(Value(json.get<std::int64_t>()), bytes);
  } else if (json.is_number()) {
    AppendValueBytes(Value(json.get<double>()), bytes);
  } else if (json.is_string()) {
    AppendValueBytes(Value(json.get<std::string>()), bytes);
  } else {
    bytes += static_cast<char>(ValueForm::kJson);
    bytes += json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  return bytes;
}

}  // namespace

Outcome Groot2History::SetTree(const RunId& id, std::string xml) {
  Diagnostics diagnostics;
  RobotTree tree = ReadRobotTree(std::move(xml), endpoint_, diagnostics);
  if (tree.uids.empty()) {
    return Problem{"the robot sent a tree that cannot be read: " + diagnostics.ToString()};
  }
  tree_ = std::move(tree);
  tree_.description.info.run = id;
  tree_.description.info.clock = "wall";
  tree_.description.info.metadata.emplace_back(kChangesOnly);
  id_ = id;
  follower_.reset();
  recording_.reset();
  shown_.clear();
  slots_.clear();
  name_bytes_ = 0;
  values_.clear();
  value_bytes_ = 0;
  words_.Clear();
  tick_ = 0;
  return {};
}

Outcome Groot2History::SetRecording(std::string_view text) {
  std::int64_t microseconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), microseconds);
  if (error != std::errc() || end != text.data() + text.size() || microseconds < 0 ||
      microseconds > Duration::max().count() / 2000) {
    return Problem{"the robot sent a time that cannot be read: \"" + std::string(text) + "\""};
  }
  recording_ = Time(std::chrono::microseconds(microseconds));
  return {};
}

Outcome Groot2History::AddTransitions(std::string_view bytes) {
  if (!recording_ || !follower_) return {};
  if (bytes.size() % kBytesPerTransition != 0) {
    return Problem{"the robot sent transitions that cannot be read"};
  }
  if (bytes.size() / kBytesPerTransition == kRecordingLimit) has_lost_ = true;
  Time start{};
  Time last{};
  for (std::size_t at = 0; at < bytes.size(); at += kBytesPerTransition) {
    const Time time = *recording_ + std::chrono::microseconds(ReadLittleEndian(bytes, at, 6));
    const auto uid = static_cast<std::uint16_t>(ReadLittleEndian(bytes, at + 6, 2));
    Status status = Status::kIdle;
    const NodeIndex node = tree_.Find(uid);
    if (node == kNoNode || !ReadStatus(static_cast<std::uint8_t>(bytes[at + 8]), status)) {
      return Problem{"the robot sent a transition that cannot be read"};
    }
    if (!words_.empty() && time - last > kPauseBetweenTicks) TellTick(start, last - start);
    if (words_.empty()) start = time;
    last = time;
    AddEvent(node, status);
  }
  if (!words_.empty()) TellTick(start, last - start);
  return {};
}

Outcome Groot2History::AddStatuses(std::string_view bytes, Time now) {
  if (bytes.size() % kBytesPerStatus != 0) {
    return Problem{"the robot sent statuses that cannot be read"};
  }
  std::vector<Status> statuses(tree_.uids.size(), Status::kIdle);
  for (std::size_t at = 0; at < bytes.size(); at += kBytesPerStatus) {
    const NodeIndex node = tree_.Find(static_cast<std::uint16_t>(ReadLittleEndian(bytes, at, 2)));
    if (node == kNoNode || !ReadStatus(static_cast<std::uint8_t>(bytes[at + 2]), statuses[node])) {
      return Problem{"the robot sent a status that cannot be read"};
    }
  }
  if (!follower_) {
    Begin(statuses, now);
  } else if (has_lost_) {
    TellLoss(statuses, now);
  } else {
    Correct(statuses, now);
  }
  shown_ = std::move(statuses);
  return {};
}

void Groot2History::Begin(const std::vector<Status>& statuses, Time now) {
  tree_.description.info.start = recording_.value_or(now);
  tree_.description.info.wall_start = WallTime(tree_.description.info.start.time_since_epoch());
  follower_.emplace(ShapeOf(tree_.description), statuses);
  listener_.OnTree(tree_.description);
  TellState(HistoryState::Cause::kBegin, now);
}

void Groot2History::TellState(HistoryState::Cause cause, Time now) {
  HistoryState state;
  state.cause = cause;
  state.tick = tick_;
  state.time = now;
  state.statuses = follower_->statuses();
  for (NodeIndex i{0}; i < tree_.uids.size(); ++i) state.last.push_back(follower_->last(i));
  state.values = values_;
  listener_.OnState(state);
}

void Groot2History::TellTick(Time start, Duration duration) {
  const Duration whole = std::max(duration, Duration(0));  // the robot's clock may be set back
  listener_.OnTick({++tick_, start, whole, follower_->status(kRootNode), true, words_.words()});
  words_.Clear();
}

// How many ticks were lost the protocol does not say.
void Groot2History::TellLoss(const std::vector<Status>& statuses, Time now) {
  has_lost_ = false;
  HistoryGap gap;
  gap.cause = HistoryGap::Cause::kOutput;
  gap.time = now;
  gap.first_tick = gap.last_tick = ++tick_;
  gap.lost_ticks = 1;
  listener_.OnGap(gap);
  follower_.emplace(ShapeOf(tree_.description), statuses);
  TellState(HistoryState::Cause::kLost, now);
}

void Groot2History::AddEvent(NodeIndex node, Status status) {
  Event event;
  event.code = static_cast<EventCode>(status);
  event.index = node;
  follower_->Apply(event);
  if (status == Status::kIdle) {
    words_.Reset(node);
  } else {
    words_.Status(node, status);
  }
}

// Statuses are a little newer than the transitions before them, so a difference counts only if it
// is still there in the next answer. Without a recording there is nothing to wait for.
void Groot2History::Correct(const std::vector<Status>& statuses, Time now) {
  for (NodeIndex i{0}; i < statuses.size(); ++i) {
    const bool lasts = !recording_ || (i < shown_.size() && shown_[i] == statuses[i]);
    if (lasts && follower_->status(i) != statuses[i]) AddEvent(i, statuses[i]);
  }
  if (!words_.empty()) TellTick(now, Duration(0));
}

Outcome Groot2History::AddBoards(std::string_view message_pack, Time now) {
  const nlohmann::json all = ReadLimitedMessagePack(message_pack);
  if (all.is_discarded()) return Problem{"the robot sent a blackboard that cannot be read"};
  if (!all.is_object()) return {};  // there are no values
  const std::size_t slots_before = values_.size();
  std::vector<SlotIndex> changed;
  for (const auto& [board, entries] : all.items()) {
    if (!entries.is_object()) continue;
    for (const auto& [key, value] : entries.items()) {
      const std::optional<SlotIndex> slot = SlotOf(board, key);
      if (slot && SetValue(*slot, ValueBytesOf(value))) changed.push_back(*slot);
    }
  }
  if (!follower_) return {};
  if (values_.size() != slots_before) {
    listener_.OnTree(tree_.description);
    TellState(HistoryState::Cause::kJump, now);
    return {};
  }
  if (changed.empty()) return {};
  for (const SlotIndex slot : changed) {
    words_.Add(EventCode::kWrite, slot, kNoNode, values_[slot]);
  }
  listener_.OnTick({tick_, now, Duration(0), Status::kIdle, true, words_.words()});
  words_.Clear();
  return {};
}

// The robot makes keys while it runs. Nothing for one that there is no room for.
std::optional<SlotIndex> Groot2History::SlotOf(const std::string& board, const std::string& key) {
  const auto keys = slots_.find(board);
  if (keys != slots_.end()) {
    const auto at = keys->second.find(key);
    if (at != keys->second.end()) return at->second;
  }
  const std::size_t bytes = board.size() + key.size();
  if (values_.size() >= kMostKeys || name_bytes_ + bytes > kMostNameBytes) return std::nullopt;
  name_bytes_ += bytes;
  const auto slot = static_cast<SlotIndex>(values_.size());
  slots_[board].emplace(key, slot);
  tree_.description.slots.push_back({board, key, "any", true});
  values_.emplace_back();
  return slot;
}

// True if it is another one. What is too long beside the others is not known.
bool Groot2History::SetValue(SlotIndex slot, std::string value) {
  std::string& known = values_[slot];
  if (value_bytes_ - known.size() + value.size() > kMostValueBytes) value.clear();
  if (known == value) return false;
  value_bytes_ += value.size() - known.size();
  known = std::move(value);
  return true;
}

}  // namespace coppice
