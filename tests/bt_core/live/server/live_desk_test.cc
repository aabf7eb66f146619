#include "bt_core/live/server/live_desk.h"

#include "tests/bt_core/live/desk_fixture.h"

namespace coppice {
namespace {

using groot2::Parts;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Json = nlohmann::json;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class LiveDeskTest : public LiveTreeFixture {
 protected:
  LiveDeskTest() { desk_.Add(tree_, now_); }
  ~LiveDeskTest() override { desk_.Remove(*tree_); }

  Parts Ask(ClientId client, const Parts& request) {
    desk_.Serve(client, true, request, now_);
    const std::vector<Parts> sent = outbox_.Take(client);
    return sent.empty() ? Parts{} : sent.back();
  }
  Json Extension(ClientId client, const std::string& request) {
    const Parts reply = Ask(client, {groot2::MakeHeader('C', 9), request});
    return reply.size() == 2 ? Json::parse(reply[1]) : Json("no reply");
  }
  // The notices and pushes that Attend sends: "E stopped", "F 1-3".
  std::vector<std::string> Attend(ClientId client) {
    desk_.Attend(now_, now_);
    std::vector<std::string> result;
    for (const Parts& parts : outbox_.Take(client)) {
      const char kind = parts[0][1];
      if (kind == 'E') result.push_back("E " + Json::parse(parts[1])["event"].get<std::string>());
      if (kind == 'F') {
        result.push_back("F " + std::to_string(parts[1][0]) + "-" + std::to_string(parts[1][8]));
      }
    }
    return result;
  }

  Duration now_ = 1s;
  KeepingOutbox outbox_;
  LiveDesk desk_{outbox_, 5s};
};

TEST_F(LiveDeskTest, AnswersBothProtocols) {
  EXPECT_EQ(Ask(kAnn, {groot2::MakeHeader('S', 3)}).at(0).substr(0, 6), groot2::MakeHeader('S', 3));
  EXPECT_EQ(Extension(kAnn, R"({"do": "hello"})")["protocol"], 1);
  EXPECT_THAT(Ask(kAnn, {"x"}), ElementsAre("error", "wrong request header"));
}

TEST_F(LiveDeskTest, DoesNotReplyToNumber0UnlessItFails) {
  Extension(kAnn, R"({"do": "hello"})");
  EXPECT_THAT(Ask(kAnn, {groot2::MakeHeader('C', 0), R"({"do": "ping"})"}), IsEmpty());
  EXPECT_THAT(Ask(kAnn, {groot2::MakeHeader('C', 0), R"({"do": "dance"})"}), SizeIs(2));
}

TEST_F(LiveDeskTest, PushesFramesAsTheyCome) {
  Extension(kAnn, R"({"do": "hello"})");
  Extension(kAnn, R"({"do": "subscribe"})");
  EXPECT_THAT(Attend(kAnn), ElementsAre("F 1-2"));
  EXPECT_THAT(Attend(kAnn), IsEmpty());
  Tick(3);
  EXPECT_THAT(Attend(kAnn), ElementsAre("F 2-3"));
}

TEST_F(LiveDeskTest, SendsLaterWhatAClientDoesNotTake) {
  Extension(kAnn, R"({"do": "hello"})");
  Extension(kAnn, R"({"do": "subscribe"})");
  outbox_.results[kAnn] = SendResult::kFull;
  EXPECT_LE(desk_.Attend(now_, now_), now_ + 10ms) << "tries again soon";
  Tick();
  outbox_.results[kAnn] = SendResult::kSent;
  EXPECT_THAT(Attend(kAnn), ElementsAre("F 1-3"));
}

TEST_F(LiveDeskTest, AnswersAClientThatHasNotYetReadWhatNobodyAskedFor) {
  Extension(kAnn, R"({"do": "hello"})");
  outbox_.results[kAnn] = SendResult::kFull;
  EXPECT_EQ(Extension(kAnn, R"({"do": "ping"})"), Json::object());
}

TEST_F(LiveDeskTest, AsksForTheRoleWithEveryRequest) {
  Extension(kAnn, R"({"do": "hello"})");
  desk_.Serve(kAnn, false, {groot2::MakeHeader('C', 9), R"({"do": "pause"})"}, now_);
  EXPECT_EQ(Json::parse(outbox_.Take(kAnn).at(0).at(1))["role"], "control");
  EXPECT_FALSE(tree_->debugger().is_pausing());
}

TEST_F(LiveDeskTest, ReleasesAClientThatHasGoneOrIsSilent) {
  for (const ClientId client : {kAnn, kBen, kCem}) {
    Extension(client, R"({"do": "hello"})");
    Extension(client, R"({"do": "subscribe"})");
    Extension(client, R"({"do": "hook", "node": 1})");
  }
  EXPECT_THAT(tree_->debugger().hooks(), SizeIs(3));
  outbox_.results[kAnn] = SendResult::kGone;
  desk_.Attend(now_, now_);
  EXPECT_THAT(tree_->debugger().hooks(), SizeIs(2));
  now_ += 4s;
  Extension(kCem, R"({"do": "ping"})");
  now_ += 1s;
  EXPECT_THAT(Attend(kBen), ElementsAre("F 1-2", "E released"));
  EXPECT_THAT(tree_->debugger().hooks(), SizeIs(1));
}

TEST_F(LiveDeskTest, NobodyIsDeadWhoseRequestMayStillWait) {
  Extension(kAnn, R"({"do": "hello"})");
  Extension(kAnn, R"({"do": "hook", "node": 1})");
  desk_.Attend(now_ + 6s, now_ + 4s);
  EXPECT_THAT(tree_->debugger().hooks(), SizeIs(1));
  desk_.Attend(now_ + 10s, now_ + 4s);
  EXPECT_THAT(tree_->debugger().hooks(), IsEmpty()) << "what waits for ever keeps nobody alive";
}

TEST_F(LiveDeskTest, AClientWasAliveWhenItsRequestArrived) {
  Extension(kAnn, R"({"do": "hello"})");
  Extension(kAnn, R"({"do": "hook", "node": 1})");
  desk_.Serve(kAnn, true, {groot2::MakeHeader('C', 9), R"({"do": "ping"})"}, now_ + 1s);
  desk_.Attend(now_ + 6s, now_ + 6s);
  EXPECT_THAT(tree_->debugger().hooks(), IsEmpty());
}

TEST_F(LiveDeskTest, TellsEveryClientWhatTheDebuggerTells) {
  Extension(kAnn, R"({"do": "hello"})");
  Extension(kBen, R"({"do": "hello"})");
  Extension(kBen, R"({"do": "hook", "node": 1, "action": "replace", "status": "FAILURE"})");
  Tick();
  EXPECT_THAT(Attend(kAnn), ElementsAre("E replaced"));
  EXPECT_THAT(outbox_.Take(kBen), SizeIs(1));
  EXPECT_THAT(outbox_.published, IsEmpty()) << "it is no hook of Groot2";
}

TEST_F(LiveDeskTest, PublishesHooksOfGroot2) {
  Ask(kAnn, {groot2::MakeHeader('I', 1),
             R"({"enabled": true, "uid": 2, "mode": 1, "once": false, "desired_status": "FAILURE",
                "position": 0})"});
  Tick();
  desk_.Attend(now_, now_);
  ASSERT_THAT(outbox_.published, SizeIs(1));
  EXPECT_EQ(outbox_.published[0][1], "2");
}

TEST_F(LiveDeskTest, TellsThatATreeCameWentOrHasAnotherProgram) {
  Extension(kAnn, R"({"do": "hello"})");
  executor_.Reload(WatchedProgram());
  stream_.Flush();
  EXPECT_THAT(Attend(kAnn), ElementsAre("E trees"));
  desk_.Remove(*tree_);
  EXPECT_THAT(outbox_.Take(kAnn), SizeIs(1));
  EXPECT_THAT(Ask(kAnn, {groot2::MakeHeader('S', 3)}), ElementsAre("error", HasSubstr("no tree")));
  desk_.Add(tree_, now_);
  EXPECT_THAT(outbox_.Take(kAnn), SizeIs(1));
  EXPECT_THAT(Extension(kAnn, R"({"do": "statistics", "tree": 0})")["error"].get<std::string>(),
              HasSubstr("no tree 0"))
      << "numbers are not used again";
}

TEST_F(LiveDeskTest, SendsTheEndOfATreeThatGoes) {
  Extension(kAnn, R"({"do": "hello"})");
  Extension(kAnn, R"({"do": "subscribe"})");
  Attend(kAnn);
  Tick();
  desk_.Remove(*tree_);
  const std::vector<Parts> sent = outbox_.Take(kAnn);
  ASSERT_THAT(sent, SizeIs(2));  // events and end; the list of trees
  const std::string& frames = sent[0][1];
  EXPECT_EQ(frames[8] - frames[0], 2);
}

class LiveDeskWithPictures : public LiveDeskTest {
 protected:
  LiveDeskWithPictures() { showing_.Add(tree_, now_); }
  ~LiveDeskWithPictures() override { showing_.Remove(*tree_); }

