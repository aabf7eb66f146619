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
#include <cstdlib>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "robot_app/app/child_process.h"

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

/// Looks again and again, at most that long in real time, whether something has come true.
inline bool Eventually(const std::function<bool()>& predicate, double seconds = 10) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!predicate()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

class RosEnvironment : public testing::Environment {
 public:
  void SetUp() override {
    const std::string port = std::to_string(FreePort());
    setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + port).c_str(), 1);
    setenv("ROS_IP", "127.0.0.1", 1);
    master_ = ChildProcess({"/usr/bin/rosmaster", "--core", "-p", port},
                           testing::TempDir() + "rosmaster_" + port + ".log");
    int no_arguments = 0;
    ros::init(no_arguments, nullptr, "coppice_test",
              ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
    if (!Eventually([] { return ros::master::check(); }, 20)) {
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
  ChildProcess master_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
};

inline testing::Environment* const kRosEnvironment =
    testing::AddGlobalTestEnvironment(new RosEnvironment);

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_ROBOT_APP_ROS_ENVIRONMENT_H_
