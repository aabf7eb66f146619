// Stored messages as a file for other programs: a bag of ROS 1, or a table.
#ifndef COPPICE_ROBOT_APP_STORAGE_EXPORT_EXPORT_MESSAGES_H_
#define COPPICE_ROBOT_APP_STORAGE_EXPORT_EXPORT_MESSAGES_H_

#include <cstdint>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/storage/server/postgres_reader.h"

namespace coppice::robot::storage {

struct Exported {
  std::uint64_t messages = 0;
  std::uint64_t not_whole = 0;  ///< of these: something that was left out has no file any more
};

/// Into a bag, at their ROS time. `files`: the folder of what was left out; may be empty. The bag
/// is there as a whole or not at all.
Expected<Exported> ExportBag(const ServerConfig& server, const StoredQuery& query,
                             const std::string& files, const std::string& path);

/// Into a table of comma-separated values. A problem if they are of more than one type.
Expected<Exported> ExportCsv(const ServerConfig& server, const StoredQuery& query,
                             const std::string& path);

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_EXPORT_EXPORT_MESSAGES_H_
