#include "robot_app/storage/config/store_config.h"

#include <set>
#include <utility>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot::storage {
namespace {

using Kind = ServerConfig::Kind;

constexpr double kMegabyte = 1 << 20;

bool IsOnThisComputer(const std::string& host) {
  return host.empty() || host[0] == '/' || host == "localhost" || host == "::1" ||
         host.compare(0, 4, "127.") == 0;
}

class Loader {
 public:
  Loader(const std::string& path, const Environment& environment, Diagnostics& diagnostics)
      : environment_(environment),
        file_(YamlFields::Load(path, diagnostics)),
        readable_(!diagnostics.has_errors()) {}

  StoreConfig Load() {
    if (!readable_) return {};
    config_.robot = Filled(file_, file_.Text("robot"));
    YamlFields server = file_.Map("server");
    ReadServer(server);
    YamlFields spool = file_.Map("spool");
    ReadSpool(spool);
    for (YamlFields& topic : file_.Maps("topics")) ReadTopic(topic);
    if (config_.topics.empty()) file_.Error(file_.where(), "there are no topics to store");
    file_.Finish();
    return std::move(config_);
  }

 private:
  std::string Filled(const YamlFields& fields, const LocatedText& text) {
    const Expected<std::string> filled = FillVariables(text.text, environment_);
    if (filled) return *filled;
    fields.Error(text.where, filled.problem());
    return "";
  }

  std::string Filled(YamlFields& fields, const std::string& key, const std::string& otherwise) {
    return Filled(fields, fields.Text(key, otherwise));
  }

  void ReadServer(YamlFields& fields) {
    ServerConfig& server = config_.server;
    const bool is_mongo =
        fields.Choice("kind", "postgresql", {"postgresql", "mongodb"}) == "mongodb";
    server.kind = is_mongo ? Kind::kMongodb : Kind::kPostgresql;
    server.host = Filled(fields, fields.Text("host"));
    server.port = fields.Integer("port", is_mongo ? 27017 : 5432, 1, 65535);
    server.database = Filled(fields, "database", server.database);
    server.user = Filled(fields, "user", "");
    server.password = Password(fields);
    ReadEncryption(fields);
    fields.Finish();
  }

  // Whoever could read the messages on the way could read the password, too.
  void ReadEncryption(YamlFields& fields) {
    ServerConfig& server = config_.server;
    const LocatedText tls = fields.Text("tls", "verify");
    server.is_encrypted = fields.Choice("tls", "verify", {"verify", "none"}) == "verify";
    server.authority = Filled(fields, "authority", "");
    if (server.is_encrypted || IsOnThisComputer(server.host)) return;
    fields.Error(tls.where, "\"tls\": without it only a server on this computer is used",
                 "leave \"tls\" out, and name the certificate of its \"authority\"");
  }

  std::string Password(YamlFields& fields) {
    const LocatedText text = fields.Text("password", "");
    if (text.text.empty()) return "";
    if (IsVariable(text.text)) return Filled(fields, text);
    fields.Error(
        text.where, "\"password\": a secret must not stand in a file",
        "write \"${COPPICE_STORE_PASSWORD}\" and set that variable where the program runs");
    return "";
  }

  void ReadSpool(YamlFields& fields) {
    config_.folder = Filled(fields, "folder", config_.folder);
    config_.spool.largest = Megabytes(fields, "largest", 2048, 1);
    config_.largest_files = Megabytes(fields, "largest_files", 1024, 0);
    config_.largest_intake = Megabytes(fields, "largest_intake", 64, 1);
    config_.period = fields.Seconds("period", 0.1, 0.01, 10);
    fields.Finish();
  }

  static std::uint64_t Megabytes(YamlFields& fields, const std::string& key, double otherwise,
                                 double least) {
    return static_cast<std::uint64_t>(fields.Number(key, otherwise, least, 1e6) * kMegabyte);
  }

  void ReadTopic(YamlFields& fields) {
    TopicConfig topic;
    const LocatedText name = fields.Text("topic");
    topic.topic = name.text;
    if (!name.text.empty() && name.text[0] != '/') {
      fields.Error(name.where,
                   "\"topic\": expected a name with a slash, not \"" + name.text + "\"");
    }
    if (!names_.insert(name.text).second) {
      fields.Error(name.where, "topic \"" + name.text + "\" is listed twice");
    }
    topic.priority = fields.Integer("priority", topic.priority, 0, 9);
    topic.rate = fields.Number("rate", 0, 0, 1e6);
    topic.longest_array =
        static_cast<std::size_t>(fields.Integer("longest_array", 1000, 0, 1000000));
    topic.keeps_files = fields.Choice("left_out", "forget", {"forget", "file"}) == "file";
    fields.Finish();
    config_.topics.push_back(std::move(topic));
  }

  const Environment& environment_;
  YamlFields file_;
  const bool readable_;
  StoreConfig config_;
  std::set<std::string> names_;
};

}  // namespace

StoreConfig LoadStoreConfig(const std::string& path, const Environment& environment,
                            Diagnostics& diagnostics) {
  return Loader(path, environment, diagnostics).Load();
}

}  // namespace coppice::robot::storage
