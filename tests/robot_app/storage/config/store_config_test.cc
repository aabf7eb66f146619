#include "robot_app/storage/config/store_config.h"

#include <gtest/gtest.h>

#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::storage {
namespace {

std::optional<std::string> ValueOf(const std::string& name) {
  if (name == "COPPICE_STORE_PASSWORD") return "secret";
  return std::nullopt;
}

struct Loaded {
  StoreConfig config;
  std::string problems;
};

Loaded Load(const std::string& text) {
  const TemporaryFolder folder;
  WriteFile(folder.Path("store.yaml"), text);
  Diagnostics diagnostics;
  Loaded loaded{LoadStoreConfig(folder.Path("store.yaml"), ValueOf, diagnostics), ""};
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    loaded.problems += std::to_string(diagnostic.where.line) + ":" +
                       std::to_string(diagnostic.where.column) + ": " + diagnostic.message + "\n";
  }
  return loaded;
}

const std::string kRest = "robot: a\ntopics: [{topic: /a}]\n";

TEST(StoreConfig, IsReadWithItsDefaults) {
  const Loaded loaded = Load(
      "robot: sobi\n"
      "server: {host: db.example.org, user: u, password: \"${COPPICE_STORE_PASSWORD}\"}\n"
      "spool: {largest: 2}\n"
      "topics: [{topic: /a}, {topic: /b, priority: 9, rate: 2, left_out: file}]\n");
  EXPECT_EQ(loaded.problems, "");
  EXPECT_EQ(loaded.config.server.port, 5432);
  EXPECT_EQ(loaded.config.server.password, "secret");
  EXPECT_TRUE(loaded.config.server.is_encrypted);
  EXPECT_EQ(loaded.config.spool.largest, 2u << 20);
  EXPECT_EQ(loaded.config.topics[0].priority, 5);
  EXPECT_TRUE(loaded.config.topics[1].keeps_files);
}

struct Wrong {
  std::string text;
  std::string problems;
};
class WrongStoreConfig : public testing::TestWithParam<Wrong> {};

TEST_P(WrongStoreConfig, IsToldWithItsPlace) {
  EXPECT_EQ(Load(GetParam().text).problems, GetParam().problems);
}
INSTANTIATE_TEST_SUITE_P(
    All, WrongStoreConfig,
    testing::Values(
        Wrong{kRest + "server: {host: h, password: abc}\n",
              "3:29: \"password\": a secret must not stand in a file\n"},
        Wrong{kRest + "server: {host: db, tls: none}\n",
              "3:25: \"tls\": without it only a server on this computer is used\n"},
        Wrong{kRest + "server: {host: h, password: \"${NOT_SET}\"}\n",
              "3:29: the environment variable NOT_SET is not set\n"},
        Wrong{"robot: a\nserver: {host: h}\ntopics: [{topic: a}, {topic: /b}, {topic: /b}]\n",
              "3:18: \"topic\": expected a name with a slash, not \"a\"\n"
              "3:43: topic \"/b\" is listed twice\n"},
        Wrong{"robot: a\nserver: {host: h}\n", "1:1: there are no topics to store\n"},
        Wrong{kRest + "server: {host: h, prot: 1}\n", "3:19: unknown key \"prot\"\n"}));

TEST(StoreConfig, MayLeaveTlsOutForAServerOnThisComputer) {
  for (const std::string host : {"/run/postgresql", "localhost", "127.0.0.1", "\"::1\""}) {
    EXPECT_EQ(Load(kRest + "server: {host: " + host + ", tls: none}\n").problems, "") << host;
  }
}

TEST(StoreConfig, ThatIsShippedIsRight) {
  Diagnostics diagnostics;
  LoadStoreConfig(SourceFolder() + "/robot_app/config/store.yaml", ValueOf, diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
}

}  // namespace
}  // namespace coppice::robot::storage
