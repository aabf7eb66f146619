// Who asks too often waits, or is refused.
#ifndef COPPICE_ROBOT_APP_COMMON_WEB_RATE_LIMIT_H_
#define COPPICE_ROBOT_APP_COMMON_WEB_RATE_LIMIT_H_

#include <algorithm>

namespace coppice::robot {

/// At most so many in a second, with as many at once.
class RateLimit {
 public:
  explicit RateLimit(int per_second) : per_second_(per_second), left_(per_second) {}
  /// Seconds of any clock that never goes back.
  bool MayPass(double now) {
    left_ = std::min(per_second_, left_ + (now - last_) * per_second_);
    last_ = now;
    if (left_ < 1) return false;
    left_ -= 1;
    return true;
  }

 private:
  const double per_second_;
  double left_;
  double last_ = 0;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_WEB_RATE_LIMIT_H_
