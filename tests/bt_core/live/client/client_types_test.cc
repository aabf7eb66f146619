#include "bt_core/live/client/client_types.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace coppice {
namespace {

TEST(ClientTypes, CommandsCarryWhatTheyNeed) {
  Hook hook;
  hook.path = "a";
  EXPECT_EQ(SetHook(hook).kind, LiveCommand::Kind::kAddHook);
  EXPECT_EQ(SetHook(hook).hook.path, "a");
  const LiveCommand write = WriteKey("dock", "speed", "0.5");
  EXPECT_EQ(write.kind, LiveCommand::Kind::kWrite);
  EXPECT_EQ(write.scope + "/" + write.key + "=" + write.value, "dock/speed=0.5");
}

TEST(ClientTypes, TheTokenComesFromTheEnvironment) {
  unsetenv("COPPICE_LIVE_TOKEN");
  EXPECT_EQ(TokenFromEnvironment(), "");
  setenv("COPPICE_LIVE_TOKEN", "secret", 1);
  EXPECT_EQ(TokenFromEnvironment(), "secret");
  unsetenv("COPPICE_LIVE_TOKEN");
}

}  // namespace
}  // namespace coppice
