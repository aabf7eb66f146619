#include "bt_core/live/client/client_extension.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "tests/bt_core/live/encoded_run.h"
#include "tests/bt_core/live/watcher.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using Json = nlohmann::json;
using Parts = ClientSession::Parts;

// The robot's side is the test.
class ClientExtensionTest : public ::testing::Test {
 protected:
  // The last request.
  Json Asked() const { return Json::parse(sent_.back()[1]); }

  // Answers it.
  void Answer(const Json& reply, Duration now = 1s) {
    session_.OnMessage({sent_.back()[0] + std::string(16, 'i'), reply.dump()}, now);
  }
  void Push(char type, const std::string& body) {
    session_.OnMessage({std::string("\x02") + type + std::string(20, '\0'), body}, 1s);
  }
  void Connect() {
    Answer({{"protocol", 1}, {"control", true}, {"trees", {{{"tree", 0}, {"name", "Main"}}}}});
    Answer({{"subscription", 0}, {"run", std::string(32, '1')}, {"next", 5}, {"missed", 0}});
  }

  // Tree and state, the frames 5 and 6.
  void PushTree() {
    const EncodedRun run(0);
    Push('F', Number(5) + Number(7) + run[0] + run[1]);
  }
  static std::string Number(char number) { return std::string(1, number) + std::string(7, '\0'); }

  // What the robot shows, as the client tells it: "face 1x1 ".
  std::string Shown() const {
    std::string shown;
    for (const LivePicture& picture : watcher_.watched().pictures) {
      shown += picture.name + " " + std::to_string(picture.width) + "x" +
               std::to_string(picture.height) + " ";
    }
    return shown;
  }

  LiveClientOptions options_;
  Watcher watcher_;
  ClientHistory history_{watcher_};
  std::vector<Parts> sent_;
  ClientExtension session_{options_, watcher_, history_,
                           [this](const Parts& parts) { sent_.push_back(parts); }};
};

TEST_F(ClientExtensionTest, SaysHelloThenSubscribes) {
  EXPECT_EQ(Asked()["do"], "hello");
  EXPECT_EQ(Asked()["protocol"], 1);
  EXPECT_FALSE(session_.is_live());
  Answer({{"protocol", 1}, {"trees", {{{"tree", 0}, {"name", "Main"}}}}});
  EXPECT_EQ(Asked()["do"], "subscribe");
  Answer({{"subscription", 7}, {"run", std::string(32, '1')}, {"next", 5}, {"missed", 0}});
  EXPECT_TRUE(session_.is_live());
  EXPECT_TRUE(watcher_.watched().is_live());
  EXPECT_EQ(watcher_.watched().connections.back().run[0], 0x11);
}

TEST_F(ClientExtensionTest, WaitsForItsTree) {
  EXPECT_FALSE(session_.has_answered());
  Answer({{"protocol", 1}, {"trees", Json::array()}});
  EXPECT_TRUE(session_.has_answered()) << "nobody says that there is no robot";
  EXPECT_THAT(watcher_.watched().connections.back().problem, HasSubstr("no tree yet"));
  Push('E', R"({"event":"trees","trees":[{"tree":0,"name":"Main"}]})");
  EXPECT_EQ(Asked()["do"], "subscribe");
}

TEST_F(ClientExtensionTest, SubscribesOnceAlthoughTreesComeMeanwhile) {
  Answer({{"protocol", 1}, {"trees", {{{"tree", 0}, {"name", "Main"}}}}});
  const std::size_t sent = sent_.size();
  Push('E', R"({"event":"trees","trees":[{"tree":0,"name":"Main"},{"tree":1,"name":"B"}]})");
  EXPECT_THAT(sent_, SizeIs(sent));
}

TEST_F(ClientExtensionTest, ATreeThatIsGoneHasNoName) {
  Connect();
  Push('E', R"({"event":"trees","trees":[]})");
  const LiveConnection connection = watcher_.watched().connections.back();
  EXPECT_TRUE(connection.is_live);
  ASSERT_LT(connection.tree, connection.trees.size());
  EXPECT_EQ(connection.trees[connection.tree], "");
}

