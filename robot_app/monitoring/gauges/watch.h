// What the monitors of nodes, topics and movement watch, as plain values.
#ifndef COPPICE_ROBOT_APP_MONITORING_GAUGES_WATCH_H_
#define COPPICE_ROBOT_APP_MONITORING_GAUGES_WATCH_H_

#include <string>
#include <vector>

#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {

struct NodeWatch {
  std::string node;
  int misses = 2;            ///< so many silent pings in a row are an error, fewer a warning
  bool is_optional = false;  ///< no fault while the supervisor does not run it
};

/// What is read of the messages of a topic. One that tells too little counts as none at all.
enum class Content {
  kAny,        ///< nothing
  kLaserScan,  ///< sensor_msgs/LaserScan by which the robot may move
  kRange,      ///< sensor_msgs/Range with a distance, or infinity if nothing is near
};

struct TopicWatch {
  std::string topic;
  std::string node;            ///< its publisher, to be restarted
  std::string kind = "topic";  ///< kind of monitor that its findings are said to be of
  Band band;                   ///< of the rate in Hz; staleness: no message for longer is an error
  Duration window{0};          ///< over which the rate is measured
  bool wall_time = false;      ///< rate, window and staleness in wall time instead of ROS time
  /// Not subscribed: the rate is taken from what the subscribers report on /statistics.
  bool by_statistics = false;
  Content content = Content::kAny;
  bool is_optional = false;  ///< no fault while the supervisor does not run the node
};

/// Who may speak on a topic.
struct PublisherWatch {
  std::string topic;
  std::vector<std::string> nodes;

  bool operator==(const PublisherWatch& other) const {
    return topic == other.topic && nodes == other.nodes;
  }
};

struct NavigationWatch {
  std::string topic;
  std::string node;       ///< the navigation server
  Duration blocked{0};    ///< BLOCKED for longer than this is an error
  Duration no_path{0};    ///< NO_PATH for longer than this is an error
  Duration staleness{0};  ///< no state for longer than this is an error of the topic
  /// A goal that failed is an error for so long while nobody tries again.
  Duration after_failure{0};
};

struct LocalizationWatch {
  std::string topic;
  std::string node;       ///< the localization
  Duration staleness{0};  ///< no state for longer than this is an error
  Band since_confirmed;   ///< s since the pose was last confirmed
  Band score;             ///< 0..1
  Band deviation;         ///< m
};

struct TransformWatch {
  std::string parent;  ///< frame
  std::string child;   ///< frame
  std::string node;    ///< to be restarted when it is too old; may be empty
  Band age;            ///< s, of the newest common time; staleness: it cannot be looked up
  Band jump;           ///< m between two looks, more than it can have driven
  double speed = 0;    ///< m/s, at which the child may move in the parent
};

struct LoggerWatch {
  std::string name;
  std::string path;       ///< file, folder or pattern that must grow; empty: `topic` is watched
  std::string topic;      ///< must report
  std::string node;       ///< to be restarted; may be empty
  Duration staleness{0};  ///< no growth or no message for longer than this is an error
};

/// What other programs say on /diagnostics.
struct DiagnosticsWatch {
  Duration staleness{0};  ///< a status that is not repeated for longer than this is STALE
};

struct SourceWatch {
  std::string source;     ///< node of a monitor
  Duration period{0};     ///< at which it reports
  std::string host = {};  ///< computer on which it runs; empty: this one
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_GAUGES_WATCH_H_
