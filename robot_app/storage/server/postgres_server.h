// Documents in PostgreSQL 15 or newer: schema `coppice`, one row for each, a partition for each day
// (UTC). Makes what is missing of it; a role that may not is told so.
//
//   PostgresServer server({...});
//   server.Store(batch);        // connects, if need be
#ifndef COPPICE_ROBOT_APP_STORAGE_SERVER_POSTGRES_SERVER_H_
#define COPPICE_ROBOT_APP_STORAGE_SERVER_POSTGRES_SERVER_H_

#include <memory>
#include <mutex>
#include <string>

#include "robot_app/storage/config/store_config.h"
#include "robot_app/storage/server/document_server.h"

namespace coppice::robot::storage {

/// For libpq: host, port, database, user, password, and TLS with verification of certificate and
/// name, if the server is to be encrypted.
std::string ConnectionText(const ServerConfig& config);

class PostgresServer : public DocumentServer {
 public:
  explicit PostgresServer(ServerConfig config);
  ~PostgresServer() override;

  StoreResult Store(const Batch& batch) override;
  void Abort() override;

 private:
  void Connect();
  void Disconnect();

  struct Session;
  ServerConfig config_;
  std::mutex mutex_;  // of the pointer: Abort comes from another thread
  std::unique_ptr<Session> session_;
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SERVER_POSTGRES_SERVER_H_
