#include "robot_app/storage/store_node.h"

#include <topic_tools/shape_shifter.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>

namespace coppice::robot::storage {
namespace {

using topic_tools::ShapeShifter;

constexpr int kQueue = 1000;  // nothing waits there: messages are taken at once

ShipperOptions OptionsOf(const StoreConfig& config) {
  ShipperOptions options;
  options.robot = config.robot;
  return options;
}

// What WriteTo wants of a stream of roscpp: here the message's own bytes, copied once.
class Bytes {
 public:
  explicit Bytes(std::string& bytes) : bytes_(bytes) {}
  std::uint8_t* advance(std::size_t size) {
    bytes_.resize(size);
    return reinterpret_cast<std::uint8_t*>(bytes_.data());
  }

 private:
  std::string& bytes_;
};

diagnostic_msgs::DiagnosticStatus ToMessage(const StatusLine& line) {
  diagnostic_msgs::DiagnosticStatus status;
  status.name = "coppice_store: " + line.name;
  status.level = static_cast<decltype(status.level)>(line.level);
  status.message = line.message;
  for (const auto& [key, value] : line.values) {
    status.values.emplace_back();
    status.values.back().key = key;
    status.values.back().value = value;
  }
  return status;
}

}  // namespace

StoreNode::StoreNode(ros::NodeHandle& node, const StoreConfig& config, std::unique_ptr<Spool> spool,
                     std::unique_ptr<DocumentServer> server)
    : spool_(std::move(spool)),
      server_(std::move(server)),
      files_(config.folder + "/files", config.largest_files),
      shipper_(*spool_, *server_, OptionsOf(config)),
      intake_(*spool_, {config.largest_intake, config.period}, [this] { shipper_.Wake(); }) {
  status_publisher_ = node.advertise<diagnostic_msgs::DiagnosticArray>("/store/status", 1);
  diagnostics_ = node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1);
  for (const TopicConfig& topic : config.topics) {
    readers_.push_back(std::make_unique<TopicReader>(topic, intake_, files_));
    Subscribe(node, *readers_.back());
  }
  timer_ =
      node.createWallTimer(ros::WallDuration(1), [this](const ros::WallTimerEvent&) { Tell(); });
}

void StoreNode::Subscribe(ros::NodeHandle& node, TopicReader& reader) {
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const ShapeShifter::ConstPtr&>(
      reader.topic(), kQueue, [&reader](const ShapeShifter::ConstPtr& message) {
        std::string bytes;
        Bytes stream(bytes);
        message->write(stream);
        reader.OnMessage({message->getDataType(), message->getMD5Sum(),
                          message->getMessageDefinition(), bytes,
                          static_cast<std::int64_t>(ros::WallTime::now().toNSec()),
                          static_cast<std::int64_t>(ros::Time::now().toNSec())});
      });
  options.callback_queue = &at_once_;
  subscribers_.push_back(node.subscribe(options));
}

// A monitor that hears nothing has the store restarted; so it speaks only while its thread works.
void StoreNode::Tell() {
  shipper_.Watch();
  StoreState state{intake_.Look(), {}, shipper_.Look()};
  try {
    state.backlog = spool_->Look();
  } catch (const std::runtime_error& damage) {
    state.intake.problem = damage.what();
  }
  if (std::exchange(rounds_, state.intake.rounds) == state.intake.rounds) return;
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = ros::Time::now();
  for (const StatusLine& line : status_.Judge(state, std::chrono::system_clock::now())) {
    message.status.push_back(ToMessage(line));
  }
  status_publisher_.publish(message);
  diagnostics_.publish(message);
}

}  // namespace coppice::robot::storage
