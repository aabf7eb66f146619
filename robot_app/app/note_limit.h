// Notes of others for the record of the trees: whoever publishes without end may not fill the disk.
#ifndef COPPICE_ROBOT_APP_APP_NOTE_LIMIT_H_
#define COPPICE_ROBOT_APP_APP_NOTE_LIMIT_H_

#include <cstddef>
#include <optional>
#include <string>

#include "bt_core/model/utf8.h"
#include "robot_app/common/web/rate_limit.h"

namespace coppice::robot {

class NoteLimit {
 public:
  static constexpr int kMostPerSecond = 5;
  static constexpr std::size_t kLongest = 1000;  ///< bytes

  /// The note as one line, cut where it is too long; nothing if there were too many. `now`: seconds
  /// of any clock that never goes back.
  std::optional<std::string> Pass(const std::string& note, double now) {
    if (!limit_.MayPass(now)) return std::nullopt;
    return PlainText(note, kLongest);
  }

 private:
  RateLimit limit_{kMostPerSecond};
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_NOTE_LIMIT_H_
