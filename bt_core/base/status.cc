#include "bt_core/base/status.h"

namespace coppice {

const char* ToString(Status status) {
  switch (status) {
    case Status::kIdle:
      return "IDLE";
    case Status::kRunning:
      return "RUNNING";
    case Status::kSuccess:
      return "SUCCESS";
    case Status::kFailure:
      return "FAILURE";
    case Status::kSkipped:
      return "SKIPPED";
  }
  return "?";
}

}  // namespace coppice
