#include "bt_core/live/groot2/board_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bt_core/data/json.h"
#include "bt_core/data/value_bytes.h"
#include "tests/bt_core/live/watched_tree.h"

namespace coppice {

struct Pose {
  double x = 0;
  int level = 0;
};
template <>
struct ValueTraits<Pose> : JsonTraits<Pose> {
  static constexpr const char* kName = "Pose";
  template <class Fields, class P>
  static void List(Fields& fields, P& pose) {
    fields("x", pose.x)("level", pose.level);
  }
};

namespace {

using nlohmann::json;
using ::testing::ElementsAre;

json Boards(const Executor& executor, const std::vector<std::string_view>& names) {
  std::vector<std::string> values;
  for (const Slot& slot : executor.blackboard()) {
    values.emplace_back();
    AppendValueBytes(slot.value, values.back());
  }
  const Layout& layout = executor.program().layout;
  return json::from_msgpack(WriteBoards(layout, FindScopes(layout, names), values));
}

TEST(BoardMessage, WritesValuesAsWhatTheyAre) {
  SimulatedClock clock;
  Executor executor(WatchedProgram(), clock);
  executor.Tick();
  EXPECT_EQ(Boards(executor, {"Main"}), json::parse(R"({"Main": {
    "flag": true, "large": 1099511627776, "number": 1, "ratio": 0.5,
    "spot": "3;-4", "text": "näher & näher", "third": 0.3333333333333333}})"));
}

TEST(BoardMessage, WritesARegisteredTypeAsItsJsonWithItsName) {
  Layout layout;
  layout.scopes = {"Main"};
  layout.slots.push_back({"pose", kMainScope, &TypeOf<Pose>(), {}});
  std::string bytes;
  AppendValueBytes(Value(Pose{1.5, 2}), bytes);
  EXPECT_EQ(json::from_msgpack(WriteBoards(layout, {kMainScope}, {bytes})),
            json::parse(R"({"Main": {"pose": {"__type": "Pose", "x": 1.5, "level": 2}}})"));
}

TEST(BoardMessage, WritesNilForAKeyWithoutValue) {
  SimulatedClock clock;
  const Executor executor(WatchedProgram(), clock);
  EXPECT_TRUE(Boards(executor, {"Main"})["Main"]["number"].is_null());
}

TEST(BoardMessage, PutsRemappedKeysInTheScopeThatOwnsThem) {
  SimulatedClock clock;
  const Executor executor(WatchedProgram(), clock);
  EXPECT_EQ(Boards(executor, {"inner"}), json::parse(R"({"inner": {"literal": 7}})"));
}

TEST(BoardMessage, LeavesOutUnknownScopesAndIsNilIfNoneIsLeft) {
  SimulatedClock clock;
  const Executor executor(WatchedProgram(), clock);
  EXPECT_THAT(FindScopes(executor.program().layout, {"inner", "nobody"}), ElementsAre(1));
  EXPECT_EQ(WriteBoards(executor.program().layout, {}, {}), "\xc0");
}

}  // namespace
}  // namespace coppice
