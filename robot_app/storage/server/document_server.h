// A database that keeps documents for good.
#ifndef COPPICE_ROBOT_APP_STORAGE_SERVER_DOCUMENT_SERVER_H_
#define COPPICE_ROBOT_APP_STORAGE_SERVER_DOCUMENT_SERVER_H_

#include <cstdint>
#include <string>

#include "robot_app/storage/messages/document.h"

namespace coppice::robot::storage {

struct StoreResult {
  enum class Answer : std::uint8_t {
    kStored,   ///< it has all of them, now or from an earlier time, and will keep them
    kAway,     ///< nobody knows whether it has any; ask again
    kRefused,  ///< it has none, and will not take them as they are
  };
  Answer answer = Answer::kStored;
  std::string problem = {};
};

class DocumentServer {
 public:
  virtual ~DocumentServer() = default;

  /// All or none. What the server has already, by robot, spool and number, is left as it is. One
  /// thread; may wait for the server until Abort.
  virtual StoreResult Store(const Batch& batch) = 0;

  /// Ends a Store that waits, with kAway. Any thread.
  virtual void Abort() = 0;
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SERVER_DOCUMENT_SERVER_H_
