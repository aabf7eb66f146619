#include "bt_core/analysis/formats/import_btlog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/analysis/formats/btlog.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

constexpr char kXml[] = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Helper" _fullpath="help"><Wait name="wait" _uid="9"/></BehaviorTree>
  <BehaviorTree ID="Main" _fullpath=""><Sequence name="all" _uid="1">
    <Go _uid="5"/><SubTree ID="Helper" _fullpath="help" _uid="7"/>
    <Action ID="Say" name="say" _uid="8"/></Sequence></BehaviorTree></root>)";

class ImportBtlog : public testing::Test {
 protected:
  std::optional<Recording> Read(const std::string& xml, std::vector<BtlogTransition> transitions) {
    return FromBtlog(WriteBtlog({xml, std::move(transitions)}), "a.btlog", diagnostics_);
  }
  std::string Problem(const std::string& xml) {
    diagnostics_ = {};
    EXPECT_FALSE(Read(xml, {}));
    return diagnostics_.ToString();
  }
  Diagnostics diagnostics_;
};

TEST_F(ImportBtlog, NodesStandInTheOrderOfTheTreeWithTheirInstances) {
  const auto run = Read(kXml, {});
  ASSERT_TRUE(run) << diagnostics_.ToString();
  const TreeDescription& tree = run->trees()[0];
  EXPECT_EQ(tree.main_tree, "Main");
  std::string paths;
  for (const DescribedNode& node : tree.nodes) {
    paths += node.path + " " + node.id + " " + std::to_string(node.parent) + "\n";
  }
  EXPECT_EQ(paths, "all Sequence 0\nGo::5 Go 0\nhelp Helper 0\nhelp/wait Wait 2\nsay Say 0\n");
  EXPECT_EQ(tree.nodes[4].category, NodeCategory::kAction);
  EXPECT_TRUE(TellsChangesOnly(tree.info));
}

TEST_F(ImportBtlog, TransitionsThatFollowEachOtherWithinAMillisecondAreATick) {
  const auto run = Read(kXml, {{5000, 5, Status::kRunning},
                               {5900, 1, Status::kRunning},
                               {6900, 9, Status::kRunning},
                               {7901, 5, Status::kSuccess}});
  ASSERT_TRUE(run) << diagnostics_.ToString();
  ASSERT_EQ(run->ticks().size(), 2U);
  EXPECT_EQ(run->EventsOf(0).start, Time(Duration(5'000'000)));
  EXPECT_EQ(run->EventsOf(0).duration, Duration(1'900'000));
  EXPECT_EQ(run->EventsOf(0).result, Status::kRunning);
  EXPECT_EQ(run->Before(2).statuses,
            (std::vector<Status>{Status::kRunning, Status::kSuccess, Status::kIdle,
                                 Status::kRunning, Status::kIdle}));
  ASSERT_TRUE(run->end());
}

TEST_F(ImportBtlog, ATreeThatCannotBeUnderstoodIsRefusedWithTheReason) {
  EXPECT_THAT(Problem("<root"), HasSubstr("a.btlog"));
  EXPECT_THAT(Problem("<root/>"), HasSubstr("has no main tree"));
  EXPECT_THAT(Problem("<root><BehaviorTree ID='A' _fullpath=''/></root>"),
              HasSubstr("has an empty tree"));
  EXPECT_THAT(Problem("<root><BehaviorTree ID='A' _fullpath=''><Go/></BehaviorTree></root>"),
              HasSubstr("a node without _uid: <Go>"));
  EXPECT_THAT(
      Problem("<root><BehaviorTree ID='A' _fullpath=''><Go _uid='65536'/></BehaviorTree></root>"),
      HasSubstr("without _uid"));
  EXPECT_THAT(Problem("<root><BehaviorTree ID='A' _fullpath=''><Sequence _uid='3'>"
                      "<Go _uid='3'/></Sequence></BehaviorTree></root>"),
              HasSubstr("two nodes with _uid 3"));
  EXPECT_THAT(Problem("<root><BehaviorTree ID='A' _fullpath=''>"
                      "<SubTree ID='A' _fullpath='a' _uid='1'/></BehaviorTree>"
                      "<BehaviorTree ID='A' _fullpath='a'>"
                      "<SubTree ID='A' _fullpath='a' _uid='2'/></BehaviorTree></root>"),
              HasSubstr("two nodes with _uid 2"));
}

TEST_F(ImportBtlog, ATransitionOfAnUnknownNodeIsRefused) {
  EXPECT_FALSE(Read(kXml, {{5000, 6, Status::kRunning}}));
  EXPECT_THAT(diagnostics_.ToString(),
              HasSubstr("a transition of uid 6, which is not in its tree"));
}

}  // namespace
}  // namespace coppice
