// The files in a zip, read without unpacking them to the disk.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_ZIP_ARCHIVE_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_ZIP_ARCHIVE_H_

#include <memory>
#include <optional>
#include <string>

#include "bt_core/base/diagnostic.h"
#include "robot_app/knowledge/import/csv_table.h"

struct zip;

namespace coppice::robot::knowledge {

class ZipArchive {
 public:
  /// A file that unpacks to more is refused.
  static constexpr std::uint64_t kLargest = std::uint64_t{4} << 30;  // bytes

  /// Nothing, with an error, if it is no zip.
  static std::optional<ZipArchive> Open(const std::string& path, Diagnostics& diagnostics);

  bool Has(const std::string& name) const;
  /// Read from its beginning, while the archive lives. What is damaged in it is an error when the
  /// reader comes to it; then the source ends.
  std::optional<ByteSource> Read(const std::string& name, Diagnostics& diagnostics) const;
  /// As it is named in diagnostics.
  std::string NameOf(const std::string& name) const { return path_ + "/" + name; }

 private:
  ZipArchive(std::string path, zip* archive);

  std::string path_;
  std::unique_ptr<zip, void (*)(zip*)> archive_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_ZIP_ARCHIVE_H_
