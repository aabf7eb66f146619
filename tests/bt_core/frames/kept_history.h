// A history as texts, which can be compared and printed.
#ifndef COPPICE_TESTS_BT_CORE_FRAMES_KEPT_HISTORY_H_
#define COPPICE_TESTS_BT_CORE_FRAMES_KEPT_HISTORY_H_

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "bt_core/data/value_bytes.h"
#include "bt_core/engine/events/event_stream.h"
#include "bt_core/frames/history.h"
#include "bt_core/frames/history_decoder.h"
#include "bt_core/frames/history_encoder.h"

namespace coppice {

inline std::string Describe(const Event& event) {
  const std::string index = std::to_string(event.index);
  switch (event.code) {
    case EventCode::kWrite:
      return " s" + index + "=" + PrintValueBytes(event.bytes) + " by " +
             (event.writer == kNoNode ? "?" : std::to_string(event.writer));
    case EventCode::kDelivery:
      return " inbox s" + index + "=" + PrintValueBytes(event.bytes);
    case EventCode::kText:
      return " n" + index + " says" + std::to_string(static_cast<int>(event.text)) + " " +
             std::string(event.bytes);
    default:
      return " n" + index + ":" + ToString(event.status());
  }
}

/// Durations in whole microseconds, as they are kept.
inline std::string Describe(const TickEvents& tick) {
  const auto duration = std::chrono::round<std::chrono::microseconds>(tick.duration);
  std::string text = "tick " + std::to_string(tick.tick) + " at " +
                     std::to_string(tick.start.time_since_epoch().count()) + " for " +
                     std::to_string(duration.count()) + " " + ToString(tick.result) +
                     (tick.is_whole ? "" : " part");
  EventReader reader(tick.words);
  for (Event event; reader.Next(event);) text += Describe(event);
  return text;
}

inline std::string DescribeState(std::uint64_t tick, Time time, const std::vector<Status>& statuses,
                                 const std::vector<std::string>& values) {
  std::string text =
      "state " + std::to_string(tick) + " at " + std::to_string(time.time_since_epoch().count());
  for (const Status status : statuses) text += std::string(" ") + ToString(status);
  for (const std::string& value : values) text += " " + PrintValueBytes(value);
  return text;
}

/// What the listeners of a stream get.
class KeptStream : public EventListener {
 public:
  void OnState(const StreamState& s) override {
    lines.push_back(DescribeState(s.tick, s.time, s.statuses, s.values));
  }
  void OnTick(const TickEvents& events) override {
    lines.push_back(Describe(events));
    ticks.push_back(lines.back());
  }
  std::vector<std::string> lines;
  std::vector<std::string> ticks;
};

/// What a decoder hands out. States that are there for reading only are left out, but the first.
class KeptHistory : public HistoryHandler {
 public:
  void OnTree(const TreeDescription& tree) override { trees.push_back(tree); }
  void OnState(const HistoryState& s) override {
    states.push_back(s);
    if (s.cause == HistoryState::Cause::kKeyframe && states.size() > 1) return;
    lines.push_back(DescribeState(s.tick, s.time, s.statuses, s.values));
  }
  void OnTick(const TickEvents& events) override { lines.push_back(Describe(events)); }
  void OnGap(const HistoryGap& gap) override {
    gaps.push_back(gap);
    lines.push_back("gap " + std::to_string(gap.lost_ticks) + " ticks " +
                    std::to_string(gap.first_tick) + "-" + std::to_string(gap.last_tick) + " " +
                    std::to_string(gap.lost_notes) + " notes");
  }
  void OnNote(const HistoryNote& note) override {
    lines.push_back("note " + std::to_string(note.time.time_since_epoch().count()) + " " +
                    note.kind + " " + note.text);
  }
  void OnEnd(const HistoryEnd& end) override { lines.push_back("end " + std::to_string(end.tick)); }
  std::vector<std::string> lines;
  std::vector<TreeDescription> trees;
  std::vector<HistoryState> states;
  std::vector<HistoryGap> gaps;
};

/// Keeps frames, whole.
class KeptFrames : public FrameSink {
 public:
  void OnFrame(const Frame& frame) override {
    frames.emplace_back(frame.data, frame.data + frame.size);
    types.push_back(frame.type);
    bytes += frame.size;
  }
  std::size_t Count(FrameType type) const {
    return static_cast<std::size_t>(std::count(types.begin(), types.end(), type));
  }
  /// Up to the first frame that cannot be decoded.
  Outcome DecodeAll(HistoryHandler& handler) const {
    HistoryDecoder decoder;
    for (const Bytes& frame : frames) {
      Outcome decoded = decoder.Decode(frame.data(), frame.size(), handler);
      if (!decoded) return decoded;
    }
    return {};
  }
  std::vector<Bytes> frames;
  std::vector<FrameType> types;
  std::size_t bytes = 0;
};

/// Encodes what it hears.
class EncodingListener : public EventListener {
 public:
  explicit EncodingListener(HistoryEncoder& encoder) : encoder_(encoder) {}
  void OnState(const StreamState& state) override { encoder_.Add(state); }
  void OnTick(const TickEvents& events) override { encoder_.Add(events); }

 private:
  HistoryEncoder& encoder_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_FRAMES_KEPT_HISTORY_H_
