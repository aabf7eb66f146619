// coppice-store: keeps the robot's messages outside of the robot.
#include <ros/ros.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/verbs.h"
#include "robot_app/common/find_master.h"
#include "robot_app/storage/export/export_messages.h"
#include "robot_app/storage/server/mongo_server.h"
#include "robot_app/storage/server/postgres_schema.h"
#include "robot_app/storage/server/postgres_server.h"
#include "robot_app/storage/store_node.h"

namespace coppice::robot::storage {
namespace {

const CommandOption kConfigOption =
    CommandOption::Text("--config", "FILE", "what is stored, and where").Needed();

const Command kRun{
    "coppice-store run",
    "store messages, as the node /store",
    {},
    "Listens to the topics of the configuration, keeps their messages on the disk, and sends\n"
    "them to the server whenever it answers. Ends on SIGTERM and SIGINT.",
    {kConfigOption,
     CommandOption::Text("--folder", "FOLDER", "of the spool; else as the configuration says")}};
const Command kExport{
    "coppice-store export",
    "write stored messages into a bag or a table",
    {},
    "Reads messages back from the server (PostgreSQL) into a bag of ROS 1 (FILE.bag) or, of\n"
    "one type, a table of comma-separated values (FILE.csv).",
    {kConfigOption, CommandOption::Text("--output", "FILE", "ends in .bag or .csv").Needed(),
     CommandOption::Text("--topic", "TOPIC", "messages of this one; may be given again"),
     CommandOption::Text("--robot", "NAME", "of this one; else as the configuration says"),
     CommandOption::Text("--from", "TIME", "heard from then on: \"2026-11-25 08:00+01\""),
     CommandOption::Text("--to", "TIME", "and before that"),
     CommandOption::Text("--files", "FOLDER", "what was left out and kept on the robot"),
     CommandOption::Whole("--patience", "S", 1, 86400,
                          "how long each answer of the server may take; else 300")}};
const Command kSchema{
    "coppice-store schema",
    "print what the server is to contain",
    {},
    "Prints the SQL that the first store runs, for a server on which a robot may make no tables.",
    {}};

int Fail(const std::string& problem) {
  std::cerr << "coppice-store: " << problem << "\n";
  return 1;
}

std::optional<StoreConfig> Load(const Options& options) {
  Diagnostics diagnostics;
  StoreConfig config = LoadStoreConfig(options.Get("--config"), ProcessEnvironment, diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors()) return std::nullopt;
  return config;
}

std::unique_ptr<DocumentServer> MakeServer(const ServerConfig& config) {
  if (config.kind == ServerConfig::Kind::kMongodb) return std::make_unique<MongoServer>(config);
  return std::make_unique<PostgresServer>(config);
}

void RequestEnd(int) { ros::requestShutdown(); }

int Run(const Options& options) {
  std::optional<StoreConfig> config = Load(options);
  if (!config) return 2;
  config->folder = options.Get("--folder", config->folder);
  if (!FindMaster("coppice-store")) return 2;
  std::error_code error;
  std::filesystem::create_directories(config->folder, error);
  auto spool = Spool::Open(config->folder + "/spool.db", config->spool);
  if (!spool) return Fail(spool.problem());
  if ((*spool)->has_replaced()) {
    Fail("the spool was damaged; it is kept as " + config->folder +
         "/spool.db.damaged, and a new one begun");
  }
  std::signal(SIGINT, RequestEnd);
  std::signal(SIGTERM, RequestEnd);
  ros::NodeHandle node;
  const StoreNode store(node, *config, std::move(spool).value(), MakeServer(config->server));
  ros::spin();
  return 0;
}

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

int Export(const Options& options) {
  const std::string path = options.Get("--output");
  const bool is_bag = EndsWith(path, ".bag");
  if (!is_bag && !EndsWith(path, ".csv")) {
    return RefuseOptions(kExport, "--output: expected FILE.bag or FILE.csv, not " + path);
  }
  const std::optional<StoreConfig> config = Load(options);
  if (!config) return 2;
  if (config->server.kind == ServerConfig::Kind::kMongodb) {
    return Fail("reads from PostgreSQL only; MongoDB has mongoexport");
  }
  const StoredQuery query{options.Get("--robot", config->robot), options.GetAll("--topic"),
                          options.Get("--from"), options.Get("--to"),
                          std::chrono::seconds(options.Whole("--patience", 300))};
  const auto exported = is_bag ? ExportBag(config->server, query, options.Get("--files"), path)
                               : ExportCsv(config->server, query, path);
  if (!exported) return Fail(exported.problem());
  std::cout << exported->messages << " messages";
  if (exported->not_whole > 0) {
    std::cout << ", " << exported->not_whole << " of them without what was left out";
  }
  std::cout << "\n";
  return 0;
}

int Schema(const Options&) {
  std::cout << kPostgresSchema;
  return 0;
}

const std::vector<Verb> kVerbs = {
    {"run", kRun, Run}, {"export", kExport, Export}, {"schema", kSchema, Schema}};

}  // namespace
}  // namespace coppice::robot::storage

int main(int argc, char** argv) {
  ros::init(argc, argv, "store", ros::init_options::NoSigintHandler);  // takes out remappings
  try {
    return coppice::RunVerb("coppice-store", coppice::robot::storage::kVerbs,
                            {argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "coppice-store: " << error.what() << "\n";
    return 1;
  }
}
