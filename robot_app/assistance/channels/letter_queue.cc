#include "robot_app/assistance/channels/letter_queue.h"

#include <algorithm>
#include <utility>

namespace coppice::robot::assistance {

LetterQueue::LetterQueue(const std::vector<HumanSupervisor>& supervisors)
    : supervisors_(supervisors) {}

void LetterQueue::Add(Letter letter) {
  letter.number = ++last_number_;
  letter.way = 0;
  Entry entry;
  entry.letter = std::move(letter);
  letters_.emplace(last_number_, std::move(entry));
  const auto is_notice = [](const auto& one) {
    return one.second.letter.kind == Letter::Kind::kNotice;
  };
  const auto notices = std::count_if(letters_.begin(), letters_.end(), is_notice);
  if (notices <= static_cast<std::ptrdiff_t>(kMostNotices)) return;
  letters_.erase(std::find_if(letters_.begin(), letters_.end(), is_notice));
}

std::vector<Letter> LetterQueue::TakeDue(Time now) {
  std::vector<Letter> due;
  for (auto& [number, entry] : letters_) {
    if (entry.in_flight || entry.due > now) continue;
    entry.in_flight = true;
    due.push_back(entry.letter);
  }
  return due;
}

LetterQueue::Report LetterQueue::Delivered(std::uint32_t number, bool ok, Time now) {
  const auto found = letters_.find(number);
  if (found == letters_.end()) return {};
  Entry& entry = found->second;
  Report report{Progress::kDelivered, entry.letter};
  if (ok) {
    letters_.erase(found);
    return report;
  }
  entry.in_flight = false;
  if (++entry.letter.way < supervisors_[entry.letter.supervisor].ways.size()) {
    report.progress = Progress::kTryingNextWay;
    return report;
  }
  report.progress = Progress::kNoWayWorked;
  entry.letter.way = 0;
  entry.due = now + kRetryAfter;
  if (++entry.rounds >= kMostRounds) letters_.erase(found);
  return report;
}

void LetterQueue::DropIf(const std::function<bool(const Letter&)>& is_meant) {
  for (auto it = letters_.begin(); it != letters_.end();) {
    it = is_meant(it->second.letter) ? letters_.erase(it) : std::next(it);
  }
}

}  // namespace coppice::robot::assistance
