// Messages of one type as a table: a line for each, a column for each field ("pose.position.x").
// Lists are one cell, as JSON.
#ifndef COPPICE_ROBOT_APP_STORAGE_EXPORT_CSV_TABLE_H_
#define COPPICE_ROBOT_APP_STORAGE_EXPORT_CSV_TABLE_H_

#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/storage/messages/message_layout.h"
#include "robot_app/storage/server/postgres_reader.h"

namespace coppice::robot::storage {

/// As RFC 4180, with a new line at the end. A problem if it is longer than 1 MiB: the fields of
/// messages within messages multiply.
Expected<std::string> CsvHeader(const MessageLayout& layout);

/// A problem if the document does not fit the type.
Expected<std::string> CsvLine(const MessageLayout& layout, const StoredMessage& message);

}  // namespace coppice::robot::storage

#endif  // COPPICE_ROBOT_APP_STORAGE_EXPORT_CSV_TABLE_H_
