#include "robot_app/monitoring/system/reach.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "robot_app/monitoring/system/sockets.h"

namespace coppice::robot::monitoring {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// A TCP port on loopback, with or without somebody who listens.
class Port {
 public:
  explicit Port(bool listens) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(socket_.fd(), reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
    if (listens) listen(socket_.fd(), 1);
  }
  ReachTarget target() const { return {"127.0.0.1", PortOf(socket_)}; }

 private:
  Socket socket_;
};

TEST(Reach, AcceptedAndRefusedConnectionsAreBothAnswers) {
  const Port open(true), closed(false);
  const auto results = TryToReach({open.target(), closed.target()}, seconds(10));
  ASSERT_EQ(results.size(), 2u);
  for (const ReachDelay& result : results) {
    ASSERT_TRUE(result) << result.problem();
    EXPECT_GE(*result, 0);
    EXPECT_LT(*result, 10);
  }
}

TEST(Reach, AComputerThatIsSilentHoldsUpNobodyElse) {
  const Port open(true), silent(true);
  // Whoever listens and never accepts falls silent when its queue is full.
  for (int i = 0; i < 10 && TryToReach({silent.target()}, milliseconds(100)).at(0); ++i) {
  }
  const auto results =
      TryToReach({silent.target(), open.target(), {"no such name", 22}, {"255.255.255.255", 22}},
                 milliseconds(200));
  EXPECT_FALSE(results[0]);
  EXPECT_EQ(results[0].problem(), "no answer");
  EXPECT_TRUE(results[1]);
  EXPECT_FALSE(results[2]);
  EXPECT_NE(results[2].problem(), "");
  EXPECT_FALSE(results[3]);  // nobody can connect to everybody
  EXPECT_NE(results[3].problem(), "");
}

TEST(Reach, NothingToAskIsDoneAtOnce) { EXPECT_TRUE(TryToReach({}, seconds(100)).empty()); }

}  // namespace
}  // namespace coppice::robot::monitoring