TEST_F(ClientExtensionTest, ANodeThatTheTreeDoesNotHaveIsNotHandedOn) {
  Connect();
  PushTree();
  Push('E', R"({"event":"stopped","tree":0,"stop":{"where":"before","node":99,"path":"x"}})");
  ASSERT_THAT(watcher_.watched().notices, SizeIs(1));
  EXPECT_EQ(watcher_.watched().notices[0].event.stop.node, kNoNode);
  EXPECT_EQ(watcher_.watched().notices[0].path, "x");
}

TEST_F(ClientExtensionTest, AStopBeforeTheTreeIsKnownIsToldBehindTheTree) {
  Connect();
  Push('E', R"({"event":"stopped","tree":0,"stop":{"where":"before","node":1,"path":"x"}})");
  EXPECT_THAT(watcher_.watched().notices, SizeIs(0));
  PushTree();
  ASSERT_THAT(watcher_.watched().notices, SizeIs(1));
  EXPECT_EQ(watcher_.watched().notices[0].event.stop.node, 1u);
}

TEST_F(ClientExtensionTest, AsksForPicturesOnlyARobotThatHasSome) {
  options_.with_pictures = true;
  Answer({{"protocol", 1}, {"trees", {{{"tree", 0}, {"name", "Main"}}}}});
  EXPECT_THAT(sent_, SizeIs(2)) << "of before there were pictures: hello and subscribe";
  ClientExtension other{options_, watcher_, history_,
                        [this](const Parts& parts) { sent_.push_back(parts); }};
  other.OnMessage({sent_.back()[0] + std::string(16, 'i'),
                   R"({"protocol":1,"pictures":true,"trees":[{"tree":0,"name":"Main"}]})"},
                  1s);
  ASSERT_THAT(sent_, SizeIs(5));
  EXPECT_EQ(Json::parse(sent_[3][1])["do"], "pictures");
  EXPECT_EQ(Json::parse(sent_[4][1])["do"], "subscribe");
}

TEST_F(ClientExtensionTest, TellsThePicturesThatKeepTheLimits) {
  options_.with_pictures = true;
  Connect();
  const auto show = [&](const std::string& members) {
    Push('E', R"({"event":"picture",)" + members + "}");
  };
  show(R"("name":"face","text":"SAD","width":2,"height":1,"rgb":"00ff1020304a")");
  ASSERT_EQ(Shown(), "face 2x1 ");
  EXPECT_EQ(watcher_.watched().pictures[0],
            (LivePicture{"face", "SAD", 2, 1, {0, 255, 16, 32, 48, 74}}));
  // Whatever else a robot sends is not handed on, and is no reason to leave it.
  show(R"("name":"face","width":2,"height":2,"rgb":"00ff1020304a")");
  show(R"("name":"face","width":4294967297,"height":1,"rgb":"00ff10")");
  show(R"("name":"face","width":-1,"height":-1,"rgb":"00ff10")");
  show(R"("name":"face","width":1e300,"height":1,"rgb":"00ff10")");
  show(R"("name":"face","width":1,"height":1,"rgb":"00ff1")");
  show(R"("name":"face","width":1,"height":1,"rgb":"00FF1g")");
  show(R"("name":"face","width":1,"height":1,"rgb":[0,255,16])");
  show(R"("name":7,"width":1,"height":1,"rgb":"00ff10")");
  show(R"("width":1,"height":1,"rgb":"00ff10")");
  show(R"("name":"wall","width":64,"height":65,"rgb":")" + std::string(64 * 65 * 6, '0') + "\"");
  Push('E', R"({"event":"picture"})");
  Push('E', R"(["picture"])");
  EXPECT_EQ(Shown(), "face 2x1 ");
  for (int i = 0; i < 20; ++i) {
    show(R"("width":1,"height":1,"rgb":"000000","name":"lamp)" + std::to_string(i) + "\"");
  }
  EXPECT_THAT(watcher_.watched().pictures, SizeIs(PictureSet::kMostPictures));
  EXPECT_EQ(session_.failure(), "");
  EXPECT_TRUE(session_.is_live());
}

