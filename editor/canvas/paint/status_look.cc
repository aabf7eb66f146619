#include "editor/canvas/paint/status_look.h"

#include <algorithm>
#include <cmath>

#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr double kPulseSeconds = 0.8;
constexpr double kFlashSeconds = 0.4;
constexpr double kFadeSeconds = 2;
constexpr double kTrail = 0.45;

double AgeOf(const NodeState& state, Time now) {
  return std::chrono::duration<double>(now - state.since).count();
}

}  // namespace

bool IsTrail(const NodeState& state) {
  return state.status == Status::kIdle && state.before != Status::kIdle;
}

bool WasHalted(const NodeState& state) {
  return state.status == Status::kIdle && state.before == Status::kRunning;
}

Color StatusColor(const Palette& palette, const NodeState& state, Color at_rest) {
  if (WasHalted(state)) return palette.halted;
  if (state.status != Status::kIdle) return palette.Of(state.status);
  return state.before != Status::kIdle ? palette.Of(state.before) : at_rest;
}

const char* StatusGlyph(const NodeState& state) {
  if (WasHalted(state)) return icon::kStop;
  return GlyphOf(IsTrail(state) ? state.before : state.status);
}

float StatusStrength(const NodeState& state, Time now) {
  if (!IsTrail(state)) return 1;
  const double age = state.since == Time{} ? kFadeSeconds : AgeOf(state, now);
  return static_cast<float>(1 - (1 - kTrail) * std::clamp(age / kFadeSeconds, 0.0, 1.0));
}

float FlashStrength(const NodeState& state, Time now) {
  const double age = AgeOf(state, now) / kFlashSeconds;
  if (state.since == Time{} || age < 0 || age >= 1) return 0;
  return static_cast<float>((1 - age) * (1 - age));
}

float Pulse(const Ui& ui) {
  if (!ui.moves()) return 0.5F;
  const double phase = std::fmod(ui.now, kPulseSeconds) / kPulseSeconds * 6.283185307;
  return static_cast<float>(0.5 + 0.5 * std::sin(phase));
}

bool IsFading(const NodeState& state, Time now) {
  if (state.since == Time{}) return false;
  return AgeOf(state, now) < (IsTrail(state) ? kFadeSeconds : kFlashSeconds);
}

Color HeatColor(const Palette& palette, float heat) {
  const float t = std::clamp(heat, 0.0F, 1.0F);
  // Through magenta: amber is what runs.
  const Color warm = palette.is_dark ? 0xFF8A3CC0 : 0xFF8030B0;
  const Color hot = palette.is_dark ? 0xFFF4DCFF : 0xFF300048;
  return t < 0.5F ? Mix(palette.node_border, warm, t * 2) : Mix(warm, hot, t * 2 - 1);
}

}  // namespace coppice::editor
