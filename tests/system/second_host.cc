#include "tests/system/second_host.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

namespace coppice::robot {

SecondHost::SecondHost() {
  const int number = getpid() % 65000;
  name_ = "coppice" + std::to_string(number);
  network_ = "10.213." + std::to_string(number % 250);
  const std::string near = "cn" + std::to_string(number), far = "cf" + std::to_string(number);
  Run("ip netns add " + name_) && Run("ip link add " + near + " type veth peer name " + far) &&
      Run("ip link set " + far + " netns " + name_) &&
      Run("ip addr add " + own_address() + "/24 dev " + near) &&
      Run("ip link set " + near + " up") &&
      Run("ip -n " + name_ + " addr add " + address() + "/24 dev " + far) &&
      Run("ip -n " + name_ + " link set " + far + " up") &&
      Run("ip -n " + name_ + " link set lo up");
}

SecondHost::~SecondHost() {
  error_.clear();
  Run("ip netns del " + name_);  // takes both ends of the network with it
}

void SecondHost::Cut() {
  EXPECT_TRUE(Run("ip -n " + name_ + " link set cf" + name_.substr(7) + " down")) << error_;
}

void SecondHost::Join() {
  EXPECT_TRUE(Run("ip -n " + name_ + " link set cf" + name_.substr(7) + " up")) << error_;
}

bool SecondHost::Run(const std::string& command) {
  if (std::system((command + " 2>/dev/null").c_str()) == 0) return true;
  error_ = "refused: " + command;
  return false;
}

}  // namespace coppice::robot
