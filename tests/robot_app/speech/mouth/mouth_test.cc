#include "robot_app/speech/mouth/mouth.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <future>
#include <map>
#include <new>
#include <thread>

#include "robot_app/speech/sound/wav_file.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::speech {
namespace {

using testing::ElementsAre;

// A mouth with the voice of espeak-ng on simulated time.
class MouthTest : public testing::Test {
 protected:
  // Until something other than a word has happened to that id; moves the clock.
  MouthEvent EndOf(std::int64_t id) {
    while (std::chrono::steady_clock::now() < deadline_) {
      for (const MouthEvent& event : mouth_.Update()) Note(event);
      if (ends_.count(id) > 0) return ends_[id];
      if (mouth_.text().empty()) {
        std::this_thread::yield();  // the voice is at work
      } else {
        clock_.Advance(std::chrono::milliseconds(20));
      }
    }
    return {};
  }
  void Note(const MouthEvent& event) {
    if (event.kind == MouthEvent::Kind::kWord) {
      words_.push_back(event.word);
    } else {
      ends_[event.id] = event;
    }
  }
  void WaitUntilItSays(const std::string& text) {
    while (std::chrono::steady_clock::now() < deadline_ && mouth_.text() != text) {
      for (const MouthEvent& event : mouth_.Update()) Note(event);
      std::this_thread::yield();
    }
    ASSERT_EQ(mouth_.text(), text);
  }

