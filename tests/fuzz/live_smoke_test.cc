// The harness of requests to a live view, as smoke_test.cc does it for the others.
#include <gtest/gtest.h>

#include <string>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/mutator.h"

namespace coppice::fuzz {
namespace {

constexpr const char* kRequests = R"(1T
1S
1BMain;inner
1I{"enabled": true, "uid": 2, "mode": 1, "once": false, "desired_status": "FAILURE", "position": 0}
1I[{"enabled": true, "uid": 1, "mode": 0, "once": true, "desired_status": "SKIPPED", "position": 1}]
1U{"uid": 2, "position": 0, "desired_status": "SUCCESS", "remove_when_done": true}
1R{"uid": 1, "position": 1}
1D
1A
1X
1rstart
1t
1C{"do": "hello", "protocol": 1, "name": "x"}
2C{"do": "hello"}
1C{"do": "subscribe", "tree": 0, "run": "00", "from": 3, "window": 1000}
1C{"do": "subscribe", "from": "now"}
1C{"do": "ack", "subscription": 1, "next": 2}
1C{"do": "hook", "node": "inner/a", "action": "replace", "status": "FAILURE", "times": 2}
2C{"do": "hook", "node": 2, "condition": "n > 0 && word == 'x'", "from_hit": 2, "action": "stop"}
2C{"do": "hook", "hook": 2, "node": "s", "action": "delay", "delay_ms": 1.5, "enabled": false}
1C{"do": "enable", "hook": 1, "enabled": false}
1C{"do": "hooks"}
1C{"do": "write", "scope": "inner", "key": "number", "value": 7}
1C{"do": "write", "key": "n", "text": "8"}
1C{"do": "statistics"}
1C{"do": "pause"}
1C{"do": "step", "to": "node"}
1C{"do": "continue", "result": "SUCCESS"}
1C{"do": "trees"}
1C{"do": "unhook", "hook": 1}
1C{"do": "unsubscribe", "subscription": 1}
1C{"do": "ping"}
2C{"do": "bye"}
)";

TEST(FuzzLive, MutatedRequestsNeverCrash) {
  const int good = FuzzLive(kRequests);
  EXPECT_GE(good, 30) << "the unchanged requests are good ones";
  int total = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) total += FuzzLive(Mutator(seed).Mutate(kRequests));
  EXPECT_GT(total, 5000) << "many reach the tree";
}

TEST(FuzzLive, EmptyInputIsFine) { EXPECT_EQ(FuzzLive(""), 0); }

}  // namespace
}  // namespace coppice::fuzz