TEST_F(ClientExtensionTest, PicturesThatNobodyAskedForAreNotTold) {
  Connect();
  Push('E', R"({"event":"picture","name":"face","width":1,"height":1,"rgb":"00ff10"})");
  EXPECT_EQ(Shown(), "");
}

TEST_F(ClientExtensionTest, GivesUpARobotThatDoesNotKnowTheExtension) {
  session_.OnMessage({"error", "Request not recognized"}, 1s);
  EXPECT_TRUE(session_.is_wrong_protocol());
}

TEST_F(ClientExtensionTest, GivesUpARobotOfAnotherVersion) {
  Answer({{"protocol", 9}});
  EXPECT_THAT(session_.failure(), HasSubstr("version 9"));
  EXPECT_FALSE(session_.is_wrong_protocol());
}

TEST_F(ClientExtensionTest, GivesUpARobotThatDoesNotAnswerAnyMore) {
  Connect();
  EXPECT_EQ(session_.OnTime(1500ms), 2500ms);
  EXPECT_EQ(Asked()["do"], "ping");
  session_.OnTime(2500ms);
  session_.OnTime(3500ms);
  EXPECT_EQ(session_.failure(), "");
  session_.OnTime(4500ms);
  EXPECT_NE(session_.failure(), "");
}

TEST_F(ClientExtensionTest, KeepsARobotWhenItWasHeldUpItself) {
  Connect();
  session_.OnTime(1500ms);
  session_.OnTime(60s);  // the computer slept
  EXPECT_EQ(session_.failure(), "");
  for (const Duration now : {61s, 62s}) session_.OnTime(now);
  EXPECT_EQ(session_.failure(), "");
  session_.OnTime(63s);
  EXPECT_NE(session_.failure(), "");
}

TEST_F(ClientExtensionTest, HandsRepliesToThoseWhoAsked) {
  Connect();
  LiveReply got = Problem{"none yet"};
  session_.Send(MakeCommand(LiveCommand::Kind::kPause), [&](const LiveReply& r) { got = r; });
  EXPECT_EQ(Asked()["do"], "pause");
  Answer(Json::object());
  EXPECT_EQ(got.problem(), "");
  session_.Send(MakeCommand(LiveCommand::Kind::kPause), [&](const LiveReply& r) { got = r; });
  Answer({{"error", "the robot moves"}, {"reason", "refused"}});
  EXPECT_EQ(got.problem(), "the robot moves");
  session_.Send(MakeCommand(LiveCommand::Kind::kPause), [&](const LiveReply& r) { got = r; });
  session_.Abandon("gone");
  EXPECT_EQ(got.problem(), "gone");
}

TEST_F(ClientExtensionTest, BeginsAnewWhenTheRobotHasGivenItUp) {
  Connect();
  Push('E', R"({"event":"released","text":"nothing was heard"})");
  EXPECT_NE(session_.failure(), "");
}

TEST_F(ClientExtensionTest, TakesLeave) {
  Connect();
  session_.Leave();
  EXPECT_EQ(Asked()["do"], "bye");
}

TEST_F(ClientExtensionTest, IsNotDisturbedByNonsense) {
  Connect();
  std::mt19937 random(5);
  for (int i = 0; i < 5000; ++i) {
    Parts parts(1 + random() % 3);
    for (std::string& part : parts) {
      part.resize(random() % 3 ? 22 : random() % 60);
      for (char& c : part) c = static_cast<char>(random());
    }
    if (parts[0].size() > 1)
      parts[0].replace(0, 2, random() % 2 ? std::string{2, 'F'} : std::string{2, 'E'});
    session_.OnMessage(parts, 1s);
  }
  EXPECT_THAT(watcher_.watched().ticks, SizeIs(0));
}

}  // namespace
}  // namespace coppice
