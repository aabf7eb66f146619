// Turns the messages of one topic into documents, as its configuration says: no more than `rate` a
// second, long arrays left out or kept in files.
#ifndef COPPICE_ROBOT_APP_STORAGE_TOPICS_TOPIC_READER_H_
#define COPPICE_ROBOT_APP_STORAGE_TOPICS_TOPIC_READER_H_

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "bt_core/base/outcome.h"
#include "robot_app/storage/config/store_config.h"
#include "robot_app/storage/messages/message_to_json.h"
#include "robot_app/storage/spool/intake.h"
#include "robot_app/storage/topics/file_store.h"

namespace coppice::robot::storage {

/// A message as it came.
struct HeardMessage {
  const std::string& type;
  const std::string& md5;
  const std::string& definition;
  std::string_view bytes;
  std::int64_t received = 0;  ///< wall time [ns since 1970]
  std::int64_t stamp = 0;     ///< ROS time [ns]
};

/// A topic has one type, and a few more while its programs are exchanged.
inline constexpr int kMostTypes = 16;

/// For one thread.
class TopicReader {
 public:
  /// Intake and files must live longer.
  TopicReader(TopicConfig config, Intake& intake, FileStore& files);

  /// A message that cannot be understood is counted as lost, with the reason.
  void OnMessage(const HeardMessage& message);

  const std::string& topic() const { return config_.topic; }

 private:
  bool IsDue(std::int64_t now);
  Outcome Learn(const HeardMessage& message);
  Outcome Remember(const HeardMessage& message);
  JsonRules RulesAt(std::int64_t now);

  const TopicConfig config_;
  Intake& intake_;
  FileStore& files_;
  std::int64_t due_ = 0;  // the next one is stored from then on [ns]
  int types_ = 0;         // there have been so far
  std::shared_ptr<const MessageType> type_;
  Expected<MessageLayout> layout_ = MessageLayout();  // of the type
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_TOPICS_TOPIC_READER_H_
