// Another host for a test: a network namespace of this computer where that is allowed (root, not in
// every container), else a shell in between. Both are reached by a command, as ssh would be.
#ifndef COPPICE_TESTS_ROBOT_APP_PROCESSES_OTHER_HOST_H_
#define COPPICE_TESTS_ROBOT_APP_PROCESSES_OTHER_HOST_H_

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "robot_app/processes/config/robot_config.h"
#include "tests/support/folders.h"

namespace coppice::robot::processes {

class OtherHost {
 public:
  /// A pair of addresses joins the two: here() and there().
  OtherHost() {
    is_namespace_ =
        Run("ip netns add " + name_) &&
        Run("ip link add " + here_link_ + " type veth peer name " + there_link_) &&
        Run("ip link set " + there_link_ + " netns " + name_) &&
        Run("ip address add " + here_ + "/30 dev " + here_link_) &&
        Run("ip link set " + here_link_ + " up") &&
        Run("ip netns exec " + name_ + " ip address add " + there_ + "/30 dev " + there_link_) &&
        Run("ip netns exec " + name_ + " ip link set " + there_link_ + " up") &&
        Run("ip netns exec " + name_ + " ip link set lo up");
    if (!is_namespace_) here_ = there_ = "127.0.0.1";
  }
  ~OtherHost() {
    Run("ip link del " + here_link_);
    Run("ip netns del " + name_);
  }
  OtherHost(const OtherHost&) = delete;
  OtherHost& operator=(const OtherHost&) = delete;

  bool is_namespace() const { return is_namespace_; }
  const std::string& here() const { return here_; }
  const std::string& there() const { return there_; }

  /// The words before a command that is to run there.
  std::vector<std::string> Transport() const {
    if (is_namespace_) return {"ip", "netns", "exec", name_};
    return {"/bin/sh", "-c", R"("$@"; exit $?)", "sh"};
  }

  HostConfig Config() const {
    HostConfig config;
    config.name = "other";
    config.command = Transport();
    config.shell = false;
    config.bin = BinaryFolder() + "/bin";
    config.address = there_;
    return config;
  }

 private:
  static bool Run(const std::string& command) {
    return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
  }

  const std::string id_ = std::to_string(getpid() % 100000);
  const std::string name_ = "coppice" + id_;
  const std::string here_link_ = "cop" + id_ + "a", there_link_ = "cop" + id_ + "b";
  const std::string net_ = "10.77." + std::to_string(getpid() / 64 % 256) + ".";
  const int low_ = getpid() % 64 * 4;
  std::string here_ = net_ + std::to_string(low_ + 1), there_ = net_ + std::to_string(low_ + 2);
  bool is_namespace_ = false;
};

}  // namespace coppice::robot::processes

#endif  // COPPICE_TESTS_ROBOT_APP_PROCESSES_OTHER_HOST_H_
