#include "bt_core/live/groot2/groot2_hooks.h"

#include "tests/bt_core/live/desk_fixture.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using Json = nlohmann::json;

constexpr std::size_t kNodes = 6;

class Groot2HooksTest : public LiveTreeFixture {
 protected:
  static std::string MakeHook(int uid, int mode = 0, const std::string& status = "SKIPPED",
                              int position = 0) {
    return Json{{"enabled", true},          {"uid", uid},          {"mode", mode}, {"once", false},
                {"desired_status", status}, {"position", position}}
        .dump();
  }
  Outcome Insert(const std::string& json) { return hooks_.Insert(json, kNodes); }

  Groot2Hooks hooks_{tree_->debugger(), 77};
};

TEST_F(Groot2HooksTest, TranslatesABreakpoint) {
  EXPECT_EQ(Insert(MakeHook(3)).problem(), "");
  ASSERT_THAT(tree_->debugger().hooks(), SizeIs(1));
  const HookInfo info = tree_->debugger().hooks()[0];
  EXPECT_EQ(info.owner, 77u);
  EXPECT_EQ(info.hook.node, 2u);
  EXPECT_EQ(info.hook.action, HookAction::kStop);
  EXPECT_EQ(hooks_.UidOf(info.id), 3);
  EXPECT_EQ(hooks_.UidOf(info.id + 1), std::nullopt);
}

TEST_F(Groot2HooksTest, ReplacesAResultOnlyBySuccessAndFailure) {
  EXPECT_EQ(Insert(MakeHook(2, 1, "FAILURE", 1)).problem(), "");
  EXPECT_EQ(Insert(MakeHook(3, 1, "RUNNING")).problem(), "");
  Tick();
  EXPECT_EQ(executor_.status(kRootNode), Status::kFailure);
  EXPECT_FALSE(tree_->debugger().hooks()[1].hook.enabled) << "lets the node run normally";
}

TEST_F(Groot2HooksTest, KeepsOneHookForEachNodeAndPosition) {
  EXPECT_TRUE(Insert(MakeHook(2)));
  EXPECT_TRUE(Insert(MakeHook(2, 0, "SKIPPED", 1)));
  EXPECT_TRUE(Insert(MakeHook(2, 1, "SUCCESS")));
  EXPECT_THAT(tree_->debugger().hooks(), SizeIs(2));
  EXPECT_EQ(Json::parse(hooks_.Dump())[0]["mode"], 1);
}

TEST_F(Groot2HooksTest, TakesABatchWholeOrNotAtAll) {
  EXPECT_THROW(Insert("[" + MakeHook(2) + ",{}]"), std::exception);
  EXPECT_TRUE(hooks_.empty());
  EXPECT_EQ(Insert("[" + MakeHook(2) + "," + MakeHook(99) + "," + MakeHook(0) + "]").problem(), "");
  EXPECT_THAT(tree_->debugger().hooks(), SizeIs(1)) << "nodes that there are not are passed over";
}

TEST_F(Groot2HooksTest, DumpsWhatWasInserted) {
  EXPECT_EQ(hooks_.Dump(), "[]");
  EXPECT_TRUE(Insert(MakeHook(5, 1, "FAILURE", 1)));
  EXPECT_EQ(Json::parse(hooks_.Dump()), Json::array({Json::parse(MakeHook(5, 1, "FAILURE", 1))}));
}

TEST_F(Groot2HooksTest, SaysThatAHookIsNotThere) {
  EXPECT_EQ(hooks_.Remove(R"({"uid": 2, "position": 0})").problem(), "Node ID not found");
  const char* const unlock =
      R"({"uid": 2, "position": 0, "desired_status": "", "remove_when_done": true})";
  EXPECT_EQ(hooks_.Unlock(unlock).problem(), "Node ID not found");
  EXPECT_TRUE(Insert(MakeHook(2)));
  EXPECT_EQ(hooks_.Unlock(unlock).problem(), "");
  EXPECT_EQ(hooks_.Unlock(unlock).problem(), "Node ID not found");
}

TEST_F(Groot2HooksTest, ForgetsAHookThatHasActedOnce) {
  Json hook = Json::parse(MakeHook(2, 1, "FAILURE"));
  hook["once"] = true;
  EXPECT_TRUE(Insert(hook.dump()));
  Tick();
  EXPECT_EQ(hooks_.Dump(), "[]");
  EXPECT_EQ(hooks_.Remove(R"({"uid": 2, "position": 0})").problem(), "Node ID not found");
  EXPECT_EQ(Insert(hook.dump()).problem(), "");
}

TEST_F(Groot2HooksTest, DisablesAndRemovesAll) {
  EXPECT_TRUE(Insert(MakeHook(2, 1, "FAILURE")));
  hooks_.SetAllEnabled(false);
  EXPECT_EQ(Json::parse(hooks_.Dump())[0]["enabled"], false);
  Tick();
  EXPECT_EQ(executor_.status(kRootNode), Status::kRunning);
  hooks_.SetAllEnabled(true);
  Tick();
  EXPECT_EQ(executor_.status(kRootNode), Status::kFailure);
  hooks_.RemoveAll();
  EXPECT_TRUE(hooks_.empty());
  EXPECT_THAT(tree_->debugger().hooks(), SizeIs(0));
}

}  // namespace
}  // namespace coppice
