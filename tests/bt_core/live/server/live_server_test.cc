#include "bt_core/live/server/live_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "bt_core/live/server/live_publisher.h"
#include "tests/bt_core/live/live_client.h"
#include "tests/bt_core/live/watched_tree.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

TEST(LiveServer, NeedsATokenToBeReachedFromElsewhere) {
  for (const char* address : {"*", "0.0.0.0", "192.168.1.1", "eth0", "localhost"}) {
    LiveOptions options = FreePort();
    options.address = address;
    try {
      const LiveServer server(options);
      ADD_FAILURE() << address;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("openssl rand -hex 16"));
      EXPECT_THAT(error.what(), HasSubstr("COPPICE_LIVE_TOKEN"));
    }
  }
}

TEST(LiveServer, ListensEverywhereWithAToken) {
  LiveOptions options = FreePort();
  options.address = "*";
  options.token = "a token for tests";
  const LiveServer server(options);
  EXPECT_THAT(server.read_token(), HasSubstr("read-"));
  ExtensionClient owner(server.port(), options.token);
  EXPECT_EQ(owner.Ask("hello")["role"], "control");
  ExtensionClient reader(server.port(), server.read_token());
  EXPECT_EQ(reader.Ask("hello")["role"], "read");
}

TEST(LiveServer, RefusesATokenThatCouldBeGuessed) {
  LiveOptions options = FreePort();
  options.token = "robot";
  EXPECT_THROW(LiveServer{options}, std::invalid_argument);
}

TEST(LiveServer, ServesTreesAsTheyComeAndGo) {
  SimulatedClock clock;
  Executor first(WatchedProgram(), clock);
  Executor second(WatchedProgram(), clock);
  EventStream first_stream(first);
  EventStream second_stream(second);
  LiveServer server(FreePort());
  PlainClient plain(server.port());
  EXPECT_EQ(plain.Ask('S').at(1), "no tree is running here now");
  ExtensionClient client(server.port());
  EXPECT_EQ(client.Ask("hello")["trees"].size(), 0u);
  {
    const LivePublisher one(first_stream, server);
    const LivePublisher two(second_stream, server);
    EXPECT_EQ(client.Ask("trees")["trees"].size(), 2u);
    EXPECT_EQ(plain.Ask('S').at(1).size(), 18u);
  }
  EXPECT_EQ(client.Ask("trees")["trees"].size(), 0u);
}

}  // namespace
}  // namespace coppice
