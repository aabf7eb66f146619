// Reads back what stores have sent to PostgreSQL.
#ifndef COPPICE_ROBOT_APP_STORAGE_SERVER_POSTGRES_READER_H_
#define COPPICE_ROBOT_APP_STORAGE_SERVER_POSTGRES_READER_H_

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/base/outcome.h"
#include "robot_app/storage/config/store_config.h"
#include "robot_app/storage/messages/document.h"

namespace coppice::robot::storage {

/// Which messages. Empty: all.
struct StoredQuery {
  std::string robot;
  std::vector<std::string> topics;
  std::string from;  ///< as PostgreSQL reads a time: "2026-11-25 08:00+01"
  std::string to;    ///< before that
  Duration patience = std::chrono::minutes(5);  ///< with each answer of the server
};

struct StoredMessage {
  std::string time;  ///< when it was heard, in UTC
  std::int64_t stamp = 0;
  std::string topic;
  std::shared_ptr<const MessageType> type;
  std::string json;
};

/// In the order in which they were heard, some at a time in memory, as they were when it began.
/// `use` returns false to end it. A problem if the server does not answer in time, or does not
/// understand.
Outcome ReadStored(const ServerConfig& server, const StoredQuery& query,
                   const std::function<bool(const StoredMessage& message)>& use);

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_SERVER_POSTGRES_READER_H_
