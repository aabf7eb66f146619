#include "robot_app/speech/ear/recognizer.h"

#include <gtest/gtest.h>

#include "robot_app/knowledge/store/queries.h"
#include "robot_app/speech/mouth/synthesizer.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"

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

  static std::string Heard(const std::string& text) {
    Sound sound = Synthesizer().Speak(text, {"en-us+f2", 140})->sound;
    const std::vector<std::int16_t> silence(static_cast<std::size_t>(sound.rate) / 3);
    sound.samples.insert(sound.samples.begin(), silence.begin(), silence.end());
    sound.samples.insert(sound.samples.end(), silence.begin(), silence.end());
    const auto alternatives = recognizer_->Recognize(sound);
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

TEST_F(RecognizerTest, SilenceIsNothing) {
  const Sound silence{kHearingRate, std::vector<std::int16_t>(16000)};
  const auto heard = recognizer_->Recognize(silence);
  for (const knowledge::Alternative& alternative : heard) EXPECT_EQ(alternative.text, "");
  EXPECT_TRUE(recognizer_->Recognize({kHearingRate, {}}).empty());
}

TEST(Recognizer, AModelThatIsNotThereIsAProblem) {
  const auto& files = knowledge::ShippedLanguageFiles();
  const auto made =
      Recognizer::Make("/nowhere", {files.intents, In(Language::kEnglish, files.words), {}});
  EXPECT_EQ(made.problem(), "cannot read the dictionary /nowhere/cmudict-en-us.dict");
}

}  // namespace
}  // namespace coppice::robot::speech
