#include "robot_app/assistance/help_desk.h"

#include <gmock/gmock.h>

#include <set>

namespace coppice::robot::assistance {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;
using Kind = Letter::Kind;

// "kind name: text" of each letter.
const char* NameOf(Kind kind) {
  switch (kind) {
    case Kind::kQuestion:
      return "question";
    case Kind::kReminder:
      return "reminder";
    case Kind::kAllClear:
      return "all-clear";
    case Kind::kNotice:
      return "notice";
  }
  return "";
}

// Supervisors in simulated time; channels in `down` fail.
class Desk : public testing::Test {
 protected:
  // Lets time pass in steps of a tenth of a second; returns what was delivered.
  std::vector<std::string> Pass(Duration duration) {
    std::vector<std::string> delivered;
    for (const Time end = now_ + duration; now_ < end; now_ += std::chrono::milliseconds(100)) {
      desk_.Step(now_);
      Deliver(delivered);
    }
    return delivered;
  }

  void Deliver(std::vector<std::string>& delivered) {
    for (auto letters = desk_.TakeLetters(now_); !letters.empty();
         letters = desk_.TakeLetters(now_)) {
      for (const Letter& letter : letters) {
        const HumanSupervisor& to = desk_.supervisors()[letter.supervisor];
        const bool ok = down_.count(to.ways[letter.way].channel) == 0;
        if (ok) delivered.push_back(std::string(NameOf(letter.kind)) + " " + to.name);
        desk_.Delivered(letter.number, ok, now_);
      }
    }
  }

  const HelpRequest& request() { return desk_.requests().back(); }

  static HelpRules Rules(const std::string& subject) {
    HelpRules rules;
    if (subject == "cleaning") rules.ok_when_nobody = true;
    return rules;
  }

  static std::vector<HumanSupervisor> People() {
    return {{"Ada", {{"telegram", "1"}, {"mail", "a@x"}}},
            {"Ben", {{"mail", "b@x"}}},
            {"Cleo", {{"matrix", "!c"}}}};
  }

  Time now_{minutes(1000)};
  std::set<std::string> down_;
  HelpDesk desk_{People(), Rules};
};

TEST_F(Desk, ManySubjectsAreRefusedAndLongTextsCut) {
  for (std::size_t i = 0; i < HelpDesk::kMostOpen; ++i) {
    ASSERT_TRUE(desk_.Ask("subject " + std::to_string(i), "Blocked.", now_));
  }
  EXPECT_THAT(desk_.Ask("one more", "Blocked.", now_).problem(), HasSubstr("32 requests are open"));
  EXPECT_TRUE(desk_.Ask("subject 0", "Blocked still.", now_)) << "joins the one that is open";
  ASSERT_TRUE(desk_.Answer(0, "Ada", true, now_));
  EXPECT_TRUE(desk_.Ask("one more", "Blocked.", now_));
  const std::string endless(1 << 20, 'x');
  ASSERT_TRUE(desk_.Answer(0, "Ada", true, now_));
  EXPECT_TRUE(desk_.Ask(endless, endless, now_));
  EXPECT_EQ(request().subject.size(), HelpDesk::kLongestSubject);
  EXPECT_EQ(request().question.size(), HelpDesk::kLongestText);
  EXPECT_TRUE(desk_.Withdraw(endless, now_));
}

TEST_F(Desk, MessagesThatReachNobodyAreNotKeptWithoutEnd) {
  down_ = {"telegram", "mail", "matrix"};
  for (int i = 0; i < 1000; ++i) desk_.Tell("night", "Good night.");
  std::size_t waiting = 0;
  for (const Letter& letter : desk_.TakeLetters(now_)) waiting += letter.text.empty() ? 0 : 1;
  EXPECT_EQ(waiting, LetterQueue::kMostNotices);
}

TEST_F(Desk, TheFirstSupervisorIsAskedAtOnceAndTheOthersOneAfterTheOther) {
  ASSERT_TRUE(desk_.Ask("navigation", "Blocked.", now_));
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("question Ada"));
  EXPECT_THAT(Pass(seconds(118)), IsEmpty());
  EXPECT_THAT(Pass(seconds(2)), ElementsAre("reminder Ada"));
  EXPECT_THAT(Pass(minutes(3)), ElementsAre("reminder Ada", "question Ben"));
  EXPECT_THAT(
      Pass(minutes(5) + seconds(1)),
      ElementsAre("reminder Ada", "reminder Ben", "reminder Ada", "reminder Ben", "question Cleo"));
}

TEST_F(Desk, TheFirstAnswerWinsAndTheOthersHearThatItIsFixed) {
  const std::uint32_t id = desk_.Ask("navigation", "Blocked.", now_).value();
  Pass(minutes(6));
  EXPECT_TRUE(desk_.Answer(id, "Ben", true, now_));
  const Expected<std::string> second = desk_.Answer(id, "Ada", true, now_);
  EXPECT_FALSE(second);
  EXPECT_THAT(second.problem(), HasSubstr("Ben has fixed it"));
  EXPECT_EQ(request().state, HelpState::kFixed);
  EXPECT_EQ(request().answered_by, "Ben");
  EXPECT_TRUE(request().ok);
  EXPECT_THAT(Pass(minutes(60)), ElementsAre("all-clear Ada"));
}