  Json Ask(ClientId client, const std::string& request) {
    showing_.Serve(client, false, {groot2::MakeHeader('C', 9), request}, now_);
    return Json::parse(outbox_.Take(client).back()[1]);
  }
  void Show(const std::string& name, std::uint8_t red) {
    EXPECT_TRUE(pictures_->Show({name, "GREETING", 1, 1, {red, 0, 255}}));
  }
  // "face fe00ff" of each notice.
  std::vector<std::string> Shown(ClientId client) {
    showing_.Attend(now_, now_);
    std::vector<std::string> result;
    for (const Parts& parts : outbox_.Take(client)) {
      const Json notice = Json::parse(parts[1]);
      EXPECT_EQ(notice["event"], "picture");
      EXPECT_EQ(notice["text"], "GREETING");
      EXPECT_EQ(notice["width"], 1);
      EXPECT_EQ(notice["height"], 1);
      result.push_back(notice["name"].get<std::string>() + " " + notice["rgb"].get<std::string>());
    }
    return result;
  }

  const std::shared_ptr<LivePictures> pictures_ = std::make_shared<LivePictures>();
  LiveDesk showing_{outbox_, 5s, pictures_};
};

TEST_F(LiveDeskWithPictures, ShowsThemToReadersWhoAskForThem) {
  Show("face", 0xfe);
  EXPECT_EQ(Ask(kAnn, R"({"do": "hello"})")["pictures"], true);
  Ask(kBen, R"({"do": "hello"})");
  EXPECT_EQ(Ask(kAnn, R"({"do": "pictures"})"), Json::object());
  EXPECT_THAT(Shown(kAnn), ElementsAre("face fe00ff"));
  EXPECT_THAT(outbox_.Take(kBen), IsEmpty()) << "a client of before does not know them";
  EXPECT_THAT(Shown(kAnn), IsEmpty());
  Show("ears", 1);
  Show("face", 2);
  EXPECT_THAT(Shown(kAnn), ElementsAre("ears 0100ff", "face 0200ff"));
}

TEST_F(LiveDeskWithPictures, WhoDoesNotReadIsShownTheNewestLater) {
  Ask(kAnn, R"({"do": "hello"})");
  Ask(kAnn, R"({"do": "pictures"})");
  outbox_.results[kAnn] = SendResult::kFull;
  for (std::uint8_t red = 1; red < 9; ++red) {
    Show("face", red);
    EXPECT_THAT(Shown(kAnn), IsEmpty());
  }
  outbox_.results[kAnn] = SendResult::kSent;
  EXPECT_THAT(Shown(kAnn), ElementsAre("face 0800ff"));
}

TEST_F(LiveDeskWithPictures, AClientThatHasGoneIsForgotten) {
  Ask(kAnn, R"({"do": "hello"})");
  Ask(kAnn, R"({"do": "pictures"})");
  Show("face", 1);
  outbox_.results[kAnn] = SendResult::kGone;
  EXPECT_THAT(Shown(kAnn), IsEmpty());
  outbox_.results.clear();
  EXPECT_EQ(Ask(kAnn, R"({"do": "ping"})")["error"], "say hello first");
}

TEST_F(LiveDeskWithPictures, WithoutPicturesNoneAreOffered) {
  EXPECT_EQ(Extension(kAnn, R"({"do": "hello"})")["pictures"], false);
  EXPECT_EQ(Extension(kAnn, R"({"do": "pictures"})"), Json::object());
  EXPECT_THAT(Attend(kAnn), IsEmpty());
}

TEST(LiveDesk, LetsATreeThatWaitsForAClientGoOnAfterAWhile) {
  LiveTreeOptions options;
  options.wait_for_client = 10s;
  struct Tree : LiveTreeFixture {
    explicit Tree(const LiveTreeOptions& options) : LiveTreeFixture(options) {}
    void TestBody() override {}
    using LiveTreeFixture::tree_;
  };
  const Tree tree(options);
  KeepingOutbox outbox;
  LiveDesk desk(outbox, 5s);
  EXPECT_TRUE(tree.tree_->debugger().Pause(LiveTree::kWaitOwner));
  desk.Add(tree.tree_, 1s);
  desk.Attend(10s, 10s);
  EXPECT_TRUE(tree.tree_->debugger().is_pausing());
  desk.Attend(11s, 11s);
  EXPECT_FALSE(tree.tree_->debugger().is_pausing());
  desk.Remove(*tree.tree_);
}

}  // namespace
}  // namespace coppice
