#include "tests/system/second_host.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

namespace coppice::robot {

SecondHost::SecondHost() {
  const int number = getpid() % 65000;
  name_ = "coppice" + std::to_string(number);
  network_ = "10.213." + std::to_string(number % 250);
  const std::string near = "cn" + std::to_string(number);
  Run("ip netns add " + name_) && Run("ip link add " + near + " type veth peer name " + far()) &&
      Run("ip link set " + far() + " netns " + name_) &&
      Run("ip addr add " + own_address() + "/24 dev " + near) &&
      Run("ip link set " + near + " up") &&
      Run("ip -n " + name_ + " addr add " + address() + "/24 dev " + far()) &&
      Run("ip -n " + name_ + " link set " + far() + " up") &&
      Run("ip -n " + name_ + " link set lo up");
}

SecondHost::~SecondHost() {
  error_.clear();
  Run("ip netns del " + name_);  // takes both ends of the network with it
}

std::vector<std::string> SecondHost::transport() const {
  const std::string is_up = "/sbin/ip -n " + name_ + " link show dev " + far() + " up";
  return {"/bin/sh", "-c",
          is_up + " | grep -q UP || exit 255; exec /sbin/ip netns exec " + name_ + R"( "$@")",
          "transport"};
}

void SecondHost::Cut() {
  EXPECT_TRUE(Run("ip -n " + name_ + " link set " + far() + " down")) << error_;
}

void SecondHost::Join() {
  EXPECT_TRUE(Run("ip -n " + name_ + " link set " + far() + " up")) << error_;
}

bool SecondHost::Run(const std::string& command) {
  if (std::system((command + " 2>/dev/null").c_str()) == 0) return true;
  error_ = "refused: " + command;
  return false;
}

}  // namespace coppice::robot
