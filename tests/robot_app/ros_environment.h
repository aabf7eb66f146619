// A ROS master of its own for a test program, on a free port, with this process as a node of it.
//
// Include it in one source file of a test program; every test then finds ROS up. The master ends
// with the process.
#ifndef COPPICE_TESTS_ROBOT_APP_ROS_ENVIRONMENT_H_
#define COPPICE_TESTS_ROBOT_APP_ROS_ENVIRONMENT_H_

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

#include "robot_app/app/child_process.h"
#include "tests/robot_app/eventually.h"

namespace coppice::robot {

/// A TCP port on loopback that nobody uses now.
inline int FreePort() {
  const int socket_fd = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  if (bind(socket_fd, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      getsockname(socket_fd, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    throw std::runtime_error("no free port");
  }
  close(socket_fd);
  return ntohs(address.sin_port);
}

class RosEnvironment : public testing::Environment {
 public:
  void SetUp() override {
    setenv("ROS_IP", "127.0.0.1", 1);
    for (int i = 0; i < 5 && !StartMaster(); ++i) {
    }
    int no_arguments = 0;
    ros::init(no_arguments, nullptr, "coppice_test",
              ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
    if (!Eventually([] { return ros::master::check(); })) {
      throw std::runtime_error("rosmaster does not answer");
    }
    ros::start();
    spinner_ = std::make_unique<ros::AsyncSpinner>(2);
    spinner_->start();
  }

  void TearDown() override {
    spinner_->stop();
    ros::shutdown();
    master_.Stop(std::chrono::seconds(5));
  }

 private:
  // False if another program was faster to take the port.
  bool StartMaster() {
    const int port = FreePort();
    const std::string number = std::to_string(port);
    setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + number).c_str(), 1);
    master_ = ChildProcess({"/usr/bin/rosmaster", "--core", "-p", number},
                           testing::TempDir() + "rosmaster_" + number + ".log");
    Eventually([&] { return IsListening(port) || !master_.IsRunning(); });
    return master_.IsRunning();
  }

  static bool IsListening(int port) {
    const int socket_fd = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const bool connected =
        connect(socket_fd, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0;
    close(socket_fd);
    return connected;
  }

  ChildProcess master_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
};

inline testing::Environment* const kRosEnvironment =
    testing::AddGlobalTestEnvironment(new RosEnvironment);

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_ROBOT_APP_ROS_ENVIRONMENT_H_
