// Whether a service may be asked: one that has failed is left alone for a while, so that only the
// first visitor waits for it.
#ifndef COPPICE_ROBOT_APP_SPEECH_ENDPOINT_SERVICE_PAUSE_H_
#define COPPICE_ROBOT_APP_SPEECH_ENDPOINT_SERVICE_PAUSE_H_

#include <atomic>
#include <chrono>

#include "robot_app/speech/endpoint/speech_service.h"

namespace coppice::robot::speech {

/// Any thread.
class ServicePause {
 public:
  static constexpr std::chrono::seconds kPause{30};

  bool may_be_asked() const { return Now() >= until_; }
  void Failed() { until_ = Now() + std::chrono::nanoseconds(kPause).count(); }

 private:
  static std::int64_t Now() {
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  std::atomic<std::int64_t> until_{0};
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_ENDPOINT_SERVICE_PAUSE_H_
