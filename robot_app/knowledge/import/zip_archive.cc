#include "robot_app/knowledge/import/zip_archive.h"

#include <zip.h>

namespace coppice::robot::knowledge {
namespace {

std::string TextOf(int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

}  // namespace

ZipArchive::ZipArchive(std::string path, zip* archive)
    : path_(std::move(path)), archive_(archive, zip_discard) {}

std::optional<ZipArchive> ZipArchive::Open(const std::string& path, Diagnostics& diagnostics) {
  int code = 0;
  zip* const archive = zip_open(path.c_str(), ZIP_RDONLY, &code);
  if (archive) return ZipArchive(path, archive);
  diagnostics.Error({path, 0, 0}, "expected a zip: " + TextOf(code));
  return std::nullopt;
}

bool ZipArchive::Has(const std::string& name) const {
  return zip_name_locate(archive_.get(), name.c_str(), 0) >= 0;
}

std::optional<ByteSource> ZipArchive::Read(const std::string& name,
                                           Diagnostics& diagnostics) const {
  zip_stat_t stat;
  if (zip_stat(archive_.get(), name.c_str(), 0, &stat) != 0) {
    diagnostics.Error({path_, 0, 0}, "expected a file " + name + " in it");
    return std::nullopt;
  }
  if ((stat.valid & ZIP_STAT_SIZE) == 0 || stat.size > kLargest) {
    diagnostics.Error({NameOf(name), 0, 0}, "expected at most 4 GiB");
    return std::nullopt;
  }
  const std::shared_ptr<zip_file_t> file(zip_fopen(archive_.get(), name.c_str(), 0),
                                         [](zip_file_t* open) {
                                           if (open) zip_fclose(open);
                                         });
  if (!file) {
    diagnostics.Error({NameOf(name), 0, 0}, zip_strerror(archive_.get()));
    return std::nullopt;
  }
  return [file, where = NameOf(name), &diagnostics](char* buffer, std::size_t size) {
    const zip_int64_t count = zip_fread(file.get(), buffer, size);
    if (count < 0) diagnostics.Error({where, 0, 0}, zip_file_strerror(file.get()));
    return count < 0 ? std::size_t{0} : static_cast<std::size_t>(count);
  };
}

}  // namespace coppice::robot::knowledge
