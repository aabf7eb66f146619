#include "robot_app/storage/server/postgres_server.h"

#include <gmock/gmock.h>

#include <pqxx/pqxx>

#include "robot_app/storage/server/postgres_reader.h"
#include "robot_app/storage/server/shipper.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/storage/local_postgres.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::storage {
namespace {

using Answer = StoreResult::Answer;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kMorning = 1764059400 * kSecond;  // 2025-11-25 08:30 UTC
constexpr std::int64_t kDay = 24 * 3600 * kSecond;

Document Make(std::int64_t number, const std::string& json, std::int64_t received = kMorning) {
  Document document;
  document.number = number;
  document.received = received;
  document.stamp = 5;
  document.topic = "/a";
  static const auto type = std::make_shared<const MessageType>(MessageType{"a/B", "m", "int32 x"});
  document.type = type;
  document.json = json;
  return document;
}

// One server for all; each test is a robot of its own.
class PostgresServerTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { postgres_ = std::make_unique<LocalPostgres>(); }
  static void TearDownTestSuite() { postgres_.reset(); }

  Batch MakeBatch(std::vector<Document> documents) const {
    return {robot_, "s1", std::move(documents), {}};
  }
  std::vector<std::string> Rows(const std::string& columns) const {
    return postgres_->Ask("SELECT " + columns + " FROM coppice.messages WHERE robot = '" + robot_ +
                              "' ORDER BY number",
                          "robots");
  }
  // Of somebody else, which may hold up what the store wants.
  static pqxx::connection OtherSession() {
    ServerConfig config = postgres_->owner();
    config.database = "robots";
    return pqxx::connection(ConnectionText(config));
  }

  static inline std::unique_ptr<LocalPostgres> postgres_;
  const std::string robot_ = testing::UnitTest::GetInstance()->current_test_info()->name();
  PostgresServer server_{postgres_->by_network()};
};

TEST_F(PostgresServerTest, StoresDocumentsWithAllThatBelongsToThem) {
  ASSERT_EQ(server_.Store(MakeBatch({Make(1, R"({"x":0.30000000000000004})")})).problem, "");
  EXPECT_THAT(Rows("spool, number, time AT TIME ZONE 'UTC', stamp, topic, type, md5, document"),
              ElementsAre("s1|1|2025-11-25 08:30:00|5|/a|a/B|m|{\"x\": 0.30000000000000004}"));
  EXPECT_THAT(postgres_->Ask("SELECT * FROM coppice.types WHERE name = 'a/B'", "robots"),
              ElementsAre("a/B|m|int32 x"));
}

TEST_F(PostgresServerTest, KeepsOneOfADocumentThatComesTwice) {
  ASSERT_EQ(server_.Store(MakeBatch({Make(1, "{}")})).problem, "");
  ASSERT_EQ(server_.Store(MakeBatch({Make(1, "{}"), Make(2, "{}")})).problem, "");
  EXPECT_THAT(Rows("number"), ElementsAre("1", "2"));
}

TEST_F(PostgresServerTest, KeepsBothOfTwoSpoolsThatCountAlike) {
  Batch batch = MakeBatch({Make(1, "{}")});
  ASSERT_EQ(server_.Store(batch).problem, "");
  batch.spool = "s2";
  ASSERT_EQ(server_.Store(batch).problem, "");
  EXPECT_EQ(Rows("number").size(), 2u);
}

TEST_F(PostgresServerTest, MakesAPartitionForEachDay) {
  ASSERT_EQ(server_.Store(MakeBatch({Make(1, "{}"), Make(2, "{}", kMorning + kDay)})).problem, "");
  EXPECT_THAT(Rows("tableoid::regclass"),
              ElementsAre("coppice.messages_20251125", "coppice.messages_20251126"));
}

TEST_F(PostgresServerTest, KeepsTheHighestCountOfALoss) {
  Batch batch = MakeBatch({Make(1, "{}")});
  batch.losses = {{"/a", "full", 3, kMorning, kMorning}};
  ASSERT_EQ(server_.Store(batch).problem, "");
  batch.losses[0].count = 2;  // late
  ASSERT_EQ(server_.Store(batch).problem, "");
  EXPECT_THAT(postgres_->Ask(
                  "SELECT topic, reason, count FROM coppice.losses WHERE robot = '" + robot_ + "'",
                  "robots"),
              ElementsAre("/a|full|3"));
}

