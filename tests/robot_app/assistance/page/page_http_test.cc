#include "robot_app/assistance/page/page_http.h"

#include <gmock/gmock.h>

namespace coppice::robot::assistance {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SessionCookie, IsFoundAmongOthers) {
  EXPECT_EQ(SessionOf("coppice_session=abc"), "abc");
  EXPECT_EQ(SessionOf("a=b; coppice_session=abc; c=d"), "abc");
  EXPECT_EQ(SessionOf("a=coppice_session=abc"), "");
  EXPECT_EQ(SessionOf("xcoppice_session=abc"), "");
  EXPECT_EQ(SessionOf(";;=;coppice_session"), "");
  EXPECT_EQ(SessionOf(""), "");
}

TEST(SessionCookie, IsKeptFromScriptsAndOtherSites) {
  EXPECT_THAT(SetSessionCookie("abc", false), HasSubstr("HttpOnly; SameSite=Strict"));
  EXPECT_THAT(SetSessionCookie("abc", false), Not(HasSubstr("Secure")));
  EXPECT_THAT(SetSessionCookie("abc", true), HasSubstr("Secure"));
  EXPECT_THAT(SetSessionCookie("", false), HasSubstr("Max-Age=0"));
}

TEST(TokenOf, IsEmptyIfThereIsNone) {
  EXPECT_EQ(TokenOf(R"({"token": "abc"})"), "abc");
  for (const char* const body : {"", "abc", "{}", R"({"token": 1})", R"(["token"])", "\xff"}) {
    EXPECT_EQ(TokenOf(body), "");
  }
}

}  // namespace
}  // namespace coppice::robot::assistance
