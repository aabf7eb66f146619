#include "bt_core/frames/pause_note.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace coppice {
namespace {

constexpr std::int64_t kSecond = 1'000'000;  // in microseconds
constexpr std::int64_t kMostSeconds = std::int64_t{10} * 365 * 86'400;
constexpr Time kLastTime = Time::max() - std::chrono::seconds(kMostSeconds);

}  // namespace

HistoryNote NoteOf(const Pause& pause) {
  const std::int64_t stood =
      std::chrono::round<std::chrono::microseconds>(pause.to - pause.from).count();
  char text[48];
  std::snprintf(text, sizeof text, "%lld.%06lld s", static_cast<long long>(stood / kSecond),
                static_cast<long long>(stood % kSecond));
  return {pause.from, kPauseKind, text};
}

std::optional<Pause> PauseOf(const HistoryNote& note) {
  if (note.kind != kPauseKind) return std::nullopt;
  const double seconds = std::strtod(note.text.c_str(), nullptr);
  const bool is_time = seconds >= 0 && seconds <= kMostSeconds && note.time <= kLastTime;
  if (!is_time) return std::nullopt;
  const auto stood = std::chrono::microseconds(std::llround(seconds * kSecond));
  const Pause pause{note.time, note.time + stood};
  if (NoteOf(pause).text != note.text) return std::nullopt;
  return pause;
}

}  // namespace coppice
