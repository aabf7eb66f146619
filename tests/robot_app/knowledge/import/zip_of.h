// A zip as a file, for tests.
#ifndef COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_IMPORT_ZIP_OF_H_
#define COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_IMPORT_ZIP_OF_H_

#include <zip.h>

#include <map>
#include <stdexcept>
#include <string>

namespace coppice::robot::knowledge {

inline void WriteZip(const std::string& path, const std::map<std::string, std::string>& files) {
  zip_t* const archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  if (!archive) throw std::runtime_error("no zip " + path);
  for (const auto& [name, text] : files) {
    zip_file_add(archive, name.c_str(), zip_source_buffer(archive, text.data(), text.size(), 0), 0);
  }
  if (zip_close(archive) != 0) throw std::runtime_error("no zip " + path);
}

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_IMPORT_ZIP_OF_H_
