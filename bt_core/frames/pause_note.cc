#include "bt_core/frames/pause_note.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

namespace coppice {
namespace {

constexpr std::int64_t kSecond = 1'000'000;  // in microseconds
constexpr std::int64_t kMostSeconds = std::int64_t{10} * 365 * 86'400;
constexpr Time kLastTime = Time::max() - std::chrono::seconds(kMostSeconds);

std::string SecondsOf(Duration duration) {
  const std::int64_t stood = std::chrono::round<std::chrono::microseconds>(duration).count();
  char text[48];
  std::snprintf(text, sizeof text, "%lld.%06lld s", static_cast<long long>(stood / kSecond),
                static_cast<long long>(stood % kSecond));
  return text;
}

// Of "2.500000 s" and what follows; nothing if it is no duration that a run can have.
std::optional<Duration> ReadSeconds(const char* text) {
  const double seconds = std::strtod(text, nullptr);
  if (!(seconds >= 0 && seconds <= kMostSeconds)) return std::nullopt;
  return std::chrono::microseconds(std::llround(seconds * kSecond));
}

}  // namespace

HistoryNote NoteOf(const Pause& pause) {
  std::string text = SecondsOf(pause.to - pause.from);
  if (pause.tick > 0) {
    text += ", " + SecondsOf(pause.of_tick) + " of tick " + std::to_string(pause.tick);
  }
  return {pause.from, kPauseKind, std::move(text)};
}

std::optional<Pause> PauseOf(const HistoryNote& note) {
  if (note.kind != kPauseKind || note.time > kLastTime) return std::nullopt;
  const std::optional<Duration> stood = ReadSeconds(note.text.c_str());
  if (!stood) return std::nullopt;
  Pause pause{note.time, note.time + *stood};
  if (const std::size_t comma = note.text.find(", "); comma != std::string::npos) {
    const std::size_t tick = note.text.rfind(' ') + 1;
    pause.tick = std::strtoull(note.text.c_str() + tick, nullptr, 10);
    pause.of_tick = ReadSeconds(note.text.c_str() + comma + 2).value_or(Duration(0));
  }
  if (NoteOf(pause).text != note.text) return std::nullopt;
  return pause;
}

}  // namespace coppice
