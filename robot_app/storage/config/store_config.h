// The file store.yaml as values: which topics are stored, how, and where.
//
// The password comes from the environment only, as "${COPPICE_STORE_PASSWORD}".
#ifndef COPPICE_ROBOT_APP_STORAGE_CONFIG_STORE_CONFIG_H_
#define COPPICE_ROBOT_APP_STORAGE_CONFIG_STORE_CONFIG_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/diagnostic.h"
#include "robot_app/common/configuration/environment_text.h"
#include "robot_app/storage/spool/spool.h"

namespace coppice::robot::storage {

struct TopicConfig {
  std::string topic;
  int priority = 5;                  ///< 0..9; 9 is sent first and lost last
  double rate = 0;                   ///< at most so many messages a second; 0: all
  std::size_t longest_array = 1000;  ///< longer ones are left out
  bool keeps_files = false;          ///< what is left out goes into a file on the robot
};

struct ServerConfig {
  enum class Kind : std::uint8_t { kPostgresql, kMongodb };
  Kind kind = Kind::kPostgresql;
  std::string host;  ///< name, address, or (PostgreSQL) the folder of a local socket
  int port = 0;
  std::string database = "robots";
  std::string user;
  std::string password;
  bool is_encrypted = true;  ///< TLS; certificate and name of the server are verified
  std::string authority;     ///< file with the certificate that vouches for it; empty: the system's
};

struct StoreConfig {
  std::string robot;
  ServerConfig server;
  std::string folder = ".";  ///< of the spool and the files
  SpoolLimits spool;
  std::uint64_t largest_files = std::uint64_t{1} << 30;  ///< bytes, of all files together
  std::size_t largest_intake = std::size_t{64} << 20;    ///< bytes in memory before the spool
  Duration period = std::chrono::milliseconds(100);      ///< from commit to commit of the spool
  std::vector<TopicConfig> topics;
};

/// Reads and checks a file. All that is wrong is reported at once; with errors the result is not to
/// be used.
StoreConfig LoadStoreConfig(const std::string& path, const Environment& environment,
                            Diagnostics& diagnostics);

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_CONFIG_STORE_CONFIG_H_
