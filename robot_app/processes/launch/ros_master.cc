#include "robot_app/processes/launch/ros_master.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <thread>

namespace coppice::robot::processes {
namespace {

constexpr char kHost[] = "127.0.0.1";
constexpr Duration kAnswerTime = std::chrono::seconds(1);
constexpr Duration kPause = std::chrono::milliseconds(20);

// Above the usual ports of services (ROS 11311), below ip_local_port_range of Linux.
constexpr int kFirstPort = 12000;
constexpr int kLastPort = 32000;
constexpr int kMostTries = 1000;

sockaddr_in Local(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

bool SomebodyListens(int port) {
  const int connection = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const sockaddr_in address = Local(port);
  const bool connected =
      connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  close(connection);
  return connected;
}

bool IsFree(int port) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;  // what somebody else has closed just now is free
  setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  const sockaddr_in address = Local(port);
  const bool bound =
      bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  close(listener);
  return bound;
}

}  // namespace

std::string RosMaster::Uri() const {
  return "http://" + address.host + ":" + std::to_string(address.port);
}

int FreePort(int in_a_row) {
  std::random_device chance;
  std::uniform_int_distribution<int> ports(kFirstPort, kLastPort - in_a_row + 1);
  for (int i = 0; i < kMostTries; ++i) {
    const int first = ports(chance);
    int free = 0;
    while (free < in_a_row && IsFree(first + free)) ++free;
    if (free == in_a_row) return first;
  }
  return 0;
}

namespace {

Expected<RosMaster> StartMaster(int port, ProcessLauncher& launcher, Duration timeout) {
  ProcessConfig config;
  config.name = "rosmaster";
  config.command = {"/usr/bin/rosmaster", "--core", "-p", std::to_string(port)};
  config.log = "rosmaster.log";
  const Expected<int> pid = launcher.Start(config);
  if (!pid) return Problem{pid.problem()};
  const RosMaster master{{kHost, port}, *pid};

  const auto give_up = std::chrono::steady_clock::now() + timeout;
  while (std::chrono::steady_clock::now() < give_up) {
    if (waitpid(master.pid, nullptr, WNOHANG) == master.pid) {
      return Problem{"rosmaster ended at once; see rosmaster.log"};
    }
    if (MasterAnswers(master.address, kAnswerTime)) return master;
    std::this_thread::sleep_for(kPause);
  }
  launcher.Signal(master.pid, SIGKILL);
  waitpid(master.pid, nullptr, 0);
  return Problem{"rosmaster does not answer at port " + std::to_string(port)};
}

}  // namespace

Expected<RosMaster> FindOrStartMaster(int port, ProcessLauncher& launcher, Duration timeout) {
  if (port != 0 && SomebodyListens(port)) {
    if (MasterAnswers({kHost, port}, kAnswerTime)) return RosMaster{{kHost, port}};
    return Problem{"port " + std::to_string(port) +
                   " is in use by something that is no ROS master"};
  }
  if (port != 0) return StartMaster(port, launcher, timeout);
  // A port that was free just now may be somebody else's when rosmaster, which then hangs, wants
  // it.
  constexpr int kPorts = 3;
  Expected<RosMaster> master = StartMaster(FreePort(), launcher, timeout / kPorts);
  for (int i = 1; i < kPorts && !master; ++i) {
    master = StartMaster(FreePort(), launcher, timeout / kPorts);
  }
  return master;
}

}  // namespace coppice::robot::processes
