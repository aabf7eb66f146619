// A ROS master of its own for a test program, on a free port, with this process as a node of it.
//
// Include it in one source file of a test program; every test then finds ROS up. The master ends
// with the process.
#ifndef COPPICE_TESTS_ROBOT_APP_ROS_ENVIRONMENT_H_
#define COPPICE_TESTS_ROBOT_APP_ROS_ENVIRONMENT_H_

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>

#include "robot_app/processes/launch/ros_master.h"
#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot {

class RosEnvironment : public testing::Environment {
 public:
  void SetUp() override {
    setenv("ROS_IP", "127.0.0.1", 1);
    NodeProbe::SilenceLibrary();
    launcher_.emplace(processes::Temporary("ros_environment"));
    master_ = processes::FindOrStartMaster(0, *launcher_, std::chrono::seconds(60)).value();
    setenv("ROS_MASTER_URI", master_.Uri().c_str(), 1);
    int no_arguments = 0;
    ros::init(no_arguments, nullptr, "coppice_test",
              ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
    ros::start();
    spinner_ = std::make_unique<ros::AsyncSpinner>(2);
    spinner_->start();
  }

  void TearDown() override {
    spinner_->stop();
    ros::shutdown();
    launcher_->Signal(master_.pid, SIGKILL);
    waitpid(master_.pid, nullptr, 0);
  }

 private:
  std::optional<processes::PosixLauncher> launcher_;
  processes::RosMaster master_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
};

inline testing::Environment* const kRosEnvironment =
    testing::AddGlobalTestEnvironment(new RosEnvironment);

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_ROBOT_APP_ROS_ENVIRONMENT_H_
