// The node /store: listens to the topics of the configuration, whatever their types, and brings
// their messages into the spool and to the server. Once a second it says on /store/status and
// /diagnostics how it is; a store that hangs says nothing.
#ifndef COPPICE_ROBOT_APP_STORAGE_STORE_NODE_H_
#define COPPICE_ROBOT_APP_STORAGE_STORE_NODE_H_

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>

#include <memory>
#include <vector>

#include "robot_app/common/transforms/at_once_queue.h"
#include "robot_app/storage/config/store_config.h"
#include "robot_app/storage/server/shipper.h"
#include "robot_app/storage/spool/intake.h"
#include "robot_app/storage/store_status.h"
#include "robot_app/storage/topics/file_store.h"
#include "robot_app/storage/topics/topic_reader.h"

namespace coppice::robot::storage {

/// For the thread that spins. Messages are turned into documents by the threads that bring them.
class StoreNode {
 public:
  StoreNode(ros::NodeHandle& node, const StoreConfig& config, std::unique_ptr<Spool> spool,
            std::unique_ptr<DocumentServer> server);

 private:
  void Subscribe(ros::NodeHandle& node, TopicReader& reader);
  void Tell();

  const std::unique_ptr<Spool> spool_;
  const std::unique_ptr<DocumentServer> server_;
  FileStore files_;
  Shipper shipper_;
  Intake intake_;
  std::vector<std::unique_ptr<TopicReader>> readers_;
  AtOnceQueue at_once_;
  std::vector<ros::Subscriber> subscribers_;
  StoreStatus status_;
  std::uint64_t rounds_ = 0;  // of the intake, when it was seen to live the last time
  ros::Publisher status_publisher_, diagnostics_;
  ros::WallTimer timer_;
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_STORE_NODE_H_
