// A message as it is stored: with when and where it was heard, and a key of its own.
#ifndef COPPICE_ROBOT_APP_STORAGE_MESSAGES_DOCUMENT_H_
#define COPPICE_ROBOT_APP_STORAGE_MESSAGES_DOCUMENT_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace coppice::robot::storage {

/// The type of a message, as its connection describes it.
struct MessageType {
  std::string name;  ///< "sensor_msgs/LaserScan"
  std::string md5;
  std::string definition;
};

/// Robot, spool and number together are found once in the world: whoever gets a document twice can
/// tell.
struct Document {
  std::int64_t number = 0;    ///< in its spool, from 1; never given again
  int priority = 5;           ///< 0..9; 9 is sent first and lost last
  std::int64_t received = 0;  ///< wall time [ns since 1970]
  std::int64_t stamp = 0;     ///< ROS time when it came [ns]; simulated in a simulation
  std::string topic;
  std::shared_ptr<const MessageType> type;
  std::string json;
};

/// Messages of a topic that were given up, and why: counted since the spool was made.
struct Loss {
  std::string topic;
  std::string reason;
  std::int64_t count = 0;
  std::int64_t first = 0;  ///< when the first one and the last one were lost [ns since 1970]
  std::int64_t last = 0;
};

/// Documents that go to the server together.
struct Batch {
  std::string robot;
  std::string spool;
  std::vector<Document> documents;
  std::vector<Loss> losses;  ///< all of the spool
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_MESSAGES_DOCUMENT_H_
