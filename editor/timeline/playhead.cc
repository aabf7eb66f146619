#include "editor/timeline/playhead.h"

#include <algorithm>

namespace coppice::editor {

std::size_t Playhead::tick() const {
  if (run_.size() == 0) return 0;
  return is_at_now_ ? run_.size() - 1 : std::min(tick_, run_.size() - 1);
}

Time Playhead::time() const {
  if (run_.size() == 0) return Time{};
  return is_playing_ ? time_ : run_.TimeOf(tick());
}

void Playhead::GoToTick(std::size_t tick) {
  is_playing_ = false;
  is_at_now_ = tick >= run_.size();
  tick_ = tick;
}

void Playhead::GoToTime(Time time) {
  if (run_.size() > 0) GoToTick(run_.TickAt(time));
}

void Playhead::GoToNow() {
  is_playing_ = false;
  is_at_now_ = true;
}

void Playhead::Hold() {
  if (run_.size() > 0) GoToTick(tick());
}

void Playhead::Step(int ticks) {
  if (run_.size() == 0 || (is_at_now_ && ticks > 0)) return;
  const std::size_t from = tick();
  const auto back = static_cast<std::size_t>(-std::min(ticks, 0));
  GoToTick(ticks < 0 ? from - std::min(from, back) : from + static_cast<std::size_t>(ticks));
}

void Playhead::StepToChange(NodeIndex node, bool forward) {
  if (run_.size() == 0) return;
  const Tracks& tracks = run_.TracksAt(tick());
  if (node >= tracks.shape().size()) return;
  const Lane& lane = tracks.LaneOf(node);
  const std::size_t to = forward ? lane.NextChange(tick()) : lane.ChangeBefore(tick());
  if (to != tick() && to < run_.size()) GoToTick(to);
}

void Playhead::Play() {
  if (run_.size() == 0) return;
  const bool at_end = tick() + 1 == run_.size();
  GoToTick(at_end ? 0 : tick());
  time_ = run_.TimeOf(tick_);
  is_playing_ = true;
}

void Playhead::Advance(double seconds) {
  if (!is_playing_) return;
  time_ += Duration(static_cast<Duration::rep>(seconds * speed_ * 1e9));
  tick_ = run_.TickAt(time_);
  if (time_ >= run_.TimeOf(run_.size() - 1)) GoToNow();
}

void Playhead::SetSpeed(double speed) { speed_ = std::clamp(speed, 0.1, 32.0); }

}  // namespace coppice::editor
