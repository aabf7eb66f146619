#include "bt_core/frames/payload_coding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/frames/scripted_tree.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;
using ::testing::SizeIs;

TreeDescription SomeTree() {
  LeafScript script;
  RunInfo info = BeginRun(SimulatedClock(Duration(-5)));
  info.metadata = {{"robot", "sobi-1"}, {"", ""}};
  return DescribeTree(*ScriptedProgram(script), info);
}

Bytes Encoded(const TreeDescription& tree) {
  Bytes bytes;
  Encoder out(bytes);
  EncodeTree(tree, out);
  return bytes;
}

Decoder All(const Bytes& bytes) { return {bytes.data(), bytes.data() + bytes.size()}; }

TEST(PayloadCoding, BringsBackADescription) {
  const TreeDescription tree = SomeTree();
  const Bytes bytes = Encoded(tree);
  const auto decoded = DecodeTree(All(bytes));
  ASSERT_TRUE(decoded);
  EXPECT_EQ(Encoded(*decoded), bytes);
  EXPECT_EQ(decoded->info.run, tree.info.run);
  EXPECT_EQ(decoded->info.start, Time(Duration(-5)));
  EXPECT_THAT(decoded->info.metadata, ElementsAre(Pair("robot", "sobi-1"), Pair("", "")));
  EXPECT_EQ(decoded->models, tree.models);
  EXPECT_EQ(decoded->documents[0].text, tree.documents[0].text);
  EXPECT_TRUE(decoded->nodes[0].runs_one_child);
  EXPECT_EQ(decoded->nodes[1].ports[1].name, "ratio");
}

TEST(PayloadCoding, RefusesADescriptionThatIsCutOffOrTooLong) {
  Bytes bytes = Encoded(SomeTree());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(DecodeTree({bytes.data(), bytes.data() + size}));
  }
  bytes.push_back(0);
  EXPECT_FALSE(DecodeTree(All(bytes)));
}

TEST(PayloadCoding, RefusesNodesThatAreNotInPreorder) {
  TreeDescription tree = SomeTree();
  tree.nodes[4].parent = NodeIndex{1};  // behind the children of another
  EXPECT_FALSE(DecodeTree(All(Encoded(tree))));
  tree.nodes[4].parent = NodeIndex{4};
  EXPECT_FALSE(DecodeTree(All(Encoded(tree)))) << "only the root has itself";
  tree.nodes.clear();
  EXPECT_FALSE(DecodeTree(All(Encoded(tree)))) << "there is a root";
}

TEST(PayloadCoding, RefusesPortsWithoutSlotsAndNodesWithoutDocument) {
  TreeDescription tree = SomeTree();
  tree.nodes[1].ports[0].slot = SlotIndex{1000};
  EXPECT_FALSE(DecodeTree(All(Encoded(tree))));
  tree = SomeTree();
  tree.nodes[1].document = 1;
  EXPECT_FALSE(DecodeTree(All(Encoded(tree))));
}

TEST(PayloadCoding, BringsBackAState) {
  const HistoryState state{HistoryState::Cause::kJump,
                           77,
                           Time(Duration(-3)),
                           {Status::kRunning, Status::kIdle},
                           {Status::kRunning, Status::kFailure},
                           {"\1text", "", std::string(1, '\0')}};
  Bytes head;
  Bytes body;
  Encoder out_head(head);
  EncodeStateHead(state, out_head);
  Encoder out_body(body);
  EncodeStateBody(state, out_body);
  HistoryState decoded;
  Decoder in = All(head);
  ASSERT_TRUE(DecodeStateHead(in, decoded));
  EXPECT_FALSE(DecodeStateBody(All(body), {2, 4}, decoded));
  EXPECT_FALSE(DecodeStateBody(All(body), {3, 3}, decoded));
  ASSERT_TRUE(DecodeStateBody(All(body), {2, 3}, decoded));
  EXPECT_EQ(decoded.cause, state.cause);
  EXPECT_EQ(decoded.tick, 77u);
  EXPECT_EQ(decoded.time, Time(Duration(-3)));
  EXPECT_EQ(decoded.statuses, state.statuses);
  EXPECT_EQ(decoded.last, state.last);
  EXPECT_EQ(decoded.values, state.values);
}

TEST(PayloadCoding, BringsBackGapsNotesAndEnds) {
  Bytes bytes;
  Encoder out(bytes);
  EncodeGap({HistoryGap::Cause::kOutput, Time(Duration(9)), 3, 5, 8, 2}, out);
  const auto gap = DecodeGap(All(bytes));
  ASSERT_TRUE(gap);
  EXPECT_EQ(gap->cause, HistoryGap::Cause::kOutput);
  EXPECT_EQ(gap->lost_ticks, 3u);
  EXPECT_EQ(gap->last_tick, 8u);
  EXPECT_EQ(gap->lost_notes, 2u);
  EXPECT_FALSE(DecodeNote(All(bytes)));

  bytes.clear();
  EncodeNote({Time(Duration(4)), "fault", "laser"}, out);
  const auto note = DecodeNote(All(bytes));
  ASSERT_TRUE(note);
  EXPECT_EQ(note->time, Time(Duration(4)));
  EXPECT_EQ(note->kind, "fault");
  EXPECT_EQ(note->text, "laser");

  bytes.clear();
  EncodeEnd({HistoryEnd::Cause::kContinued, Time(Duration(4)), 12}, out);
  const auto end = DecodeEnd(All(bytes));
  ASSERT_TRUE(end);
  EXPECT_EQ(end->cause, HistoryEnd::Cause::kContinued);
  EXPECT_EQ(end->tick, 12u);
}

}  // namespace
}  // namespace coppice
