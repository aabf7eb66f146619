#include "tests/support/folders.h"

namespace coppice {

std::string SourceFolder() { return COPPICE_SOURCE_DIR; }
std::string BinaryFolder() { return COPPICE_BINARY_DIR; }

}  // namespace coppice
