#include "robot_app/assistance/channels/message_text.h"

#include <gmock/gmock.h>

#include "bt_core/model/utf8.h"

namespace coppice::robot::assistance {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(MessageText, KeepsLinesButNoOtherControlCharacters) {
  EXPECT_EQ(MessageText("a\nb\tc\x07"
                        "d\r\n"),
            "a\nb c d \n");
}

TEST(MessageText, IsAlwaysValidUtf8AndNotLong) {
  EXPECT_EQ(MessageText("caf\xe9!"), "caf\xef\xbf\xbd!");
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "\xc3\xa4";
  const std::string shortened = MessageText(text);
  EXPECT_LE(shortened.size(), kMostMessageBytes);
  EXPECT_EQ(FindInvalidUtf8(shortened), shortened.size());
}

TEST(OneLine, HasNoEndOfLine) { EXPECT_EQ(OneLine("a\r\nBcc: x@y\n.\n"), "a  Bcc: x@y . "); }

TEST(MailHeader, CannotEndTheHeader) {
  EXPECT_THAT(MailHeader("stuck\r\nBcc: thief@example.org"), Not(HasSubstr("\n")));
}

TEST(MailHeader, IsAnEncodedWordIfItIsNotAscii) {
  EXPECT_EQ(MailHeader("plain"), "plain");
  EXPECT_EQ(MailHeader("B\xc3\xbcro"), "=?UTF-8?B?QsO8cm8=?=");
  const std::string header = MailHeader("\xc3\xbc" + std::string(120, 'x'));
  EXPECT_THAT(header, HasSubstr("?= =?UTF-8?B?"));
}

TEST(MailAddress, IsRefusedIfItCouldMeanSomethingElse) {
  EXPECT_EQ(MailAddress("ada@example.org"), "ada@example.org");
  for (const char* const bad :
       {"", "ada", "a@b@c", "ada@x>\r\nDATA", "a b@c", "<a@b>", "a@b,c@d", "a\xc3\xa4@b\n"}) {
    EXPECT_EQ(MailAddress(bad), "") << bad;
  }
}

}  // namespace
}  // namespace coppice::robot::assistance