  const std::chrono::steady_clock::time_point deadline_ =
      std::chrono::steady_clock::now() + std::chrono::seconds(60);
  SimulatedClock clock_;
  TemporaryFolder folder_;
  ClockedOutput output_{clock_, folder_.Path("said")};
  Synthesizer voice_;
  Mouth mouth_{[this](const std::string& text, const std::string&) {
                 return voice_.Speak(text, {"en-us", 150});
               },
               output_};
  std::vector<SpokenWord> words_;
  std::map<std::int64_t, MouthEvent> ends_;
};

TEST_F(MouthTest, ASayingEndsWhenItsSoundHasBeenPlayed) {
  mouth_.Add({1, "Follow me, please.", "en", 0});
  EXPECT_EQ(EndOf(1).kind, MouthEvent::Kind::kPlayed);
  const auto played = ReadWav(folder_.Path("said/0001.wav"));
  ASSERT_TRUE(played) << played.problem();
  EXPECT_GT(played->seconds(), 0.8);
  EXPECT_NEAR(std::chrono::duration<double>(clock_.Now() - Time{}).count(), played->seconds(), 0.1);
}

TEST_F(MouthTest, TellsEachWordWithItsPlaceInTheText) {
  const std::string text = "Über Büro 5";
  mouth_.Add({1, text, "de", 0});
  EndOf(1);
  std::vector<std::string> said;
  for (const SpokenWord& word : words_) said.push_back(text.substr(word.begin, word.length));
  EXPECT_THAT(said, ElementsAre("Über", "Büro", "5"));
}

TEST_F(MouthTest, CancelledItIsSilentWithinATenthOfASecond) {
  mouth_.Add({1, "This sentence is long enough to be stopped in the middle of it.", "en", 0});
  WaitUntilItSays("This sentence is long enough to be stopped in the middle of it.");
  clock_.Advance(std::chrono::milliseconds(700));
  mouth_.Cancel(1);
  EXPECT_EQ(EndOf(1).kind, MouthEvent::Kind::kCancelled);
  EXPECT_NEAR(ReadWav(folder_.Path("said/0001.wav"))->seconds(), 0.7, 0.1);
  EXPECT_FALSE(mouth_.speaks());
}

TEST_F(MouthTest, TheMoreUrgentCutsWhatIsBeingSaid) {
  mouth_.Add({1, "All quiet here, nothing to be seen.", "en", 0});
  WaitUntilItSays("All quiet here, nothing to be seen.");
  mouth_.Add({2, "Careful!", "en", 200});
  EXPECT_EQ(EndOf(2).kind, MouthEvent::Kind::kPlayed);
  EXPECT_EQ(ends_[1].kind, MouthEvent::Kind::kCut);
}

TEST_F(MouthTest, WhatWaitsIsSaidByPriorityAndThenByAge) {
  mouth_.Add({1, "one", "en", 100});
  mouth_.Add({2, "two", "en", 0});
  mouth_.Add({3, "three", "en", 100});
  WaitUntilItSays("one");
  EndOf(1);
  WaitUntilItSays("three");
  EndOf(3);
  WaitUntilItSays("two");
  EXPECT_EQ(EndOf(2).kind, MouthEvent::Kind::kPlayed);
}

TEST_F(MouthTest, WhatTheVoiceCannotSayHasFailedAndTheNextIsSaid) {
  Mouth mouth(
      [this](const std::string& text, const std::string&) {
        return voice_.Speak(text, {text == "bad" ? "no-such-voice" : "en-us", 150});
      },
      output_);
  mouth.Add({1, "bad", "en", 0});
  mouth.Add({2, "good", "en", 0});
  std::map<std::int64_t, MouthEvent> ends;
  while (std::chrono::steady_clock::now() < deadline_ && ends.count(2) == 0) {
    for (const MouthEvent& event : mouth.Update()) ends[event.id] = event;
    clock_.Advance(std::chrono::milliseconds(mouth.text().empty() ? 0 : 20));
    if (mouth.text().empty()) std::this_thread::yield();
    if (ends.count(2) > 0 && ends[2].kind == MouthEvent::Kind::kWord) ends.erase(2);
  }
  EXPECT_EQ(ends[1].kind, MouthEvent::Kind::kFailed);
  EXPECT_NE(ends[1].message.find("no-such-voice"), std::string::npos);
  EXPECT_EQ(ends[2].kind, MouthEvent::Kind::kPlayed);
}

TEST_F(MouthTest, TooMuchAtOnceHasFailed) {
  for (int id = 1; id <= 18; ++id) mouth_.Add({id, "word", "en", 0});
  EXPECT_EQ(EndOf(18).kind, MouthEvent::Kind::kFailed);
}

TEST_F(MouthTest, WhatIsUrgentIsSaidHoweverMuchWaits) {
  for (int id = 1; id <= 40; ++id) mouth_.Add({id, "word", "en", 0});
  mouth_.Add({41, "Careful!", "en", 200});
  EXPECT_EQ(EndOf(41).kind, MouthEvent::Kind::kPlayed);
}

TEST_F(MouthTest, AVoiceThatThrowsHasFailed) {
  Mouth mouth(
      [](const std::string&, const std::string&) -> Expected<Speech> { throw std::bad_alloc(); },
      output_);
  mouth.Add({1, "word", "en", 0});
  std::vector<MouthEvent> events;
  while (std::chrono::steady_clock::now() < deadline_ && events.empty()) events = mouth.Update();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, MouthEvent::Kind::kFailed);
}

// Each more urgent than the one before: none of their sounds is waited for.
TEST_F(MouthTest, FewSoundsAreMadeAtOnceHoweverOftenItIsInterrupted) {
  std::atomic<int> at_work{0}, most{0};
  std::promise<void> go_on;
  const std::shared_future<void> waits = go_on.get_future().share();
  {
    Mouth mouth(
        [&](const std::string&, const std::string&) -> Expected<Speech> {
          const int now = ++at_work;
          if (now > most) most = now;
          waits.wait();
          --at_work;
          return Problem{"nothing"};
        },
        output_);
    for (int id = 1; id <= 200; ++id) mouth.Add({id, "word", "en", id});
    std::size_t failed = 0;
    go_on.set_value();
    while (std::chrono::steady_clock::now() < deadline_ && mouth.speaks()) {
      failed += mouth.Update().size();
    }
    EXPECT_EQ(failed, 200u);
  }
  EXPECT_LE(most, static_cast<int>(Mouth::kMostAbandoned) + 1);
}

}  // namespace
}  // namespace coppice::robot::speech
