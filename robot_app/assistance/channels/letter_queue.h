// Letters on their way: each is tried by every way of its supervisor, one after the other, and
// again after a while. Decides only; whoever sends them tells it what came of it. Time is handed
// in. Not for several threads.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_LETTER_QUEUE_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_LETTER_QUEUE_H_

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "robot_app/assistance/help_request.h"

namespace coppice::robot::assistance {

class LetterQueue {
 public:
  static constexpr Duration kRetryAfter = std::chrono::seconds(30);
  static constexpr int kMostRounds = 20;  ///< through all ways; then a letter is dropped
  static constexpr std::size_t kMostNotices = 100;

  explicit LetterQueue(const std::vector<HumanSupervisor>& supervisors);

  /// Due at once. The number of the letter is chosen here. Of too many notices the oldest goes.
  void Add(Letter letter);

  /// Those to be sent now, each by its way. Each must be reported to Delivered.
  std::vector<Letter> TakeDue(Time now);

  enum class Progress { kDelivered, kTryingNextWay, kNoWayWorked, kUnknown };
  struct Report {
    Progress progress = Progress::kUnknown;
    Letter letter;  ///< of a known one
  };
  /// What came of a letter. If no way worked it is tried again later, unless it is dropped.
  Report Delivered(std::uint32_t number, bool ok, Time now);

  void Drop(std::uint32_t number) { letters_.erase(number); }
  /// Forgets the letters that are meant; of those on their way no report is awaited any more.
  void DropIf(const std::function<bool(const Letter&)>& is_meant);

 private:
  struct Entry {
    Letter letter;
    bool in_flight = false;
    Time due{};
    int rounds = 0;
  };

  const std::vector<HumanSupervisor>& supervisors_;
  std::map<std::uint32_t, Entry> letters_;
  std::uint32_t last_number_ = 0;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_CHANNELS_LETTER_QUEUE_H_
