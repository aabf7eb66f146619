// laser_driver: stands for the driver of a scanner that wedges. It passes the simulator's scans on
// (/simulation/scan to /scan) and answers every ping; on a signal it goes wrong, until it is
// started anew, as drivers do.
//   SIGUSR1  says nothing any more
//   SIGUSR2  one message of four
//   SIGRTMIN three copies of each message
//   SIGRTMIN + 1  the scans of a blind scanner: NaN on all beams
//   SIGHUP   burns a core beside its work, until the next SIGHUP
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <thread>

namespace {

volatile std::sig_atomic_t g_wrong = 0;  // the signal that came last
std::atomic<bool> g_burns{false};

void Burn() {
  while (true) {
    if (!g_burns) ros::WallDuration(0.01).sleep();
  }
}

sensor_msgs::LaserScan Seen(sensor_msgs::LaserScan scan) {
  if (g_wrong == SIGRTMIN + 1) scan.ranges.assign(scan.ranges.size(), NAN);
  return scan;
}

int Copies(unsigned count) {
  if (g_wrong == SIGUSR1) return 0;
  if (g_wrong == SIGUSR2) return count % 4 == 0 ? 1 : 0;
  return g_wrong == SIGRTMIN ? 3 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "laser_driver");
  for (const int signal : {SIGUSR1, SIGUSR2, SIGRTMIN, SIGRTMIN + 1}) {
    std::signal(signal, [](int which) { g_wrong = which; });
  }
  std::signal(SIGHUP, [](int) { g_burns = !g_burns; });
  std::thread(Burn).detach();
  ros::NodeHandle node;
  const ros::Publisher scan = node.advertise<sensor_msgs::LaserScan>("/scan", 10);
  unsigned count = 0;
  const ros::Subscriber raw = node.subscribe<sensor_msgs::LaserScan>(
      "/simulation/scan", 10, [&](const sensor_msgs::LaserScan::ConstPtr& message) {
        ++count;
        for (int i = Copies(count); i > 0; --i) scan.publish(Seen(*message));
      });
  ros::spin();
  return 0;
}
