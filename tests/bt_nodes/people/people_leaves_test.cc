#include "bt_nodes/people/people_leaves.h"

#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

SeenPerson At(double x, double y, std::uint32_t id = 1) {
  return {id, x, y, 0, 10, 0, Mask::kUnknown};
}

template <typename Leaf>
void Show(Leaf& harness, std::vector<SeenPerson> people, Time stamp = {}) {
  harness.Set("people", PeopleView{stamp, std::move(people)});
}

TEST(PersonInFront, NamesTheNearestBeforeTheRobot) {
  LeafHarness harness = LeafHarness::For<PersonInFront>();
  Show(harness, {At(1.8, 0, 3), At(1.2, 0.2, 4), At(0.5, 2, 5)});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<int>("id"), 4);
}

TEST(PersonInFront, WhoIsTooFarAsideOrJustComeIsNot) {
  for (SeenPerson person : {At(2.5, 0), At(1, 1), At(-1, 0)}) {
    LeafHarness harness = LeafHarness::For<PersonInFront>();
    Show(harness, {person});
    EXPECT_EQ(harness.Tick(), Status::kFailure) << person.x << " " << person.y;
  }
  SeenPerson new_one = At(1, 0);
  new_one.known_for = 0.5;
  LeafHarness harness = LeafHarness::For<PersonInFront>();
  Show(harness, {new_one});
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

TEST(NearestPerson, TellsDistanceAndAngle) {
  LeafHarness harness = LeafHarness::For<NearestPerson>();
  Show(harness, {At(0, 2, 8), At(5, 5, 9)});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<int>("id"), 8);
  EXPECT_DOUBLE_EQ(harness.Get<double>("distance"), 2);
  EXPECT_NEAR(harness.Get<double>("angle"), 1.5708, 1e-4);
}

TEST(NearestPerson, WhoIsOutOfSightMayBeElsewhere) {
  SeenPerson hidden = At(1, 0, 8);
  hidden.unseen_for = 0.8;
  LeafHarness harness = LeafHarness::For<NearestPerson>();
  Show(harness, {hidden, At(3, 0, 9)});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<int>("id"), 9);
}

TEST(NearestPerson, FailsWhereNobodyIs) {
  LeafHarness harness = LeafHarness::For<NearestPerson>();
  Show(harness, {});
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "nobody is around");
}

TEST(PeopleLeaves, AllFailWhenPerceptionIsSilent) {
  FakeRobot robot;
  std::vector<LeafHarness> leaves;
  leaves.push_back(LeafHarness::For<PersonInFront>());
  leaves.push_back(LeafHarness::For<NearestPerson>());
  leaves.push_back(LeafHarness::For<CountPeople>());
  leaves.push_back(LeafHarness::For<FollowerBehind>());
  leaves.push_back(LeafHarness::For<MaskMissing>());
  for (LeafHarness& harness : leaves) {
    EXPECT_EQ(harness.Tick(), Status::kFailure) << "never heard of";
    Show(harness, {At(1, 0), At(-1, 0, 2)});
    harness.Advance(std::chrono::milliseconds(1500));
    EXPECT_EQ(harness.Tick(), Status::kFailure) << "too old";
    EXPECT_EQ(harness.message(), "perception does not tell who is around");
  }
}

TEST(CountPeople, CountsThoseWithinTheDistanceByTheirMasks) {
  SeenPerson with = At(1, 0, 1), without = At(2, 0, 2), far = At(9, 0, 3);
  with.mask = Mask::kWith;
  without.mask = far.mask = Mask::kWithout;
  LeafHarness harness = LeafHarness::For<CountPeople>();
  Show(harness, {with, without, far, At(0, 1, 4)});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<int>("count"), 3);
  EXPECT_EQ(harness.Get<int>("with_mask"), 1);
  EXPECT_EQ(harness.Get<int>("without_mask"), 1);
}