TEST_F(Desk, NotFixedPassesTheQuestionOnUntilNobodyIsLeft) {
  const std::uint32_t id = desk_.Ask("navigation", "Blocked.", now_).value();
  Pass(seconds(1));
  EXPECT_TRUE(desk_.Answer(id, "Ada", false, now_));
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("question Ben"));
  EXPECT_TRUE(desk_.Answer(id, "Ben", false, now_));
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("question Cleo"));
  EXPECT_EQ(request().state, HelpState::kOpen);
  EXPECT_TRUE(desk_.Answer(id, "Cleo", false, now_));
  EXPECT_EQ(request().state, HelpState::kNotFixed);
  EXPECT_FALSE(request().ok);
}

TEST_F(Desk, WhoCouldNotFixItIsNotRemindedButMayStillFixIt) {
  const std::uint32_t id = desk_.Ask("navigation", "Blocked.", now_).value();
  Pass(seconds(1));
  EXPECT_TRUE(desk_.Answer(id, "Ada", false, now_));
  EXPECT_THAT(Pass(minutes(3)), ElementsAre("question Ben", "reminder Ben"));
  EXPECT_TRUE(desk_.Answer(id, "Ada", true, now_));
  EXPECT_EQ(request().state, HelpState::kFixed);
}

TEST_F(Desk, IfNobodyAnswersTheSafeDefaultOfTheSubjectHolds) {
  ASSERT_TRUE(desk_.Ask("navigation", "Blocked.", now_));
  ASSERT_TRUE(desk_.Ask("cleaning", "May I vacuum here?", now_));
  Pass(minutes(30) - seconds(1));
  EXPECT_EQ(request().state, HelpState::kOpen);
  const auto last = Pass(seconds(2));
  EXPECT_THAT(last, UnorderedElementsAre("all-clear Ada", "all-clear Ben", "all-clear Cleo",
                                         "all-clear Ada", "all-clear Ben", "all-clear Cleo"));
  ASSERT_THAT(desk_.requests(), SizeIs(2));
  EXPECT_EQ(desk_.requests()[0].state, HelpState::kNobody);
  EXPECT_FALSE(desk_.requests()[0].ok);
  EXPECT_THAT(desk_.requests()[0].message, HasSubstr("stays where it is"));
  EXPECT_TRUE(desk_.requests()[1].ok);
}

TEST_F(Desk, ARequestMayHaveADeadlineOfItsOwn) {
  ASSERT_TRUE(desk_.Ask("navigation", "Blocked.", now_, seconds(20)));
  Pass(seconds(19));
  EXPECT_EQ(request().state, HelpState::kOpen);
  Pass(seconds(2));
  EXPECT_EQ(request().state, HelpState::kNobody);
}

TEST_F(Desk, AWithdrawnQuestionClosesWhenTheFaultStaysAway) {
  ASSERT_TRUE(desk_.Ask("navigation", "Blocked.", now_));
  Pass(seconds(1));
  EXPECT_TRUE(desk_.Withdraw("navigation", now_));
  EXPECT_THAT(Pass(seconds(10)), IsEmpty());
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("all-clear Ada"));
  EXPECT_EQ(request().state, HelpState::kWithdrawn);
  EXPECT_FALSE(desk_.Withdraw("navigation", now_));
}

TEST_F(Desk, AFaultThatComesAndGoesSendsNoMessages) {
  const std::uint32_t id = desk_.Ask("navigation", "Blocked.", now_).value();
  Pass(seconds(1));
  for (int i = 0; i < 10; ++i) {
    desk_.Withdraw("navigation", now_);
    EXPECT_THAT(Pass(seconds(5)), IsEmpty());
    EXPECT_EQ(desk_.Ask("navigation", "Blocked.", now_).value(), id);
    EXPECT_THAT(Pass(seconds(2)), IsEmpty());
  }
}

TEST_F(Desk, AskedAgainTheOpenQuestionIsJoinedWithTheNewerText) {
  const std::uint32_t id = desk_.Ask("navigation", "Blocked.", now_).value();
  EXPECT_EQ(desk_.Ask("navigation", "Blocked by a pallet.", now_).value(), id);
  EXPECT_EQ(request().question, "Blocked by a pallet.");
  EXPECT_NE(desk_.Ask("localization", "Lost.", now_).value(), id);
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("question Ada", "question Ada"));
}

TEST_F(Desk, AskedAgainAfterItWasClosedItIsANewQuestion) {
  const std::uint32_t id = desk_.Ask("navigation", "Blocked.", now_).value();
  Pass(seconds(1));
  EXPECT_TRUE(desk_.Answer(id, "Ada", true, now_));
  EXPECT_EQ(desk_.Ask("navigation", "Blocked.", now_).value(), id + 1);
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("question Ada"));
}

