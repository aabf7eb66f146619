// store_feeder FOLDER HOST PORT FIRST COUNT: puts the numbers FIRST, FIRST + 1, ... into the spool
// in FOLDER, a few at a time, while it ships them to a PostgreSQL server. What the spool has
// accepted it writes into FOLDER/accepted, a number a line. Ends when the spool is empty. To be
// killed at any moment.
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "robot_app/storage/server/postgres_server.h"
#include "robot_app/storage/server/shipper.h"
#include "tests/robot_app/eventually.h"

namespace coppice::robot::storage {
namespace {

constexpr int kAtOnce = 20;

int Main(const std::string& folder, ServerConfig config, std::int64_t first, int count) {
  const auto spool = Spool::Open(folder + "/spool.db", {});
  if (!spool) {
    std::cerr << spool.problem() << "\n";
    return 1;
  }
  config.database = "postgres";
  config.user = "owner";
  config.is_encrypted = false;
  PostgresServer server(config);
  ShipperOptions options;
  options.robot = "feeder";
  options.batch.documents = 50;
  options.first_pause = options.longest_pause = std::chrono::milliseconds(10);
  Shipper shipper(**spool, server, options);
  const auto type = std::make_shared<const MessageType>(MessageType{"a/B", "m", "int64 id"});
  const int accepted = open((folder + "/accepted").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  for (int i = 0; i < count; i += kAtOnce) {
    std::vector<Document> documents(kAtOnce);
    std::string lines;
    for (int j = 0; j < kAtOnce; ++j) {
      const std::string id = std::to_string(first + i + j);
      documents[static_cast<std::size_t>(j)] = {0,     5,    1764059400'000000000, 0,
                                                "/id", type, "{\"id\":" + id + "}"};
      lines += id + "\n";
    }
    (*spool)->Add(documents);
    if (write(accepted, lines.data(), lines.size()) < 0) return 1;
    shipper.Wake();
  }
  return Eventually([&] { return (*spool)->Look().documents == 0; }, 120) ? 0 : 1;
}

}  // namespace
}  // namespace coppice::robot::storage

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  coppice::robot::storage::ServerConfig config;
  config.host = argv[2];
  config.port = std::atoi(argv[3]);
  return coppice::robot::storage::Main(argv[1], config, std::atoll(argv[4]), std::atoi(argv[5]));
}
