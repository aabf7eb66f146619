#include "robot_app/metrics/metrics_page.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "robot_app/common/child_process.h"
#include "robot_app/processes/launch/ros_master.h"
#include "tests/bt_core/live/web_caller.h"
#include "tests/robot_app/eventually.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::metrics {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kText = "# TYPE a counter\na_total 7\n";

std::string Get(std::uint16_t port, const std::string& target, const std::string& field = "") {
  WebCaller caller(port);
  return caller.Ask("GET " + target + " HTTP/1.1\r\nHost: localhost\r\n" + field + "\r\n");
}

TEST(MetricsPage, TellsTheFiguresAsPrometheusReadsThem) {
  const MetricsPage page({}, [] { return kText; });
  const std::string header = Get(page.port(), "/metrics");
  EXPECT_THAT(header, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(header, HasSubstr("Content-Type: text/plain; version=0.0.4; charset=utf-8"));
}

TEST(MetricsPage, HasNothingElse) {
  const MetricsPage page({}, [] { return kText; });
  for (const std::string target : {"/", "/metrics/", "/../etc/passwd", "*"}) {
    EXPECT_THAT(Get(page.port(), target), StartsWith("HTTP/1.1 404")) << target;
  }
}

// A name server of somebody else can say so of its own name, for the pages of a browser here.
TEST(MetricsPage, IsNotForANameThatMeansThisComputer) {
  const MetricsPage page({}, [] { return kText; });
  WebCaller caller(page.port());
  EXPECT_THAT(caller.Ask("GET /metrics HTTP/1.1\r\nHost: evil.example:9100\r\n\r\n"),
              StartsWith("HTTP/1.1 403"));
}

TEST(MetricsPage, WantsItsToken) {
  MetricsPageOptions options;
  options.token = "abc";
  const MetricsPage page(options, [] { return kText; });
  EXPECT_THAT(Get(page.port(), "/metrics"), StartsWith("HTTP/1.1 401"));
  EXPECT_THAT(Get(page.port(), "/metrics", "Authorization: Bearer abd\r\n"),
              StartsWith("HTTP/1.1 401"));
  EXPECT_THAT(Get(page.port(), "/metrics", "Authorization: Bearer abc\r\n"),
              StartsWith("HTTP/1.1 200"));
}

TEST(MetricsPage, IsForThisComputerAloneWithoutAToken) {
  MetricsPageOptions options;
  options.address = "0.0.0.0";
  EXPECT_THROW(MetricsPage(options, [] { return kText; }), std::runtime_error);
  options.address = "*";
  EXPECT_THROW(MetricsPage(options, [] { return kText; }), std::runtime_error);
}

// The real Prometheus with the shipped configuration, but for the addresses.
TEST(Prometheus, ReadsThePageAndKnowsTheRules) {
  const MetricsPage page({}, [] {
    return "# TYPE coppice_open_requests gauge\n"
           "coppice_open_requests 1\n";
  });
  const TemporaryFolder folder;
  const std::string shipped = SourceFolder() + "/robot_app/config/prometheus/";
  std::string config = ReadFile(shipped + "prometheus.yml");
  const auto replace = [&](const std::string& what, const std::string& by) {
    ASSERT_NE(config.find(what), std::string::npos) << what;
    config.replace(config.find(what), what.size(), by);
  };
  replace("127.0.0.1:9467", "127.0.0.1:" + std::to_string(page.port()));
  replace("scrape_interval: 5s", "scrape_interval: 200ms");
  replace("evaluation_interval: 5s", "evaluation_interval: 200ms");
  WriteFile(folder.Path("prometheus.yml"), config);
  WriteFile(folder.Path("alerts.yml"), ReadFile(shipped + "alerts.yml"));
  const std::string port = std::to_string(processes::FreePort());
  ChildProcess prometheus(
      {"prometheus", "--config.file=" + folder.Path("prometheus.yml"),
       "--storage.tsdb.path=" + folder.Path("data"), "--web.listen-address=127.0.0.1:" + port},
      folder.Path("log"));
  const auto ask = [&](const std::string& query) {
    try {
      WebCaller caller(static_cast<std::uint16_t>(std::stoi(port)));
      const std::string header =
          caller.Ask("GET /api/v1/query?query=" + query + " HTTP/1.0\r\nHost: localhost\r\n\r\n");
      return header + caller.Rest();
    } catch (const std::runtime_error&) {
      return std::string();  // it is not up yet
    }
  };
  EXPECT_TRUE(Eventually([&] {
    return ask("coppice_open_requests").find(R"("robot":"sobi")") != std::string::npos;
  })) << ReadFile(folder.Path("log"));
  EXPECT_TRUE(Eventually([&] {
    return ask("ALERTS").find(R"("alertname":"RobotAsks")") != std::string::npos;
  })) << ask("ALERTS");
}

}  // namespace
}  // namespace coppice::robot::metrics
