// Where in a run the user looks: at now, or at a tick of the past, or moving along as it happened.
#ifndef COPPICE_EDITOR_TIMELINE_PLAYHEAD_H_
#define COPPICE_EDITOR_TIMELINE_PLAYHEAD_H_

#include <cstddef>

#include "editor/timeline/run.h"

namespace coppice::editor {

class Playhead {
 public:
  /// The run must live longer.
  explicit Playhead(const Run& run) : run_(run) {}

  /// Glued to the end: what comes is shown at once.
  bool is_at_now() const { return is_at_now_; }
  /// The tick that is shown; 0 if there is none yet.
  std::size_t tick() const;
  /// The moment that is shown: between two ticks while it plays.
  Time time() const;

  /// Beyond the last tick it is glued to now. Ends playing, as all functions but Play do.
  void GoToTick(std::size_t tick);
  /// The tick of that time.
  void GoToTime(Time time);
  void GoToNow();
  /// Lets go of the end without going away.
  void Hold();
  /// By so many ticks. Forward from the last one: to now.
  void Step(int ticks);
  /// To the next or the previous tick in which the node's lane changes.
  void StepToChange(NodeIndex node, bool forward);

  bool is_playing() const { return is_playing_; }
  /// From the shown tick on; from the beginning if it is the last one.
  void Play();
  void Stop() { is_playing_ = false; }
  /// Moves on by seconds of the user, times the speed. At the end it is glued to now.
  void Advance(double seconds);

  /// How many times faster than it happened, from 1/10 to 32.
  double speed() const { return speed_; }
  void SetSpeed(double speed);

 private:
  const Run& run_;
  bool is_at_now_ = true;
  bool is_playing_ = false;
  std::size_t tick_ = 0;
  Time time_{};  // while it plays
  double speed_ = 1;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_PLAYHEAD_H_
