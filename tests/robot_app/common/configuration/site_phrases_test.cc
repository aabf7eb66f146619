#include "robot_app/common/configuration/site_phrases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot {
namespace {

using leaves::Phrase;
using testing::HasSubstr;

class SitePhrasesTest : public testing::Test {
 protected:
  SitePhrases Shipped() {
    SitePhrases phrases(SourceFolder() + "/robot_app/config/phrases.yaml", diagnostics_,
                        [this] { return minute_; });
    EXPECT_FALSE(diagnostics_.has_errors()) << diagnostics_.ToString();
    return phrases;
  }

  int minute_ = 12 * 60;
  Diagnostics diagnostics_;
  TemporaryFolder folder_;
};

TEST_F(SitePhrasesTest, GreetsByTheTimeOfDay) {
  SitePhrases phrases = Shipped();
  const auto greeting = [&](int hour, const char* language) {
    minute_ = hour * 60;
    return phrases.Text(Phrase::GREETING, language, "");
  };
  EXPECT_THAT(greeting(8, "de"), HasSubstr("Guten Morgen"));
  EXPECT_THAT(greeting(12, "de"), HasSubstr("Guten Tag"));
  EXPECT_THAT(greeting(20, "en"), HasSubstr("Good evening"));
  EXPECT_THAT(greeting(3, "en"), HasSubstr("Good evening")) << "still that of the day before";
}

TEST_F(SitePhrasesTest, SpeaksOfWhatItIsAbout) {
  EXPECT_EQ(Shipped().Text(Phrase::ARRIVED, "de", "Mensa"), "Wir sind da: Mensa.");
}

TEST_F(SitePhrasesTest, SpeaksEnglishWhereItLacksALanguage) {
  EXPECT_THAT(Shipped().Text(Phrase::FAREWELL, "fr", ""), HasSubstr("Have a nice day"));
}

TEST_F(SitePhrasesTest, TellsWhereTheFileIsWrong) {
  const std::string path = folder_.path() + "/phrases.yaml";
  std::ofstream(path) << "GREETING:\n  - {from: \"25:00\", en: Hello}\nGRETING: []\n";
  const SitePhrases phrases(path, diagnostics_);
  const std::string problems = diagnostics_.ToString();
  EXPECT_THAT(problems, HasSubstr("phrases.yaml:2:"));
  EXPECT_THAT(problems, HasSubstr("expected a time"));
  EXPECT_THAT(problems, HasSubstr("\"de\""));
  EXPECT_THAT(problems, HasSubstr("expected the phrase FAREWELL"));
  EXPECT_THAT(problems, HasSubstr("GRETING"));
}

}  // namespace
}  // namespace coppice::robot
