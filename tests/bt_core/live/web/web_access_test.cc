#include "bt_core/live/web/web_access.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice {
namespace {

using ::testing::HasSubstr;

WebVisitor FromPage(std::string_view host, std::string_view origin) {
  return {host, origin, "coppice-live"};
}

bool IsLetIn(const WebVisitor& visitor) { return WebAccess().Judge(visitor).ok(); }

TEST(WebAccess, LetsTheOwnPageOnThisComputerIn) {
  for (const char* host : {"localhost:8667", "127.0.0.1:8667", "[::1]:8667", "localhost"}) {
    EXPECT_TRUE(IsLetIn(FromPage(host, std::string("http://") + host))) << host;
  }
  EXPECT_EQ(WebAccess().Judge(FromPage("localhost:1", "http://localhost:1")).value(),
            WebRole::kControl);
}

TEST(WebAccess, LetsProgramsThatAreNoBrowserIn) {
  EXPECT_TRUE(IsLetIn(FromPage("127.0.0.1:8667", "")));
}

TEST(WebAccess, RefusesPagesOfOthers) {
  for (const char* origin : {"http://evil.example", "http://localhost:80", "null", "http://",
                             "http://localhost:8667.evil.example", "ftp://localhost:8667"}) {
    EXPECT_THAT(WebAccess().Judge(FromPage("localhost:8667", origin)).problem(),
                HasSubstr("another origin"))
        << origin;
  }
}

TEST(WebAccess, RefusesForeignNamesOfThisComputer) {
  for (const char* host : {"evil.example:8667", "127.0.0.1.evil.example", "127.evil", "", ":8667",
                           "192.168.0.1:8667"}) {
    const std::string origin = std::string("http://") + host;
    EXPECT_THAT(WebAccess().Judge(FromPage(host, origin)).problem(), HasSubstr("only localhost"))
        << host;
  }
}

TEST(WebAccess, WantsTheProtocolToBeNamed) {
  EXPECT_THAT(WebAccess().Judge({"localhost", "", ""}).problem(), HasSubstr("coppice-live"));
  EXPECT_TRUE(WebAccess().Judge({"localhost", "", "chat , coppice-live"}).ok());
}

TEST(WebAccess, GivesTheRoleOfTheToken) {
  const WebAccess access({"secret", "glance"});
  const Expected<WebRole> control = access.Judge({"robot:1", "", "coppice-live, token.secret"});
  EXPECT_EQ(control.value(), WebRole::kControl);
  const Expected<WebRole> read =
      access.Judge({"robot:1", "https://robot:1", "token.glance,coppice-live"});
  EXPECT_EQ(read.value(), WebRole::kRead);
}

TEST(WebAccess, RefusesOtherTokensAlsoOnThisComputer) {
  const WebAccess access({"secret", "glance"});
  for (const char* protocols :
       {"coppice-live", "coppice-live, token.", "coppice-live, token.Secret",
        "coppice-live, token.secrets", "coppice-live, secret"}) {
    EXPECT_THAT(access.Judge({"localhost:1", "", protocols}).problem(), HasSubstr("token"))
        << protocols;
  }
  EXPECT_THAT(access.Judge({"robot", "http://evil", "coppice-live, token.secret"}).problem(),
              HasSubstr("another origin"));
}

TEST(WebAccess, ANameOfTheWorldIsNoLocalOne) {
  for (const char* const host : {"localhost", "127.0.0.1:8091", "10.0.0.2", "[::1]:80", "sobi:8091",
                                 "sobi.local", "sobi.local:8091"}) {
    EXPECT_TRUE(IsLocalName(host)) << host;
  }
  for (const char* const host : {"", ":80", ".local", "evil.example", "127.0.0.1.nip.example:80",
                                 "local.evil.example", "evil.example.:80"}) {
    EXPECT_FALSE(IsLocalName(host)) << host;
  }
}

}  // namespace
}  // namespace coppice
