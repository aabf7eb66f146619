#include "robot_app/speech/ear/recognizer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>

#include "robot_app/knowledge/store/queries.h"
#include "robot_app/speech/mouth/synthesizer.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"
#include "tests/robot_app/speech/noisy_speech.h"

namespace coppice::robot::speech {
namespace {

using knowledge::Language;

class RecognizerTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    knowledge::SampleDatabase sample;
    const auto& files = knowledge::ShippedLanguageFiles();
    const auto names = knowledge::Names(*sample);
    const auto& words = In(Language::kEnglish, files.words);
    recognizer_ = Recognizer::Make(kEnglishModel, {files.intents, words, names}).value();
  }
  static void TearDownTestSuite() { recognizer_.reset(); }

  static Sound Said(const std::string& text) {
    return InNoise(Synthesizer().Speak(text, {"en-us+f2", 140})->sound, 30, 1);
  }
  static std::string Heard(const std::string& text) {
    return BestOf(recognizer_->Recognize(Said(text)));
  }
  static std::string Replied(const std::string& text) {
    return BestOf(recognizer_->RecognizeReply(Said(text), {"Anna Weber", "Paul Weber"}));
  }
  static std::string BestOf(const std::vector<knowledge::Alternative>& alternatives) {
    return alternatives.empty() ? "" : alternatives.front().text;
  }

  static std::unique_ptr<Recognizer> recognizer_;
};
std::unique_ptr<Recognizer> RecognizerTest::recognizer_;

TEST_F(RecognizerTest, HearsWhatWasSaid) {
  EXPECT_EQ(Heard("how do I get to the copy shop"), "how do i get to the copy shop");
  EXPECT_EQ(Heard("take me to the sports hall"), "take me to the sports hall");
}

TEST_F(RecognizerTest, HearsANameThatIsInNoDictionary) {
  EXPECT_EQ(Heard("the next bus to Erlensee"), "the next bus to erlensee");
}

TEST_F(RecognizerTest, HearsARoomByItsNumber) {
  const std::string heard = Heard("who works in office two oh three");
  EXPECT_NE(heard.find("203"), std::string::npos) << heard;
}

TEST_F(RecognizerTest, HearsWhatIsRepliedToAQuestionBack) {
  EXPECT_EQ(Replied("yes"), "yes");
  EXPECT_EQ(Replied("no thanks"), "no thanks");
  EXPECT_EQ(Replied("the second one"), "the second one");
  EXPECT_EQ(Replied("Paul Weber"), "paul weber");
}

TEST_F(RecognizerTest, WhatIsNoReplyIsHeardAsSomethingNew) {
  EXPECT_EQ(Replied("take me to the sports hall"), "");
  EXPECT_EQ(Heard("take me to the sports hall"), "take me to the sports hall");
}

TEST_F(RecognizerTest, SilenceIsNothing) {
  const Sound silence{kHearingRate, std::vector<std::int16_t>(16000)};
  EXPECT_TRUE(recognizer_->Recognize(silence).empty());
  EXPECT_TRUE(recognizer_->Recognize({kHearingRate, {}}).empty());
}

// As on a full disk: what is written ends in the middle.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }

 private:
  rlimit before_{};
};

// Of one intent, without names: what all that people may say takes seconds to make.
class FewWords : public testing::Test {
 protected:
  Expected<std::unique_ptr<Recognizer>> Make() const {
    const auto& words = In(Language::kEnglish, knowledge::ShippedLanguageFiles().words);
    return Recognizer::Make(kEnglishModel, {intents_, words, {}});
  }

 private:
  const knowledge::IntentTable intents_ = {knowledge::ShippedLanguageFiles().intents.back()};
};

TEST_F(FewWords, WithoutRoomForThemAreAProblemAndNoCrash) {
  for (const rlim_t bytes : {0, 4096, 20'000}) {
    const SmallFiles full(bytes);
    EXPECT_EQ(Make().problem(), "there is no room for the words of the site") << bytes;
  }
}

TEST_F(FewWords, WhereTemporaryFilesCannotBeAreInMemory) {
  setenv("TMPDIR", "/nowhere", 1);
  const auto made = Make();
  unsetenv("TMPDIR");
  EXPECT_TRUE(made) << made.problem();
}

TEST(Recognizer, AModelThatIsNotThereIsAProblem) {
  const auto& files = knowledge::ShippedLanguageFiles();
  const auto made =
      Recognizer::Make("/nowhere", {files.intents, In(Language::kEnglish, files.words), {}});
  EXPECT_EQ(made.problem(), "cannot read the dictionary /nowhere/cmudict-en-us.dict");
}

}  // namespace
}  // namespace coppice::robot::speech
