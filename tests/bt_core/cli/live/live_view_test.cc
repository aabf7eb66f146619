#include "bt_core/cli/live/live_view.h"

#include <cstdlib>

#include "bt_core/live/server/live_publisher.h"
#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class LiveViewTest : public CliTest {
 protected:
  int RunTreeWith(Arguments options) {
    options.insert(options.begin(), WriteTree("<AlwaysSuccess/>"));
    return CliTest::Run(RunTree, options);
  }
};

TEST_F(LiveViewTest, ListensNowhereUnlessAsked) {
  EXPECT_EQ(RunTreeWith({}), 0);
  EXPECT_EQ(err_, "");
}

TEST_F(LiveViewTest, SaysWhereItListens) {
  EXPECT_EQ(RunTreeWith({"--live", "--live-port", "0"}), 0);
  EXPECT_EQ(err_.find("live view on 127.0.0.1:"), 0u) << err_;
}

TEST_F(LiveViewTest, PrintsTheTokenOfReaders) {
  setenv("COPPICE_LIVE_TOKEN", "a token for tests", 1);
  EXPECT_EQ(RunTreeWith({"--live-port", "0", "--live-address", "*"}), 0);
  unsetenv("COPPICE_LIVE_TOKEN");
  EXPECT_NE(err_.find("token for those who only watch: read-"), std::string::npos) << err_;
  EXPECT_EQ(err_.find("a token for tests"), std::string::npos);
}

TEST_F(LiveViewTest, RefusesOtherAddressesWithoutAToken) {
  EXPECT_EQ(RunTreeWith({"--live-port", "0", "--live-address", "*"}), 2);
  EXPECT_NE(err_.find("COPPICE_LIVE_TOKEN"), std::string::npos) << err_;
}

TEST_F(LiveViewTest, RefusesWhatIsNoNumber) {
  EXPECT_EQ(RunTreeWith({"--live-port", "70000"}), 2);
  EXPECT_NE(err_.find("--live-port: expected a whole number from 0 to 65534"), std::string::npos);
  EXPECT_EQ(RunTreeWith({"--live", "--wait-for-client", "soon"}), 2);
}

class WebViewTest : public LiveViewTest {
 protected:
  int RunWithPages() {
    return RunTreeWith(
        {"--live-port", "0", "--web", "--web-port", "0", "--web-folder", folder_.string()});
  }
};

TEST_F(WebViewTest, WithoutThePageItSaysSoAndGivesNoAddressForBrowsers) {
  EXPECT_EQ(RunWithPages(), 0);
  EXPECT_NE(err_.find("no page for browsers"), std::string::npos) << err_;
  EXPECT_EQ(err_.find("http://"), std::string::npos) << err_;
}

TEST_F(WebViewTest, WithThePageItSaysWhereItIs) {
  Write("index.html", "<html></html>");
  EXPECT_EQ(RunWithPages(), 0);
  EXPECT_NE(err_.find("in a browser: http://127.0.0.1:"), std::string::npos) << err_;
}

}  // namespace
}  // namespace coppice
