#include "bt_core/live/status_board.h"

#include <chrono>
#include <cstddef>
#include <thread>

namespace coppice {
namespace {

constexpr std::uint8_t kWasReset = 10;

std::uint8_t Shown(const StatusChange& change) {
  if (change.to != Status::kIdle) return static_cast<std::uint8_t>(change.to);
  return static_cast<std::uint8_t>(kWasReset + static_cast<std::uint8_t>(change.from));
}

}  // namespace

StatusBoard::StatusBoard(const std::vector<Status>& statuses) : bytes_(statuses.size()) {
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    bytes_[i].store(static_cast<std::uint8_t>(statuses[i]), std::memory_order_relaxed);
  }
}

// A reader that sees one of the bytes also sees the odd version before it (release, acquire), so it
// knows that it read in between.
void StatusBoard::Apply(const std::vector<StatusChange>& changes) {
  if (changes.empty()) return;
  const std::uint32_t version = version_.load(std::memory_order_relaxed);
  version_.store(version + 1, std::memory_order_relaxed);
  for (const StatusChange& change : changes) {
    bytes_[change.node].store(Shown(change), std::memory_order_release);
  }
  version_.store(version + 2, std::memory_order_release);
}

bool StatusBoard::TryRead(std::vector<std::uint8_t>& out) const {
  const std::uint32_t before = version_.load(std::memory_order_acquire);
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    out[i] = bytes_[i].load(std::memory_order_acquire);
  }
  return before % 2 == 0 && before == version_.load(std::memory_order_relaxed);
}

// The pauses let a writer go on that was interrupted in the middle of its work.
void StatusBoard::Read(std::vector<std::uint8_t>& out) const {
  constexpr int kQuickAttempts = 100;
  constexpr int kPatientAttempts = 10000;
  constexpr std::chrono::microseconds kPause(100);
  out.resize(bytes_.size());
  for (int attempt = 0; attempt < kQuickAttempts; ++attempt) {
    if (TryRead(out)) return;
  }
  for (int attempt = 0; attempt < kPatientAttempts; ++attempt) {
    std::this_thread::sleep_for(kPause);
    if (TryRead(out)) return;
  }
}

}  // namespace coppice
