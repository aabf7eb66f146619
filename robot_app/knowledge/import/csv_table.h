// Tables as text (RFC 4180, the first row names the columns), read row by row: a table of a
// timetable may have millions.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_CSV_TABLE_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_CSV_TABLE_H_

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"

namespace coppice::robot::knowledge {

/// Fills `buffer` and tells with how many bytes; 0 at the end.
using ByteSource = std::function<std::size_t(char* buffer, std::size_t size)>;
ByteSource BytesOf(std::string_view text);

struct CsvColumn {
  std::string name;
  bool is_needed = false;  ///< else its fields are empty where the table has no such column
};

struct CsvFormat {
  std::vector<CsvColumn> columns;
  bool has_others = false;  ///< the table may have further columns; else they are an error
};

/// The fields that the format names, in its order.
struct CsvRow {
  std::vector<std::string> fields;
  SourceLocation where;
};

/// Calls `use` for every row behind the first one. Rows of a wrong length, bytes that are no UTF-8
/// and quotes that do not end are errors.
void ReadCsv(const std::string& file, const ByteSource& bytes, const CsvFormat& format,
             Diagnostics& diagnostics, const std::function<void(CsvRow&)>& use);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_CSV_TABLE_H_
