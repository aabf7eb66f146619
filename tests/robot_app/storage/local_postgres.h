// A real PostgreSQL server for tests: made by initdb in a temporary folder, run as an ordinary user
// (PostgreSQL refuses to be root's), on a socket in that folder and on a free TCP port with TLS.
#ifndef COPPICE_TESTS_ROBOT_APP_STORAGE_LOCAL_POSTGRES_H_
#define COPPICE_TESTS_ROBOT_APP_STORAGE_LOCAL_POSTGRES_H_

#include <sys/types.h>

#include <csignal>
#include <string>
#include <vector>

#include "robot_app/storage/config/store_config.h"

namespace coppice::robot::storage {

class LocalPostgres {
 public:
  /// Makes a cluster and a certificate, and starts the server. Throws std::runtime_error.
  LocalPostgres();
  ~LocalPostgres();
  LocalPostgres(const LocalPostgres&) = delete;
  LocalPostgres& operator=(const LocalPostgres&) = delete;

  /// As its owner, without password.
  const ServerConfig& owner() const { return owner_; }
  /// By TCP with TLS, as the role `store` with a password and a database of its own.
  const ServerConfig& by_network() const { return by_network_; }
  /// The certificate of its authority is signed for the name "localhost" only.
  std::string File(const std::string& name) const { return folder_ + "/" + name; }

  /// Returns when it takes connections.
  void Start();
  /// Waits until it has ended.
  void Stop() { End(SIGINT); }
  void Kill() { End(SIGKILL); }

  /// Asks as the owner. The rows, columns separated by "|".
  std::vector<std::string> Ask(const std::string& query,
                               const std::string& database = "postgres") const;
  std::string AskOne(const std::string& query, const std::string& database = "postgres") const {
    return Ask(query, database).at(0);
  }

 private:
  void MakeCluster();
  void MakeCertificates();
  void MakeRole();
  bool TakesConnections() const;
  void End(int signal);
  std::vector<std::string> AsItsUser(std::vector<std::string> command) const;

  std::string folder_;
  std::string programs_;
  ServerConfig owner_, by_network_;
  int pid_ = 0;
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_TESTS_ROBOT_APP_STORAGE_LOCAL_POSTGRES_H_
