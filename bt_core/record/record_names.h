// What the files of one record are called: run.coppice, run.2.coppice, run.3.coppice...
#ifndef COPPICE_BT_CORE_RECORD_RECORD_NAMES_H_
#define COPPICE_BT_CORE_RECORD_RECORD_NAMES_H_

#include <cstdint>
#include <string>
#include <vector>

namespace coppice {

/// The number is put before the last extension; 1 gives the name itself.
std::string NumberedName(const std::string& path, std::uint32_t number);

struct NumberedFile {
  std::uint32_t number;
  std::string path;
};

/// The files that are there under the names of the record that a file belongs to, by number. The
/// file may be any of them.
std::vector<NumberedFile> FilesOfSeries(const std::string& path);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_RECORD_NAMES_H_
