#include "bt_nodes/visitors/visitor_leaves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "bt_core/testing/leaf_harness.h"
#include "tests/bt_nodes/fakes.h"

namespace coppice::leaves {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;

Visitor Wish(int request) {
  Visitor visitor;
  visitor.request = request;
  visitor.place = "office";
  visitor.language = "de";
  return visitor;
}

class VisitorArrivedTest : public testing::Test {
 protected:
  void Before(std::uint32_t id, double known_for = 10) {
    leaf_.Set("people", PeopleView{now_, {{id, 1, 0, 0, known_for, 0, Mask::kUnknown}}});
  }
  void Nobody() { leaf_.Set("people", PeopleView{now_, {}}); }
  void Touch() {
    ++visitor_.touches;
    leaf_.Set("visitor", visitor_);
  }
  bool Arrives() { return leaf_.Tick() == Status::kSuccess; }

  Time now_{};
  Visitor visitor_;
  LeafHarness leaf_ = LeafHarness::For<VisitorArrived>();
};

TEST_F(VisitorArrivedTest, OnceForEachWhoStandsBeforeTheRobot) {
  Before(1);
  EXPECT_TRUE(Arrives());
  EXPECT_FALSE(Arrives());
  Before(2);
  EXPECT_TRUE(Arrives());
}

TEST_F(VisitorArrivedTest, TellsTheLanguageThatIsSpokenNow) {
  Before(1);
  EXPECT_TRUE(Arrives());
  EXPECT_EQ(leaf_.Get<std::string>("language"), "en");
  visitor_.language = "de";
  Touch();
  Before(2);
  EXPECT_TRUE(Arrives());
  EXPECT_EQ(leaf_.Get<std::string>("language"), "de");
}

TEST_F(VisitorArrivedTest, NotWhoHasJustComeBy) {
  Before(1, 0.9);
  EXPECT_FALSE(Arrives());
  Before(1, 1.0);
  EXPECT_TRUE(Arrives());
}

TEST_F(VisitorArrivedTest, ByTouchAlsoWithoutPerception) {
  EXPECT_FALSE(Arrives());
  Touch();
  EXPECT_TRUE(Arrives());
  EXPECT_FALSE(Arrives());
}

TEST_F(VisitorArrivedTest, WhoTouchesAndWasGreetedIsNotGreetedAgain) {
  Before(1);
  EXPECT_TRUE(Arrives());
  Touch();
  EXPECT_FALSE(Arrives());
}

TEST_F(VisitorArrivedTest, WhoTouchesWhereNobodyIsSeenIsGreeted) {
  Nobody();
  Touch();
  EXPECT_TRUE(Arrives());
}

TEST_F(VisitorArrivedTest, NotByWhatPerceptionSaidLongAgo) {
  Before(1);
  leaf_.Advance(seconds(2));
  EXPECT_FALSE(Arrives());
}

TEST(VisitorTalks, UntilNothingWasSaidForAWhile) {
  LeafHarness leaf = LeafHarness::For<VisitorTalks>();
  EXPECT_EQ(leaf.Tick(), Status::kFailure) << "nobody ever";
  leaf.Advance(seconds(5));
  Visitor visitor;
  visitor.heard = Time(seconds(5));
  leaf.Set("visitor", visitor);
  leaf.Set("quiet", 8.0);
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  leaf.Advance(std::chrono::milliseconds(7900));
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  leaf.Advance(std::chrono::milliseconds(100));
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
}

TEST(GuideRequested, TellsTheWish) {
  LeafHarness leaf = LeafHarness::For<GuideRequested>();
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
  leaf.Set("visitor", Wish(3));
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  EXPECT_EQ(leaf.Get<int>("request"), 3);
  EXPECT_EQ(leaf.Get<std::string>("place"), "office");
  EXPECT_EQ(leaf.Get<std::string>("language"), "de");
}

TEST(GuideRequested, NobodyWaitsForHours) {
  LeafHarness leaf = LeafHarness::For<GuideRequested>();
  leaf.Set("visitor", Wish(3));
  leaf.Set("patience", 60.0);
  leaf.Advance(seconds(61));
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
}

TEST(RequestStands, NotIfItWasTakenBackOrAnotherCame) {
  LeafHarness leaf = LeafHarness::For<RequestStands>();
  leaf.Set("request", 3);
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
  leaf.Set("visitor", Wish(3));
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  leaf.Set("visitor", Wish(4));
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
  leaf.Set("visitor", Visitor{});
  EXPECT_EQ(leaf.Tick(), Status::kFailure);
}

TEST(SettleRequest, TellsHowItEnded) {
  FakeRobot robot;
  LeafHarness leaf = LeafHarness::For<SettleRequest>(std::ref<Visitors>(robot));
  leaf.Set("request", 3);
  leaf.Set("outcome", std::string("arrived"));
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  EXPECT_THAT(robot.calls, ElementsAre("Settle 3 arrived"));
}

TEST(SayPhrase, SpeaksTheVisitorsLanguage) {
  FakeRobot robot;
  LeafHarness leaf =
      LeafHarness::For<SayPhrase>(std::ref<Interaction>(robot), std::ref<Phrases>(robot));
  leaf.Set("phrase", Phrase::ARRIVED);
  leaf.Set("language", std::string("de"));
  leaf.Set("about", std::string("Mensa"));
  EXPECT_EQ(leaf.Tick(), Status::kRunning);
  EXPECT_THAT(robot.calls, ElementsAre("Say ARRIVED de Mensa"));
  EXPECT_THAT(robot.voices, ElementsAre("de"));
  robot.done.Send({true, ""});
  EXPECT_EQ(leaf.Tick(), Status::kSuccess);
  leaf.Tick();
  leaf.Halt();
  EXPECT_EQ(robot.calls.back(), "CancelSpeech");
}

}  // namespace
}  // namespace coppice::leaves