TEST_F(Desk, WhoOpensThePageHasTimeBeforeTheNextOneIsAsked) {
  const std::uint32_t id = desk_.Ask("navigation", "Blocked.", now_).value();
  Pass(minutes(4));
  desk_.Take(id, "Ada", now_);
  EXPECT_EQ(request().taken_by, "Ada");
  EXPECT_THAT(Pass(minutes(4)), ElementsAre("reminder Ada"));
  EXPECT_THAT(Pass(minutes(1) + seconds(1)), ElementsAre("reminder Ada", "question Ben"));
}

TEST_F(Desk, AChannelThatIsDownMakesWayForTheNextOneOfTheSamePerson) {
  down_ = {"telegram"};
  ASSERT_TRUE(desk_.Ask("navigation", "Blocked.", now_));
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("question Ada"));
}

TEST_F(Desk, APersonWhoCannotBeReachedIsTriedAgainAndTheNextIsAskedMeanwhile) {
  down_ = {"telegram", "mail"};
  ASSERT_TRUE(desk_.Ask("navigation", "Blocked.", now_));
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("question Cleo"));
  EXPECT_EQ(request().asked[0].state, AskedSupervisor::State::kUnreachable);
  down_.clear();
  EXPECT_THAT(Pass(seconds(30)), ElementsAre("question Ada", "question Ben"));
  EXPECT_EQ(request().asked[0].state, AskedSupervisor::State::kReached);
}

TEST_F(Desk, WithAllChannelsDownTheQuestionStillEndsAtItsDeadline) {
  down_ = {"telegram", "mail", "matrix"};
  ASSERT_TRUE(desk_.Ask("navigation", "Blocked.", now_));
  EXPECT_THAT(Pass(minutes(31)), IsEmpty());
  EXPECT_EQ(request().state, HelpState::kNobody);
}

TEST_F(Desk, ANoticeGoesToTheFirstWhoCanBeReached) {
  down_ = {"telegram", "mail"};
  desk_.Tell("disk", "The disk is nearly full.");
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("notice Cleo"));
  down_ = {};
  EXPECT_THAT(Pass(minutes(5)), IsEmpty());
}

TEST_F(Desk, ANoticeThatReachesNobodyIsTriedAgain) {
  down_ = {"telegram", "mail", "matrix"};
  desk_.Tell("disk", "The disk is nearly full.");
  EXPECT_THAT(Pass(seconds(10)), IsEmpty());
  down_ = {};
  EXPECT_THAT(Pass(seconds(30)), ElementsAre("notice Cleo"));
}

TEST_F(Desk, SomebodyWhoIsNotOnTheListMayAnswer) {
  const std::uint32_t id = desk_.Ask("navigation", "Blocked.", now_).value();
  Pass(seconds(1));
  EXPECT_TRUE(desk_.Answer(0, "operator", true, now_));
  EXPECT_EQ(desk_.Find(id)->answered_by, "operator");
  EXPECT_THAT(Pass(seconds(1)), ElementsAre("all-clear Ada"));
}

TEST_F(Desk, AnAnswerToNothingIsRefused) {
  EXPECT_FALSE(desk_.Answer(7, "Ada", true, now_));
  EXPECT_FALSE(desk_.Answer(0, "Ada", true, now_));
}

TEST_F(Desk, OpenQuestionsGoOnAfterARestart) {
  ASSERT_TRUE(desk_.Ask("navigation", "Blocked.", now_));
  Pass(minutes(6));
  HelpDesk later(People(), Rules);
  later.Restore({desk_.requests().begin(), desk_.requests().end()});
  EXPECT_TRUE(later.TakeLetters(now_).empty());
  later.Step(now_ + minutes(5));
  EXPECT_THAT(later.TakeLetters(now_ + minutes(5)), SizeIs(1));  // Cleo is asked
  EXPECT_EQ(later.Ask("localization", "Lost.", now_).value(), request().id + 1);
}

TEST_F(Desk, WhoWasNotReachedBeforeARestartIsAskedAfterIt) {
  ASSERT_TRUE(desk_.Ask("navigation", "Blocked.", now_));
  HelpDesk later(People(), Rules);
  later.Restore({desk_.requests().begin(), desk_.requests().end()});
  EXPECT_THAT(later.TakeLetters(now_), SizeIs(1));
}

TEST_F(Desk, WithoutSupervisorsAQuestionEndsAtItsDeadlineOrByAnAnswer) {
  HelpDesk alone({}, Rules);
  alone.Tell("disk", "Full.");
  const std::uint32_t id = alone.Ask("navigation", "Blocked.", now_).value();
  EXPECT_TRUE(alone.TakeLetters(now_).empty());
  EXPECT_TRUE(alone.Answer(id, "operator", false, now_));
  EXPECT_EQ(alone.requests().back().state, HelpState::kNotFixed);
}

TEST_F(Desk, OnlyTheLastClosedQuestionsAreKept) {
  for (int i = 0; i < 100; ++i) {
    EXPECT_TRUE(desk_.Answer(desk_.Ask("navigation", "Blocked.", now_).value(), "Ada", true, now_));
  }
  EXPECT_LE(desk_.requests().size(), HelpDesk::kClosedKept + 1);
}

}  // namespace
}  // namespace coppice::robot::assistance
