#include "robot_app/storage/server/mongo_server.h"

#include <gtest/gtest.h>

#include "robot_app/processes/launch/ros_master.h"

namespace coppice::robot::storage {
namespace {

Batch MakeBatch(const std::string& json) {
  Document document;
  document.number = 7;
  document.received = 1'500'000'000;
  document.stamp = 3;
  document.topic = "/a";
  document.type = std::make_shared<const MessageType>(MessageType{"a/B", "m", "int32 x"});
  document.json = json;
  return {"sobi", "s1", {document}, {}};
}

TEST(MongoDocument, HasTheKeyAndTheMessage) {
  const Batch batch = MakeBatch(R"({"x":1,"y":0.5,"z":9007199254740993})");
  EXPECT_EQ(
      *MongoDocument(batch, batch.documents[0]),
      R"({ "_id" : { "robot" : "sobi", "spool" : "s1", "number" : { "$numberLong" : "7" } }, )"
      R"("time" : { "$date" : { "$numberLong" : "1500" } }, "stamp" : { "$numberLong" : "3" }, )"
      R"("topic" : "/a", "type" : "a/B", "md5" : "m", )"
      R"("document" : { "x" : { "$numberInt" : "1" }, "y" : { "$numberDouble" : "0.5" }, )"
      R"("z" : { "$numberLong" : "9007199254740993" } } })");
}

TEST(MongoServer, RefusesWhatIsNoDocument) {
  ServerConfig config;
  config.host = "127.0.0.1";
  config.port = processes::FreePort();
  MongoServer server(config);
  EXPECT_EQ(server.Store(MakeBatch("{")).answer, StoreResult::Answer::kRefused);
}

TEST(MongoServer, IsAwayWhileNobodyAnswers) {
  ServerConfig config;
  config.host = "127.0.0.1";
  config.port = processes::FreePort();
  config.is_encrypted = false;
  MongoServer server(config);
  const StoreResult result = server.Store(MakeBatch("{}"));
  EXPECT_EQ(result.answer, StoreResult::Answer::kAway);
  EXPECT_NE(result.problem, "");
}

TEST(MongoUri, AsksForVerifiedTls) {
  ServerConfig config;
  config.host = "db.example.org";
  config.port = 27017;
  EXPECT_NE(MongoUri(config).find("mongodb://db.example.org:27017/"), std::string::npos);
  EXPECT_NE(MongoUri(config).find("tls=true"), std::string::npos);
}

}  // namespace
}  // namespace coppice::robot::storage
