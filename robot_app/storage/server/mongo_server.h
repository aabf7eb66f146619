// Documents in MongoDB: collections `messages`, `types` and `losses` of the database. The key of a
// message (_id) is {robot, spool, number}; its document is a BSON document.
//
// Written against the manual of libmongoc 1.23. Debian has no MongoDB to test it with: tested are
// the documents, the connection's text, and what happens while no server answers.
#ifndef COPPICE_ROBOT_APP_STORAGE_SERVER_MONGO_SERVER_H_
#define COPPICE_ROBOT_APP_STORAGE_SERVER_MONGO_SERVER_H_

#include <memory>
#include <string>

#include "robot_app/storage/config/store_config.h"
#include "robot_app/storage/server/document_server.h"

namespace coppice::robot::storage {

/// "mongodb://HOST:PORT/?..." without user and password. An answer is waited for at most 30 s, and
/// counts when most of the servers have it on disk.
std::string MongoUri(const ServerConfig& config);

/// The document as MongoDB gets it, in canonical extended JSON.
Expected<std::string> MongoDocument(const Batch& batch, const Document& document);

class MongoServer : public DocumentServer {
 public:
  /// Throws std::runtime_error if the configuration makes no address.
  explicit MongoServer(const ServerConfig& config);
  ~MongoServer() override;

  StoreResult Store(const Batch& batch) override;
  void Abort() override {}  // its waits are short

 private:
  struct Session;
  std::unique_ptr<Session> session_;
};

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SERVER_MONGO_SERVER_H_