TEST_F(PostgresServerTest, AloneIsAskedAboutDocumentsThatItRefuses) {
  const TemporaryFolder folder;
  const auto spool = std::move(Spool::Open(folder.Path("spool.db"), {})).value();
  spool->Add({Make(0, "{}"), Make(0, R"({"x":"\u0000"})"), Make(0, "{}")});
  ShipperState state;
  ShipNext(*spool, server_, {robot_, {}}, state);
  EXPECT_EQ(Rows("number").size(), 2u);
  EXPECT_EQ(spool->Look().documents, 0);
  EXPECT_EQ(spool->Look().refused, 1);
  EXPECT_EQ(state.problem, "");
}

TEST_F(PostgresServerTest, GetsNothingWithoutItsPassword) {
  ServerConfig config = postgres_->by_network();
  config.password = "another";
  PostgresServer server(config);
  const StoreResult result = server.Store(MakeBatch({Make(1, "{}")}));
  EXPECT_EQ(result.answer, Answer::kAway);
  EXPECT_THAT(result.problem, HasSubstr("password authentication failed"));
}

TEST_F(PostgresServerTest, MustBeSignedByTheAuthority) {
  ServerConfig config = postgres_->by_network();
  config.authority = postgres_->File("stranger.crt");
  PostgresServer server(config);
  const StoreResult result = server.Store(MakeBatch({Make(1, "{}")}));
  EXPECT_EQ(result.answer, Answer::kAway);
  EXPECT_THAT(result.problem, HasSubstr("certificate verify failed"));
}

TEST_F(PostgresServerTest, MustHaveTheNameInItsCertificate) {
  ServerConfig config = postgres_->by_network();
  config.host = "127.0.0.1";
  PostgresServer server(config);
  const StoreResult result = server.Store(MakeBatch({Make(1, "{}")}));
  EXPECT_EQ(result.answer, Answer::kAway);
  EXPECT_THAT(result.problem, HasSubstr("does not match host name"));
}

TEST_F(PostgresServerTest, SaysThatTheRoleMayNotMakeTables) {
  postgres_->Ask("CREATE DATABASE another");
  ServerConfig config = postgres_->by_network();
  config.database = "another";
  PostgresServer server(config);
  const StoreResult result = server.Store(MakeBatch({Make(1, "{}")}));
  EXPECT_EQ(result.answer, Answer::kAway);
  EXPECT_THAT(result.problem, HasSubstr("permission denied"));
}

TEST_F(PostgresServerTest, HasViewsThatCanBeAsked) {
  ASSERT_EQ(server_.Store(MakeBatch({Make(1, "{}")})).problem, "");
  for (const std::string view : {"rates", "battery", "faults", "recoveries", "processes"}) {
    EXPECT_NO_THROW(postgres_->Ask("SELECT time, robot FROM coppice." + view, "robots")) << view;
  }
}

TEST_F(PostgresServerTest, GivesBackWhatItStored) {
  ASSERT_EQ(server_.Store(MakeBatch({Make(1, R"({"x":1})"), Make(2, R"({"x":2})")})).problem, "");
  StoredQuery query;
  query.robot = robot_;
  std::vector<std::string> found;
  const auto use = [&](const StoredMessage& message) {
    found.push_back(message.json);
    return true;
  };
  EXPECT_TRUE(ReadStored(postgres_->by_network(), query, use));
  EXPECT_THAT(found, ElementsAre(R"({"x": 1})", R"({"x": 2})"));
}

TEST_F(PostgresServerTest, IsNotReadFromAnyMoreWhenItDoesNotAnswer) {
  ASSERT_EQ(server_.Store(MakeBatch({Make(1, "{}")})).problem, "");
  pqxx::connection other = OtherSession();
  pqxx::work lock(other);
  lock.exec("LOCK TABLE coppice.messages IN ACCESS EXCLUSIVE MODE");
  StoredQuery query;
  query.patience = std::chrono::milliseconds(50);
  const Outcome read = ReadStored(postgres_->by_network(), query, [](const auto&) { return true; });
  EXPECT_THAT(read.problem(), HasSubstr("the server has not answered"));
}

// A spool with a shipper that does not wait long.
class ShipperTest : public PostgresServerTest {
 protected:
  ShipperTest() {
    options_.robot = robot_;
    options_.first_pause = options_.longest_pause = std::chrono::milliseconds(20);
  }
  void Add(int count) {
    spool_->Add(std::vector<Document>(static_cast<std::size_t>(count), Make(0, "{}")));
  }
  bool IsEmptySoon() const {
    return Eventually([this] { return spool_->Look().documents == 0; });
  }
  static bool GivesUp(Shipper& shipper) {
    return Eventually([&] {
      shipper.Watch();
      return !shipper.Look().problem.empty();
    });
  }