TEST(FollowerBehind, LooksBehindTheRobotAndOverShortOcclusions) {
  SeenPerson hidden = At(-2, 0.3);
  hidden.unseen_for = 1.5;
  LeafHarness harness = LeafHarness::For<FollowerBehind>();
  Show(harness, {hidden});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  Show(harness, {At(2, 0)});
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  hidden.unseen_for = 3;
  Show(harness, {hidden});
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

class FollowerNearTest : public testing::Test {
 protected:
  LeafHarness leaf_ = LeafHarness::For<FollowerNear>();
  void SetUp() override { leaf_.Set("id", -1); }
};

TEST_F(FollowerNearTest, TheNearestOfAllBecomesTheFollower) {
  Show(leaf_, {At(3, 0, 4), At(1, 0, 5)});
  EXPECT_EQ(leaf_.Tick(), Status::kSuccess);
  EXPECT_EQ(leaf_.Get<int>("id"), 5);
  EXPECT_DOUBLE_EQ(leaf_.Get<double>("gap"), 1);
}

TEST_F(FollowerNearTest, StaysWithWhoItIsWhereverHeWalks) {
  leaf_.Set("id", 5);
  Show(leaf_, {At(0, 1, 4), At(2, 1, 5)});
  EXPECT_EQ(leaf_.Tick(), Status::kSuccess);
  EXPECT_EQ(leaf_.Get<int>("id"), 5);
}

TEST_F(FollowerNearTest, TakesWhoeverIsBehindForOneWhoseTrackBrokeOff) {
  leaf_.Set("id", 5);
  Show(leaf_, {At(-2, 0.5, 9), At(1, 0, 10)});
  EXPECT_EQ(leaf_.Tick(), Status::kSuccess);
  EXPECT_EQ(leaf_.Get<int>("id"), 9);
}

// Somebody stood nearer when it began, and went his way.
TEST_F(FollowerNearTest, TakesWhoStandsCloseForTheOneWhoFollows) {
  leaf_.Set("id", 5);
  Show(leaf_, {At(0.3, 0.6, 9), At(6, 5, 5)});
  EXPECT_EQ(leaf_.Tick(), Status::kSuccess);
  EXPECT_EQ(leaf_.Get<int>("id"), 9);
  Show(leaf_, {At(2, 0, 10)});
  EXPECT_EQ(leaf_.Tick(), Status::kFailure) << "he stands farther away";
}

TEST_F(FollowerNearTest, WhoWalksAheadIsNoFollower) {
  leaf_.Set("id", 5);
  SeenPerson walks = At(1, 0, 10);
  walks.speed = 1;
  Show(leaf_, {walks, At(-5, 0, 5)});
  EXPECT_EQ(leaf_.Tick(), Status::kFailure);
}

TEST(SeesPeople, SeesAlsoThatNobodyIsThere) {
  LeafHarness leaf = LeafHarness::For<SeesPeople>();
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
  Show(leaf, {});
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  leaf.Advance(std::chrono::milliseconds(1500));
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
}

TEST(MaskMissing, TellsOnceForEachPerson) {
  SeenPerson first = At(1, 0, 1), second = At(2, 0, 2);
  first.mask = second.mask = Mask::kWithout;
  LeafHarness harness = LeafHarness::For<MaskMissing>();
  Show(harness, {first});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  Show(harness, {first, second});
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<int>("id"), 2);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

TEST(MaskMissing, WhoWearsOneOrShowsNoFaceIsLeftAlone) {
  SeenPerson with = At(1, 0);
  with.mask = Mask::kWith;
  LeafHarness harness = LeafHarness::For<MaskMissing>();
  Show(harness, {with, At(1, 1, 2)});
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

TEST(FacePerson, TurnsTowardsTheNearest) {
  FakeRobot robot;
  LeafHarness harness = LeafHarness::For<FacePerson>(std::ref<Navigator>(robot));
  Show(harness, {At(0, 2)});
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  ASSERT_EQ(robot.calls.size(), 1U);
  EXPECT_EQ(robot.calls[0].substr(0, 10), "Rotate 1.5");
  harness.Halt();
  EXPECT_EQ(robot.calls.back(), "CancelMotion");
}

TEST(FacePerson, DoesNotMoveForWhoIsAheadOrForNobody) {
  FakeRobot robot;
  LeafHarness ahead = LeafHarness::For<FacePerson>(std::ref<Navigator>(robot));
  Show(ahead, {At(2, 0.1)});
  ahead.Tick();
  EXPECT_EQ(ahead.Tick(), Status::kSuccess);
  LeafHarness nobody = LeafHarness::For<FacePerson>(std::ref<Navigator>(robot));
  Show(nobody, {});
  nobody.Tick();
  EXPECT_EQ(nobody.Tick(), Status::kFailure);
  EXPECT_TRUE(robot.calls.empty());
}

}  // namespace
}  // namespace coppice::leaves