  const TemporaryFolder folder_;
  ShipperOptions options_;
  const std::unique_ptr<Spool> spool_ =
      std::move(Spool::Open(folder_.Path("spool.db"), {})).value();
};

TEST_F(ShipperTest, SendsWhatCameWhileTheServerWasAway) {
  postgres_->Stop();
  Add(10);
  Shipper shipper(*spool_, server_, options_);
  EXPECT_TRUE(Eventually([&] { return !shipper.Look().problem.empty(); }));
  Add(10);
  postgres_->Start();
  EXPECT_TRUE(IsEmptySoon());
  EXPECT_EQ(Rows("number").size(), 20u);
}

// A message each ten seconds; in the middle of it the robot is switched off and on.
TEST_F(ShipperTest, SendsEachMessageOfADayWithoutServerOnce) {
  constexpr int kHours = 24, kPerHour = 360;
  postgres_->Stop();
  auto spool = std::move(Spool::Open(folder_.Path("day.db"), {})).value();
  ShipperState state;
  for (int hour = 0; hour < kHours; ++hour) {
    std::vector<Document> documents;
    for (int i = 0; i < kPerHour; ++i) {
      documents.push_back(Make(0, "{}", kMorning + (kPerHour * hour + i) * 10 * kSecond));
    }
    spool->Add(documents);
    EXPECT_FALSE(ShipNext(*spool, server_, options_, state)) << "the server is away";
    if (hour != kHours / 2) continue;
    spool.reset();
    spool = std::move(Spool::Open(folder_.Path("day.db"), {})).value();
  }
  EXPECT_EQ(spool->Look().documents, kHours * kPerHour);
  postgres_->Start();
  EXPECT_TRUE(Eventually([&] {
    ShipNext(*spool, server_, options_, state);
    return spool->Look().documents == 0;
  }));
  EXPECT_EQ(Rows("DISTINCT number").size(), std::size_t{kHours * kPerHour});
  EXPECT_EQ(Rows("number").size(), std::size_t{kHours * kPerHour});
  EXPECT_EQ(spool->Look().lost, 0);
}

TEST_F(ShipperTest, GoesOnWhenThePasswordIsRightAgain) {
  postgres_->Ask("ALTER ROLE store PASSWORD 'changed'");
  Add(10);
  Shipper shipper(*spool_, server_, options_);
  EXPECT_TRUE(Eventually([&] { return !shipper.Look().problem.empty(); }));
  EXPECT_EQ(spool_->Look().documents, 10);
  postgres_->Ask("ALTER ROLE store PASSWORD '" + postgres_->by_network().password + "'");
  EXPECT_TRUE(IsEmptySoon());
  EXPECT_EQ(Rows("number").size(), 10u);
}

TEST_F(ShipperTest, GivesUpWaitingForAnAnswerThatDoesNotCome) {
  pqxx::connection other = OtherSession();
  pqxx::work lock(other);
  options_.patience = std::chrono::milliseconds(50);
  lock.exec("LOCK TABLE coppice.messages IN ACCESS EXCLUSIVE MODE");
  Add(10);
  Shipper shipper(*spool_, server_, options_);
  EXPECT_TRUE(GivesUp(shipper));
  lock.abort();
  EXPECT_TRUE(IsEmptySoon());
  EXPECT_EQ(Rows("number").size(), 10u);
}

// Who makes the tables waits for others that do; a server that hangs looks the same.
TEST_F(ShipperTest, GivesUpWaitingForAServerThatHangsAtTheFirstQuestion) {
  pqxx::connection other = OtherSession();
  pqxx::work lock(other);
  options_.patience = std::chrono::milliseconds(50);
  lock.exec("SELECT pg_advisory_xact_lock(1131376752)");
  Add(10);
  auto shipper = std::make_unique<Shipper>(*spool_, server_, options_);
  EXPECT_TRUE(GivesUp(*shipper));
  shipper.reset();  // ends, though nobody looks any more whether it waits
  lock.abort();
  const Shipper next(*spool_, server_, options_);
  EXPECT_TRUE(IsEmptySoon());
}

}  // namespace
}  // namespace coppice::robot::storage
